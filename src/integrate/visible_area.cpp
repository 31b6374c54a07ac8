#include "integrate/visible_area.hpp"

#include "math/atan_deficit.hpp"
#include "math/gauss_kronrod.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

namespace brdfplot {

namespace {

constexpr std::size_t near_count = 31; ///< nodes of the first integral
constexpr std::size_t far_count = 61;  ///< and of the second
constexpr double largest_slope = 1e65; ///< of which a density is still right

/// The first integrand without its density: r^2 = 6 (1 - x) / x, under which distributions of unit roughness, Gaussian
/// to long-tailed, are nearly polynomials. Infinity is at x = 0, where numbers are dense.
struct NearMap {
  static constexpr double spread = 6;
  static double slope(double x) { return std::sqrt(spread * (1 - x) / x); }
  static double weight(double x) { return std::numbers::pi * spread / (x * x); }
};

/// The second one, over s = t / a = scale (1 - x) / x; its weight lacks a^3.
struct FarMap {
  double scale;
  double s(double x) const { return scale * (1 - x) / x; }
  double weight(double x) const { return 2 * s(x) * s(x) * atan_deficit(s(x)) * scale / (x * x); }
};

template <std::size_t N>
struct Nodes {
  std::array<double, N> slope, weight; ///< slope: r, or sqrt(1 + s^2)
};

const Nodes<near_count>& near_nodes() {
  static const Nodes<near_count> nodes = [] {
    Nodes<near_count> made;
    for (std::size_t k = 0; k < near_count; ++k) {
      const double x = 0.5 + 0.5 * GaussKronrod<near_count>::rule().x[k];
      made.slope[k] = NearMap::slope(x);
      made.weight[k] = 0.5 * NearMap::weight(x);
    }
    return made;
  }();
  return nodes;
}

/// Scales are powers of 2^(1/4), so that there are few of them: the integrand has its mass at t ~ mass hypot(1, a).
/// They serve from a = 2e-6 on.
constexpr int scale_count = 80;
constexpr double mass = 2.35;

int scale_of(double a) { return static_cast<int>(std::lround(4 * std::log2(mass * std::hypot(1.0, 1 / a)))); }

const Nodes<far_count>& far_nodes(int scale) {
  static const std::array<Nodes<far_count>, scale_count> all = [] {
    std::array<Nodes<far_count>, scale_count> made;
    for (int j = 0; j < scale_count; ++j) {
      const FarMap map{std::exp2(0.25 * j)};
      auto& nodes = made[static_cast<std::size_t>(j)];
      for (std::size_t k = 0; k < far_count; ++k) {
        const double x = 0.5 + 0.5 * GaussKronrod<far_count>::rule().x[k];
        nodes.slope[k] = std::hypot(1.0, map.s(x));
        nodes.weight[k] = 0.5 * map.weight(x);
      }
    }
    return made;
  }();
  return all[static_cast<std::size_t>(scale)];
}

/// P(r) = D z_m^4 / |d^2 u / d^2 m~|, at n slopes along the viewer's azimuth.
class Density {
public:
  Density(const Distribution& distribution, const SlopeFrame& frame) : distribution_(distribution), frame_(frame) {}

  void operator()(const double* r, double* p, std::size_t n) const {
    constexpr std::size_t most = far_count;
    std::array<double, most> x, y, z;
    frame_.normals_along(r, x.data(), y.data(), z.data(), n);
    std::visit([&](const auto& d) { d.densities({x.data(), y.data(), z.data()}, p, n); }, distribution_);
    for (std::size_t k = 0; k < n; ++k) p[k] *= frame_.determinant() * (z[k] * z[k]) * (z[k] * z[k]);
  }

private:
  const Distribution& distribution_;
  const SlopeFrame& frame_;
};

/// What one rule says, of integrands that are analytic, but with poles near an end of their range, which make the last
/// coefficients fall slowly and the rules' errors as fast as ever: QUADPACK's error (Piessens et al. 1983), which
/// scales the difference of the two rules by how well they converge, and what the last coefficients make one expect at
/// twice their degree. Both of its rules may agree by accident to more digits than either has; measured over random
/// materials that happens below 3e-11 of the integral.
template <std::size_t N>
Estimate by_rule(const std::array<double, N>& values) {
  const RuleSums sums = apply_rule<N>(values);
  if (!(sums.magnitude > 0)) return {sums.kronrod, 0, N};
  const double gap = std::min(1.0, 200 * sums.gap / sums.magnitude);
  const double last = std::max(sums.last, sums.next_to_last) / sums.magnitude;
  return {sums.kronrod, sums.magnitude * std::max({gap * std::sqrt(gap), last * last, 1e-10}), N};
}

Estimate near_by_rule(const Density& density) {
  const auto& nodes = near_nodes();
  std::array<double, near_count> values;
  density(nodes.slope.data(), values.data(), near_count);
  for (std::size_t k = 0; k < near_count; ++k) values[k] *= nodes.weight[k];
  return by_rule<near_count>(values);
}

Estimate far_by_rule(const Density& density, double a) {
  const auto& nodes = far_nodes(scale_of(a));
  std::array<double, far_count> slopes, values;
  for (std::size_t k = 0; k < far_count; ++k) slopes[k] = a * nodes.slope[k];
  density(slopes.data(), values.data(), far_count);
  // Up to t ~ a the weight is another function than beyond, of which the rule sees nothing where a is small: 2 a^3 of
  // the density there, or less. Between, where it sees a part of it, up to 2e-10, as measured over a.
  const double near_a = a < 0.05 ? values.back() * std::min(2 * a * a * a, 2e-10) : 0;
  for (std::size_t k = 0; k < far_count; ++k) values[k] *= nodes.weight[k] * a * a * a;
  Estimate estimate = by_rule<far_count>(values);
  estimate.error += near_a;
  return estimate;
}

/// Ascending, with 0 and 1.
std::vector<double> put_in_order(std::vector<double> cuts) {
  cuts.insert(cuts.end(), {0, 1});
  std::ranges::sort(cuts);
  return cuts;
}

Estimate near_adaptive(const Density& density, const std::vector<double>& radii, double tolerance) {
  const auto f = [&](const double* x, double* y, std::size_t n) {
    std::array<double, near_count> r{};
    for (std::size_t k = 0; k < n; ++k) r[k] = NearMap::slope(x[k]);
    density(r.data(), y, n);
    for (std::size_t k = 0; k < n; ++k) y[k] = y[k] > 0 ? y[k] * NearMap::weight(x[k]) : 0;
  };
  std::vector<double> cuts;
  for (const double r : radii) cuts.push_back(NearMap::spread / (NearMap::spread + r * r));
  return integrate(f, put_in_order(std::move(cuts)), {.absolute = tolerance, .relative = 1e-14});
}

Estimate far_adaptive(const Density& density, const std::vector<double>& radii, double a, double tolerance) {
  const double scale = mass * std::hypot(a, 1.0);
  const auto f = [&](const double* x, double* y, std::size_t n) {
    std::array<double, near_count> r{}, t{};
    for (std::size_t k = 0; k < n; ++k) {
      t[k] = scale * (1 - x[k]) / x[k];
      r[k] = std::hypot(a, t[k]);
    }
    density(r.data(), y, n);
    for (std::size_t k = 0; k < n; ++k)
      y[k] = y[k] > 0 ? y[k] * 2 * t[k] * t[k] * atan_deficit(t[k] / a) * scale / (x[k] * x[k]) : 0;
  };
  std::vector<double> cuts = {scale / (scale + 8 * a)}; // the weight changes its nature at t ~ a
  for (const double r : radii)
    if (r > a) cuts.push_back(scale / (scale + std::sqrt((r - a) * (r + a))));
  return integrate(f, put_in_order(std::move(cuts)), {.absolute = tolerance, .relative = 1e-14});
}

/// Replaces an estimate by a better one.
template <class Better>
void improve(Estimate& estimate, const Better& better) {
  const std::size_t spent = estimate.evaluations;
  estimate = better();
  estimate.evaluations += spent;
}

} // namespace

Estimate visible_area(const Distribution& distribution, const SlopeFrame& frame, double tolerance) {
  const Density density(distribution, frame);
  const double c = std::fmax(frame.c(), 0);
  const double s = frame.s();
  const double a = std::fabs(frame.a());
  const bool seen_from_aside = a < 1e75; // beyond, Lambda < 1e-149
  const std::vector<double>& radii = frame.radii();
  Estimate all = c > 0 && radii.empty() ? near_by_rule(density) : Estimate{0, c > 0 ? infinity : 0, 0};
  Estimate negative{0, seen_from_aside ? infinity : 0, 0};
  if (radii.empty() && seen_from_aside && a > 1e-6 && scale_of(a) < scale_count) negative = far_by_rule(density, a);
  if (!(c * all.error + s * negative.error <= tolerance)) {
    if (c > 0) improve(all, [&] { return near_adaptive(density, radii, 0.5 * tolerance / c); });
    if (seen_from_aside) improve(negative, [&] { return far_adaptive(density, radii, a, 0.5 * tolerance / s); });
  }
  // The weight of the second integral is 2 r^2 far out, and the fourth power of a normal's cosine ends soon after.
  const auto far_out = [&](double r) {
    double p = 0;
    density(&r, &p, 1);
    return 2 * r * (r * p);
  };
  const double tail = seen_from_aside ? power_tail(far_out, largest_slope) : 0;
  return {c * all.value + s * negative.value, c * all.error + s * (negative.error + tail),
          all.evaluations + negative.evaluations};
}

} // namespace brdfplot
