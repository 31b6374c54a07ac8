#include "choice/advise/options/coat.hpp"

#include "choice/advise/options/drop.hpp"

#include <algorithm>
#include <set>

namespace brdfplot::choice {

namespace {

/// Calls `change` with every layer of this name that is over a term.
template <class Change>
bool for_each_layer(Draft& draft, const std::string& name, const Change& change) {
  bool any = false;
  for (TermDescription& term : draft.material.terms)
    for (LayerDescription& layer : term.layers)
      if (layer.name == name) {
        change(layer);
        any = any || !layer.coat.empty();
      }
  return any;
}

std::string attenuation_of(const LayerDescription& layer) {
  return layer.values.has("attenuation") ? layer.values.text("attenuation") : "both";
}

bool attenuate(Draft& draft, const std::string& name, const std::string& how) {
  return for_each_layer(draft, name, [&](LayerDescription& layer) { layer.values.set("attenuation", how); });
}

bool drop_tint(Draft& draft, const std::string& name) {
  return for_each_layer(draft, name, [](LayerDescription& layer) { layer.values.set("tint", 1.0); });
}

/// The factor of the coated term stays with what lay beneath the coat.
void take_off(TermDescription& term, const std::string& name) {
  const auto layer = std::ranges::find(term.layers, name, &LayerDescription::name);
  if (layer == term.layers.end()) return;
  const auto factor = [](const Value& v, std::size_t c) {
    return std::holds_alternative<Rgb>(v) ? std::get<Rgb>(v)[c] : std::get<double>(v);
  };
  const bool is_rgb = std::holds_alternative<Rgb>(layer->weight) || std::holds_alternative<Rgb>(term.weight);
  Rgb weight{};
  for (std::size_t c = 0; c < 3; ++c) weight[c] = factor(layer->weight, c) * factor(term.weight, c);
  term.weight = is_rgb ? Value(weight) : Value(weight[0]);
  term.layers.erase(layer);
}

bool drop_coat(Draft& draft, const std::string& name, const std::string& coat) {
  if (draft.find(coat) == nullptr) return false;
  draft.remove([&](const TermDescription& term) { return term.name == coat; });
  for (TermDescription& term : draft.material.terms) take_off(term, name);
  free_colours(draft);
  return true;
}

Option option_of(const LayerDescription& layer) {
  const std::string name = layer.name, coat = layer.coat, part = "coat " + name;
  Option option{part, {}};
  const std::vector<std::string> ways = {"both", "half", "none"};
  const auto given = std::ranges::find(ways, attenuation_of(layer)); // half_vector and albedo have but none after them
  for (auto way = given == ways.end() ? ways.end() - 1 : given + 1; way < ways.end(); ++way)
    option.steps.push_back({part + ": attenuation " + *way + " (was " + attenuation_of(layer) + ")",
                            [name, how = *way](Draft& d) { return attenuate(d, name, how); }});
  option.steps.push_back({part + ": left out", [name, coat](Draft& d) { return drop_coat(d, name, coat); }});
  return option;
}

} // namespace

std::vector<Option> LighterCoat::of(const MaterialDescription& material) {
  std::vector<Option> out;
  std::set<std::string> seen;
  for (const TermDescription& term : material.terms)
    for (const LayerDescription& layer : term.layers) {
      if (layer.coat.empty() || !seen.insert(layer.name).second) continue;
      out.push_back(option_of(layer));
      const std::string name = layer.name;
      if (layer.values.has("tint") && layer.values.rgb("tint") != Rgb{1, 1, 1})
        out.push_back(
            {"tint of " + name, {{"tint of " + name + ": none", [name](Draft& d) { return drop_tint(d, name); }}}});
    }
  return out;
}

} // namespace brdfplot::choice
