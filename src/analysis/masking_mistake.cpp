#include "analysis/masking_mistake.hpp"

#include "brdf/blocks/surface_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace brdfplot {

namespace {

/// The largest difference of the two G1, of facets that lie level.
double difference(const Microsurface& a, const Microsurface& b) {
  constexpr double degree = std::numbers::pi / 180;
  const Direction level{0, 0, 1};
  double worst = 0;
  for (const double theta : {20.0, 50.0, 70.0, 80.0, 85.0, 88.0})
    for (const double phi : {0.0, 35.0, 90.0}) {
      const Direction o = from_angles(theta * degree, phi * degree);
      worst = std::max(worst, std::fabs(evaluate(a, Quantity::g1, o, std::nullopt, level) -
                                        evaluate(b, Quantity::g1, o, std::nullopt, level)));
    }
  return worst;
}

/// The microsurface with Smith's masking and its roughnesses changed.
Microsurface smith_at(const TermDescription& term, const SlopeMap& slopes, double (*change)(double)) {
  TermDescription other = term;
  other.masking = {.type = "smith"};
  other.shadowing.reset();
  set_parameter(other, "alpha_x", change(slopes.alpha_x));
  set_parameter(other, "alpha_y", change(slopes.alpha_y));
  return build_microsurface(other);
}

} // namespace

std::string masking_mistake(const MaterialDescription& description) {
  if (std::ranges::count_if(description.terms, has_surface) != 1) return {};
  const TermDescription& term = description.terms[term_with_surface(description)];
  const Microsurface surface = build_microsurface(term);
  if (!std::visit([](const auto& d) { return d.shape_invariant; }, surface.distribution)) return {};
  constexpr double same = 1e-6;
  const SlopeMap& slopes = surface.slopes();
  if (difference(surface, smith_at(term, slopes, [](double x) { return x; })) <= 1e3 * same) return {};
  if (difference(surface, smith_at(term, slopes, [](double x) { return x * x; })) <= same)
    return "G1 is Smith's with alpha^2 in the place of alpha";
  if (difference(surface, smith_at(term, slopes, [](double x) { return std::sqrt(x); })) <= same)
    return "G1 is Smith's with sqrt(alpha) in the place of alpha";
  return {};
}

} // namespace brdfplot
