#include "choice/advise/options/anisotropy.hpp"

#include <cmath>

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
  bool sheared = false;
  for (const TermDescription& term : material.terms) sheared = sheared || term.distribution.values.has("mean_slope");
  if (!sheared) return {};
  return {{"mean slope", {{"mean slope: none", [](Draft& draft) {
                             bool changed = false;
                             for (TermDescription& term : draft.material.terms) {
                               changed = changed || term.distribution.values.has("mean_slope");
                               term.distribution.values = without(term.distribution.values, {"mean_slope"});
                             }
                             return changed;
                           }}}}};
}

} // namespace brdfplot::choice
