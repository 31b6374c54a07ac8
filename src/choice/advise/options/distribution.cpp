#include "choice/advise/options/distribution.hpp"

#include "microfacet/distributions.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

namespace {

SlopeMap slopes_of(const ModelChoice& choice) {
  return std::visit([](const auto& d) { return d.slopes; }, make_or_throw<Distribution>("distribution", choice));
}

/// The slopes that one lobe in the place of a mixture starts from: the mean slope, and alphas that are the mean of the
/// logarithm of the components', wider as the mean slopes of these are apart: Gaussian slopes of alpha about means that
/// vary by s^2 have alpha^2 + 2 s^2.
SlopeMap lobe_of(const ModelChoice& choice) {
  SlopeMap lobe = slopes_of(choice);
  if (choice.type != "mixture") return lobe;
  double sum = 0, log_x = 0, log_y = 0, correlation = 0, xx = 0, yy = 0, xy = 0;
  for (const WeightedChoice& one : choice.values.components("components")) {
    const SlopeMap map = slopes_of(one.model);
    const double x = map.mean_x - lobe.mean_x, y = map.mean_y - lobe.mean_y;
    sum += one.weight;
    log_x += one.weight * std::log(map.alpha_x);
    log_y += one.weight * std::log(map.alpha_y);
    correlation += one.weight * map.correlation;
    xx += one.weight * x * x;
    yy += one.weight * y * y;
    xy += one.weight * x * y;
  }
  const double alpha_x = std::exp(log_x / sum), alpha_y = std::exp(log_y / sum);
  lobe.alpha_x = xx > 0 ? std::sqrt(alpha_x * alpha_x + 2 * xx / sum) : alpha_x;
  lobe.alpha_y = yy > 0 ? std::sqrt(alpha_y * alpha_y + 2 * yy / sum) : alpha_y;
  lobe.correlation = (correlation / sum * alpha_x * alpha_y + 2 * xy / sum) / (lobe.alpha_x * lobe.alpha_y);
  return lobe;
}

bool make_ggx(Draft& draft, const std::string& name) {
  TermDescription* term = draft.find(name);
  if (term == nullptr) return false;
  const SlopeMap lobe = lobe_of(term->distribution);
  ModelChoice ggx{.type = "ggx"};
  if (lobe.correlation != 0) ggx.values.set("correlation", lobe.correlation);
  if (!lobe.centred()) ggx.values.set("mean_slope", Vec2{lobe.mean_x, lobe.mean_y});
  if (lobe.alpha_x == lobe.alpha_y) { // NOLINT(clang-diagnostic-float-equal)
    ggx.values.set("alpha", lobe.alpha_x);
  } else {
    ggx.values.set("alpha_x", lobe.alpha_x);
    ggx.values.set("alpha_y", lobe.alpha_y);
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
