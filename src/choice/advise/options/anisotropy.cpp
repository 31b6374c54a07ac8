#include "choice/advise/options/anisotropy.hpp"

#include <cmath>
#include <utility>

namespace brdfplot::choice {

namespace {

Values without(const Values& values, std::initializer_list<std::string_view> keys) {
  Values out;
  for (const auto& [key, value] : values.map())
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) out.set(key, value);
  return out;
}

bool uncorrelate(Draft& draft, const std::string& name) {
  TermDescription* term = draft.find(name);
  if (term == nullptr || !term->distribution.values.has("correlation")) return false;
  term->distribution.values = without(term->distribution.values, {"correlation"});
  draft.set_free(name, "alpha");
  return true;
}

bool make_isotropic(Draft& draft, const std::string& name) {
  TermDescription* term = draft.find(name);
  if (term == nullptr || !term->distribution.values.has("alpha_x")) return false;
  const Values& values = term->distribution.values;
  const double r = values.has("correlation") ? values.number("correlation") : 0;
  const double area = values.number("alpha_x") * values.number("alpha_y") * std::sqrt((1 - r) * (1 + r));
  Values round = without(values, {"alpha_x", "alpha_y", "correlation"});
  round.set("alpha", std::sqrt(area));
  term->distribution.values = round;
  draft.set_free(name, "alpha");
  return true;
}

/// Leaves the mean slope out, and those of the parts of a mixture. Returns whether there was one.
bool make_level(ModelChoice& distribution) {
  if (distribution.type != "mixture") {
    const bool sheared = distribution.values.has("mean_slope");
    distribution.values = without(distribution.values, {"mean_slope"});
    return sheared;
  }
  WeightedChoices level;
  bool sheared = false;
  for (WeightedChoice part : distribution.values.components("components")) {
    sheared = make_level(part.model) || sheared;
    level.push_back(std::move(part));
  }
  distribution.values.set("components", level);
  return sheared;
}

bool make_level(MaterialDescription& material) {
  bool sheared = false;
  for (TermDescription& term : material.terms)
    if (!term.distribution.type.empty()) sheared = make_level(term.distribution) || sheared;
  return sheared;
}

} // namespace

std::vector<Option> Rounder::of(const MaterialDescription& material) {
  std::vector<Option> out;
  for (const TermDescription& term : material.terms) {
    const std::string name = term.name, part = "D of " + name;
    Option option{part, {}};
    if (term.distribution.values.has("correlation"))
      option.steps.push_back(
          {part + ": without correlation", [name](Draft& draft) { return uncorrelate(draft, name); }});
    if (term.distribution.values.has("alpha_x"))
      option.steps.push_back({part + ": isotropic", [name](Draft& draft) { return make_isotropic(draft, name); }});
    if (!option.steps.empty()) out.push_back(option);
  }
  return out;
}

std::vector<Option> Level::of(const MaterialDescription& material) {
  MaterialDescription level = material;
  if (!make_level(level)) return {};
  return {{"mean slope", {{"mean slope: none", [](Draft& draft) { return make_level(draft.material); }}}}};
}

} // namespace brdfplot::choice
