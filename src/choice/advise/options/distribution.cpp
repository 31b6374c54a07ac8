#include "choice/advise/options/distribution.hpp"

#include "microfacet/distributions.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

namespace {

SlopeMap slopes_of(const ModelChoice& choice) {
  return std::visit([](const auto& d) { return d.slopes; }, make_or_throw<Distribution>("distribution", choice));
}

/// The mean of the logarithm of both alphas over the components.
std::array<double, 2> mean_alpha(const WeightedChoices& components) {
  double sum = 0;
  std::array<double, 2> log{};
  for (const WeightedChoice& one : components) {
    const SlopeMap map = slopes_of(one.model);
    sum += one.weight;
    log[0] += one.weight * std::log(map.alpha_x);
    log[1] += one.weight * std::log(map.alpha_y);
  }
  return {std::exp(log[0] / sum), std::exp(log[1] / sum)};
}

std::array<double, 2> alpha_of(const ModelChoice& choice) {
  if (choice.type == "mixture") return mean_alpha(choice.values.components("components"));
  const SlopeMap map = slopes_of(choice);
  return {map.alpha_x, map.alpha_y};
}

bool make_ggx(Draft& draft, const std::string& name) {
  TermDescription* term = draft.find(name);
  if (term == nullptr) return false;
  const std::array<double, 2> alpha = alpha_of(term->distribution);
  ModelChoice ggx{.type = "ggx"};
  for (const char* key : {"correlation", "mean_slope"})
    if (const auto& map = term->distribution.values.map(); map.contains(key))
      ggx.values.set(key, map.find(key)->second);
  if (alpha[0] == alpha[1]) { // NOLINT(clang-diagnostic-float-equal)
    ggx.values.set("alpha", alpha[0]);
  } else {
    ggx.values.set("alpha_x", alpha[0]);
    ggx.values.set("alpha_y", alpha[1]);
  }
  term->distribution = ggx;
  if (term->masking.type == "student_t_fit") term->masking = {.type = "smith"};
  draft.set_free(name, "alpha");
  draft.set_free(name, "weight");
  return true;
}

} // namespace

std::vector<Option> SingleLobe::of(const MaterialDescription& material) {
  static const std::vector<std::string> dearer = {"mixture", "student_t", "gtr", "exponential_power", "custom"};
  std::vector<Option> out;
  for (const TermDescription& term : material.terms) {
    const std::string name = term.name, type = term.distribution.type;
    if (term.type != "mirror" || std::ranges::find(dearer, type) == dearer.end()) continue;
    out.push_back({"lobe of " + name, {{"lobe of " + name + ": GGX (was " + type + ")", [name](Draft& draft) {
                                          return make_ggx(draft, name);
                                        }}}});
  }
  return out;
}

} // namespace brdfplot::choice
