#include "integrate/slope_domain.hpp"

#include "integrate/ray_charts.hpp"

#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

/// The charts of integrate_facing(). Of slopes that are seen from below, a <= 0, none within r < |a| faces the viewer.
class FacingCharts {
public:
  FacingCharts(const SlopeFrame& frame, const FacingIntegrand& f)
      : a_(std::fabs(frame.a())), scale_(2 * std::hypot(1.0, a_)), below_(frame.a() <= 0), kink_(f.kink),
        copies_(f.symmetric ? 2 : 1) {}

  std::vector<Rectangle> rectangles() const {
    std::vector<Rectangle> all;
    const double rim = a_ == infinity ? 0 : spread / (spread + a_ * a_ + a_ * std::hypot(std::sqrt(spread), a_));
    for (std::size_t mirrored = 0; mirrored < (copies_ == 2 ? 1U : 2U); ++mirrored) {
      const std::size_t base = mirrored * chart_count;
      if (!below_) all.push_back({rim, 1, 0, std::numbers::pi, base + inside});
      if (a_ == infinity) continue;
      all.push_back({0, 1, 0, 1, base + outside});
      if (kink_) all.push_back({0, 1, 0, 1, base + behind});
    }
    return all;
  }

  ChartPoint operator()(std::size_t chart, double x, double y) const {
    const double side = chart < chart_count ? 1 : -1;
    if (chart % chart_count == inside) {
      const double q = x * (2 - x);
      const double r = (1 - x) * std::sqrt(spread / q);
      return {r * std::cos(y), side * r * std::sin(y), copies_ * spread * (1 - x) / (q * q)};
    }
    const double t = scale_ * (1 - x) / x;
    const double horizon = std::atan(t / a_);
    double from = below_ ? std::numbers::pi - horizon : horizon;
    double to = std::numbers::pi;
    if (kink_) (chart % chart_count == outside ? to : from) = std::numbers::pi - horizon;
    const double psi = from + (to - from) * y;
    const double r = std::hypot(a_, t);
    return {r * std::cos(psi), side * r * std::sin(psi), copies_ * (to - from) * t * scale_ / (x * x)};
  }

private:
  enum : std::size_t { inside, outside, behind, chart_count };
  /// r = (1 - x) sqrt(spread / q), q = x (2 - x) = 1 - (1 - x)^2: smooth in r at the centre, and for distributions of
  /// unit roughness, Gaussian to long-tailed, nearly a polynomial. Infinity is at x = 0, where numbers are dense.
  static constexpr double spread = 6;
  double a_, scale_;
  bool below_, kink_;
  double copies_;
};

Estimate integrate_charts_facing(const SlopeFrame& frame, const FacingIntegrand& f, double tolerance) {
  if (f.switches.empty()) {
    const FacingCharts charts(frame, f);
    return integrate_charts(frame, f.value, 1, charts, charts.rectangles(), tolerance).channel(0);
  }
  const auto facing = [&](double cos_psi, double sin_psi) { return frame.facing(cos_psi, sin_psi); };
  RayCharts charts(frame, f.switches, facing, f.symmetric, false);
  const auto rectangles = charts.rectangles();
  const auto chart = [&](std::size_t index, double x, double y) { return charts(index, x, y); };
  return integrate_charts(frame, f.value, 1, chart, rectangles, tolerance).channel(0);
}

} // namespace

Estimate integrate_facing(const SlopeFrame& frame, const FacingIntegrand& f, double tolerance) {
  Estimate estimate = integrate_charts_facing(frame, f, tolerance);
  // Slopes that fall slowly go on beyond those that integrate_charts() sees; away from the viewer most of all.
  const auto away = [&](double r) {
    const std::vector<Direction> normal = {frame.normal(-r, 0)};
    std::vector<double> value(1);
    f.value(normal, value);
    return value[0] * frame.jacobian(normal[0]) * r;
  };
  constexpr double largest_slope = 1e65;
  estimate.error += 2 * std::numbers::pi * power_tail(away, largest_slope);
  return estimate;
}

ColourEstimate integrate_lit(const SlopeFrame& frame, const LitIntegrand& f, double tolerance) {
  const auto lit = [&](double cos_psi, double sin_psi) { return frame.lit(cos_psi, sin_psi); };
  RayCharts charts(frame, f.switches, lit, f.symmetric, f.kink_in_plane_of_incidence);
  const auto rectangles = charts.rectangles();
  const auto chart = [&](std::size_t index, double x, double y) { return charts(index, x, y); };
  return integrate_charts(frame, f.value, f.channels, chart, rectangles, tolerance);
}

} // namespace brdfplot
