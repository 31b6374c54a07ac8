/// \file
/// A model as JSON names it: its type, and its parameters beside it.
#pragma once

#include "config/schema.hpp"
#include "models/registry.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace brdfplot::config {

/// A model as it stands in JSON that has been checked; `specs` are those of its list.
inline ModelChoice to_choice(const Json& value, const std::vector<ModelSpec>& specs);

inline Value to_value(const Json& value, const ParameterSpec& spec) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return value.get<double>();
  if (value.is_boolean()) return value.get<bool>();
  if (spec.kind == ParameterKind::vec2) return value.get<Vec2>();
  if (spec.kind != ParameterKind::components) return value.get<Rgb>();
  WeightedChoices components;
  for (const Json& item : value)
    components.push_back({item["weight"].get<double>(), to_choice(item["distribution"], spec.models())});
  return components;
}

inline ModelChoice to_choice(const Json& value, const std::vector<ModelSpec>& specs) {
  ModelChoice choice{.type = value["type"].get<std::string>(), .values = {}};
  for (const ModelSpec& spec : specs) {
    if (spec.type != choice.type) continue;
    for (const auto& [key, item] : value.items())
      if (key != "type") choice.values.set(key, to_value(item, *spec.find(key)));
  }
  return choice;
}

template <class List>
ModelChoice to_choice(const Json& value) {
  return to_choice(value, specs_of<List>());
}

} // namespace brdfplot::config
