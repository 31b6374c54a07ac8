#include "integrate/slope_domain.hpp"

#include "integrate/ray_charts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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

  void operator()(std::size_t chart, std::span<const double> x, std::span<const double> y, ChartPoints& points) const {
    const double side = chart < chart_count ? 1 : -1;
    if (chart % chart_count == inside)
      write_inside(side, x, y, points);
    else
      write_beyond(side, chart % chart_count == outside, x, y, points);
  }

private:
  void write_inside(double side, std::span<const double> x, std::span<const double> y, ChartPoints& points) const {
    double cos_y = 1, sin_y = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (k == 0 || y[k] != y[k - 1]) {
        cos_y = std::cos(y[k]);
        sin_y = std::sin(y[k]);
      }
      const double q = x[k] * (2 - x[k]);
      const double r = (1 - x[k]) * std::sqrt(spread / q);
      points.u1[k] = r * cos_y;
      points.u2[k] = side * r * sin_y;
      points.area[k] = copies_ * spread * (1 - x[k]) / (q * q);
    }
  }

  void write_beyond(double side, bool is_outside, std::span<const double> x, std::span<const double> y,
                    ChartPoints& points) const {
    /// What depends on x alone, which is the same in all rows of a rule.
    struct Column {
      double x, from, width, r, area;
    };
    const auto column_at = [&](double at) -> Column {
      const double t = scale_ * (1 - at) / at;
      const double horizon = std::atan(t / a_);
      double from = below_ ? std::numbers::pi - horizon : horizon;
      double to = std::numbers::pi;
      if (kink_) (is_outside ? to : from) = std::numbers::pi - horizon;
      return {at, from, to - from, std::hypot(a_, t), copies_ * (to - from) * t * scale_ / (at * at)};
    };
    std::vector<Column> columns;
    const auto width =
        static_cast<std::size_t>(std::ranges::find_if(y, [&](double v) { return v != y[0]; }) - y.begin());
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (k < width) columns.push_back(column_at(x[k]));
      const Column& known = columns[k % width];
      const Column column = known.x == x[k] ? known : column_at(x[k]);
      const double psi = column.from + column.width * y[k];
      points.u1[k] = column.r * std::cos(psi);
      points.u2[k] = side * column.r * std::sin(psi);
      points.area[k] = column.area;
    }
  }

  enum : std::size_t { inside, outside, behind, chart_count };
  /// r = (1 - x) sqrt(spread / q), q = x (2 - x) = 1 - (1 - x)^2: smooth in r at the centre, and for distributions of
  /// unit roughness, Gaussian to long-tailed, nearly a polynomial. Infinity is at x = 0, where numbers are dense.
  static constexpr double spread = 6;
  double a_, scale_;
  bool below_, kink_;
  double copies_;
};

/// Over rays. Where nodes came upon sectors that were overlooked, once more with these cut out.
ColourEstimate integrate_rays(const SlopeFrame& frame, const NormalIntegrand& f, std::size_t channels,
                              RayCharts& charts, double tolerance) {
  std::vector<Rectangle> rectangles = charts.rectangles();
  std::size_t evaluations = 0;
  for (int times = 1;; ++times) {
    ColourEstimate estimate = integrate_charts(frame, f, channels, charts, rectangles, tolerance);
    evaluations += estimate.evaluations;
    estimate.evaluations = evaluations;
    constexpr int most_times = 3;
    if (!charts.has_overlooked() || times == most_times) return estimate;
    std::vector<Rectangle> finer = charts.rectangles();
    if (finer.size() == rectangles.size()) return estimate;
    rectangles = std::move(finer);
  }
}

Estimate integrate_charts_facing(const SlopeFrame& frame, const FacingIntegrand& f, double tolerance) {
  if (f.switches.empty() && frame.radii().empty()) {
    FacingCharts charts(frame, f);
    return integrate_charts(frame, f.value, 1, charts, charts.rectangles(), tolerance).channel(0);
  }
  const auto facing = [&](double cos_psi, double sin_psi) { return frame.facing(cos_psi, sin_psi); };
  RayCharts charts(frame, f.switches, facing, f.symmetric, false);
  return integrate_rays(frame, f.value, 1, charts, tolerance).channel(0);
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
  return integrate_rays(frame, f.value, f.channels, charts, tolerance);
}

} // namespace brdfplot
