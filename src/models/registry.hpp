/// \file
/// What a list of models (a variant) yields by itself: their specs, their names, and a model from a choice.
#pragma once

#include "models/parameters.hpp"

#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace brdfplot {

/// The specs of all alternatives of a list, in its order. Made once: they are some hundred strings.
template <class List>
const std::vector<ModelSpec>& specs_of() {
  static const std::vector<ModelSpec> specs = []<std::size_t... I>(std::index_sequence<I...>) {
    return std::vector<ModelSpec>{std::variant_alternative_t<I, List>::spec()...};
  }
  (std::make_index_sequence<std::variant_size_v<List>>{});
  return specs;
}

inline std::vector<std::string> names_of(const std::vector<ModelSpec>& specs) {
  std::vector<std::string> names;
  for (const auto& spec : specs) names.push_back(spec.type);
  return names;
}

/// "a, b and c": the types of the list for whose alternatives `holds`, a generic lambda over std::type_identity, is
/// true. For errors that tell which models declare what is needed.
template <class List, class Predicate>
std::string types_that(const Predicate& holds) {
  std::vector<std::string> types;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    const auto add = [&]<class Model>(std::type_identity<Model> model) {
      if (holds(model)) types.push_back(Model::spec().type);
    };
    (add(std::type_identity<std::variant_alternative_t<I, List>>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<List>>{});
  std::string text;
  for (std::size_t k = 0; k < types.size(); ++k)
    text += (k == 0 ? "" : k + 1 == types.size() ? " and " : ", ") + types[k];
  return text;
}

/// A model, or what is wrong with it, as one of the list.
template <class List, class Model>
Made<List> as_model(Model made) {
  if constexpr (requires { std::get<ParameterError>(made); }) {
    if (auto* error = std::get_if<ParameterError>(&made)) return std::move(*error);
    return List(std::get<0>(std::move(made)));
  } else {
    return List(std::move(made));
  }
}

/// Builds the model that `choice` names, or tells what is wrong with it (key `type` for an unknown name).
template <class List>
Made<List> make_model(const ModelChoice& choice) {
  const std::vector<ModelSpec>& specs = specs_of<List>();
  for (std::size_t index = 0; index < specs.size(); ++index) {
    if (specs[index].type != choice.type) continue;
    auto completed = complete(specs[index], choice.values);
    if (auto* error = std::get_if<ParameterError>(&completed)) return *error;
    const Values& values = std::get<Values>(completed);
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      Made<List> made = ParameterError{};
      (void)((index == I ? (made = as_model<List>(std::variant_alternative_t<I, List>::from(values)), true) : false) ||
             ...);
      return made;
    }
    (std::make_index_sequence<std::variant_size_v<List>>{});
  }
  return ParameterError{"type", unknown_name("type", choice.type, names_of(specs))};
}

} // namespace brdfplot
