/// \file
/// A model as JSON names it: its type, and its parameters beside it.
#pragma once

#include "config/schema.hpp"
#include "microfacet/registry.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace brdfplot::config {

inline Value to_value(const Json& value, ParameterKind kind) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return value.get<double>();
  if (kind == ParameterKind::vec2) return value.get<Vec2>();
  return value.get<Rgb>();
}

/// `value` has been checked against model(specs_of<List>()).
template <class List>
ModelChoice to_choice(const Json& value) {
  ModelChoice choice{.type = value["type"].get<std::string>(), .values = {}};
  for (const ModelSpec& spec : specs_of<List>()) {
    if (spec.type != choice.type) continue;
    for (const auto& [key, item] : value.items())
      if (key != "type") choice.values.set(key, to_value(item, spec.find(key)->kind));
  }
  return choice;
}

} // namespace brdfplot::config
