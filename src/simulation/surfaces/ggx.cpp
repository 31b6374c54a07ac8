#include "simulation/surfaces/ggx.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::simulation {

namespace {

/// g(f) = int_0^f g', odd, as a table over x = sqrt(|f|).
class HeightFunction {
public:
  explicit HeightFunction(double most) : step_(std::sqrt(most) / static_cast<double>(intervals)) {
    values_.reserve(intervals + 1);
    values_.push_back(0);
    for (std::size_t k = 0; k < intervals; ++k) {
      const double x = static_cast<double>(k) * step_;
      // Gauss' rule of two points.
      constexpr double gap = 0.5 * std::numbers::inv_sqrt3;
      values_.push_back(values_.back() +
                        step_ / 2 * (integrand(x + step_ * (0.5 - gap)) + integrand(x + step_ * (0.5 + gap))));
    }
  }

  double operator()(double f) const {
    const double x = std::min(std::sqrt(std::fabs(f)) / step_, static_cast<double>(intervals) * (1 - 1e-12));
    const auto k = static_cast<std::size_t>(x);
    const double part = x - static_cast<double>(k);
    return std::copysign(values_[k] + part * (values_[k + 1] - values_[k]), f);
  }

private:
  static constexpr std::size_t intervals = 1U << 16;

  /// g'(f) df/dx at f = x^2: 1 / sqrt(-ln F), F = erf(f / sqrt 2), by its complement
  /// where it is near 1.
  static double integrand(double x) {
    const double f = x * x / std::numbers::sqrt2;
    const double m = f < 0.5 ? -std::log(std::erf(f)) : -std::log1p(-std::erfc(f));
    return 2 * x / std::sqrt(m);
  }

  double step_;
  std::vector<double> values_;
};

/// The radius of the unit shape within which half of the facets' slopes lie; 1 for GGX.
double median_radius(const HeightField& field, const SlopeMap& slopes) {
  std::vector<double> radii;
  radii.reserve(2 * static_cast<std::size_t>(field.nx()) * static_cast<std::size_t>(field.ny()));
  for (int iy = 0; iy < field.ny(); ++iy)
    for (int ix = 0; ix < field.nx(); ++ix)
      for (const bool far : {false, true}) {
        const Slope unit = unit_slope(slopes, field.to_world(field.facet_slope(ix, iy, far)));
        radii.push_back(std::hypot(unit.x, unit.y));
      }
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::ranges::nth_element(radii, middle);
  return *middle;
}

} // namespace

Realisation GgxSurface::realise(std::uint64_t seed, std::uint64_t realisation) const {
  const Field field = gaussian_field(mesh.request(), seed, realisation);
  double most = 0;
  for (const double h : field.heights) most = std::max(most, std::fabs(h) / field.rms_height);
  const HeightFunction g(most);
  std::vector<double> heights(field.heights.size());
  std::ranges::transform(field.heights, heights.begin(),
                         [&](double h) { return field.rms_height * g(h / field.rms_height); });
  // What the cells take from the steepest places is given back to the median.
  const double correction = 1 / median_radius(mesh.mesh({heights.begin(), heights.end()}), mesh.slopes);
  double squares = 0;
  for (double& h : heights) {
    h *= correction;
    squares += h * h;
  }
  Realisation out{{}, std::sqrt(squares / static_cast<double>(heights.size())), mesh.correlation_length};
  out.fields.push_back(mesh.mesh({heights.begin(), heights.end()}));
  return out;
}

} // namespace brdfplot::simulation
