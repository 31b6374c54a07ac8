#include "materials.hpp"

#include "microfacet/visible_normals.hpp"
#include "simulation/smith_profile.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace test;

namespace {

/// Pearson's statistic of counts against expected ones, in standard deviations from its mean; bins of few are pooled.
double chi_squared_score(const std::vector<double>& expected, const std::vector<double>& counts) {
  double statistic = 0, bins = -1, rest_expected = 0, rest = 0;
  const auto add = [&](double e, double n) { statistic += (n - e) * (n - e) / e, bins += 1; };
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (expected[k] >= 10)
      add(expected[k], counts[k]);
    else
      rest_expected += expected[k], rest += counts[k];
  }
  if (rest_expected >= 10) add(rest_expected, rest);
  return (statistic - bins) / std::sqrt(2 * bins);
}

/// Samples of D_v in cells of theta and phi against the integral of <v, m> D / sigma over each.
template <class Shape>
void check_visible_normals(const SlopeMap& slopes, const Direction& v) {
  constexpr int samples = 100000, thetas = 12, phis = 12, fine = 24;
  const simulation::SmithProfile<Shape> profile{slopes};
  std::vector<double> expected(thetas * phis, 0), counts(thetas * phis, 0);
  for (int t = 0; t < thetas * fine; ++t)
    for (int p = 0; p < phis * fine; ++p) {
      const double theta = (t + 0.5) / (thetas * fine) * std::numbers::pi / 2;
      const Direction m = from_angles(theta, (p + 0.5) / (phis * fine) * 2 * std::numbers::pi);
      const double solid_angle = std::sin(theta) * std::numbers::pi * std::numbers::pi / (thetas * fine * phis * fine);
      expected[static_cast<std::size_t>(t / fine * phis + p / fine)] +=
          samples * std::max(0.0, dot(v, m)) * profile.density(m) / profile.sigma(v) * solid_angle;
    }
  double total = 0;
  for (const double e : expected) total += e;
  CHECK(total == doctest::Approx(samples).epsilon(2e-3));
  Random random(11, 0);
  bool all_visible = true;
  for (int k = 0; k < samples; ++k) {
    const Direction m = sample_visible_normal<Shape>(slopes, v, random);
    all_visible = all_visible && dot(v, m) > 0;
    const double phi = std::atan2(m.y, m.x);
    const double turn = (phi < 0 ? phi + 2 * std::numbers::pi : phi) / (2 * std::numbers::pi);
    const int t = std::min(static_cast<int>(std::acos(m.z) / (std::numbers::pi / 2) * thetas), thetas - 1);
    counts[static_cast<std::size_t>(t * phis + std::min(static_cast<int>(turn * phis), phis - 1))] += 1;
  }
  CHECK(all_visible);
  CHECK(chi_squared_score(expected, counts) < 5);
}

} // namespace

TEST_CASE("visible slopes of a Gaussian profile have their distribution at any angle") {
  // The part beyond x is a sqrt(pi)/2 erfc(x) + e^(-x^2)/2, from x = -a on.
  for (const double a : {30.0, 2.0, 0.5, 1e-3, 0.0, -0.4, -0.74, -0.76, -1.5, -3.0}) {
    CAPTURE(a);
    const auto beyond = [a](double x) {
      return 0.5 * (a * std::sqrt(std::numbers::pi) * std::erfc(x) + std::exp(-x * x));
    };
    constexpr int samples = 100000, bins = 64;
    std::vector<double> counts(bins, 0);
    Random random(5, 0);
    bool all_facing = true;
    for (int k = 0; k < samples; ++k) {
      const double x = sample_visible_gaussian(a, random);
      all_facing = all_facing && x >= -a;
      const double u = beyond(x) / beyond(-a);
      counts[std::min<std::size_t>(static_cast<std::size_t>(u * bins), bins - 1)] += 1;
    }
    CHECK(all_facing);
    CHECK(chi_squared_score(std::vector<double>(bins, samples / double{bins}), counts) < 5);
  }
}

TEST_CASE("visible normals have the density <v, m> D / sigma, from above and from below") {
  const SlopeMap isotropic{.alpha_x = 0.5, .alpha_y = 0.5};
  const SlopeMap general{.alpha_x = 0.4, .alpha_y = 0.9, .correlation = 0.6, .mean_x = 0.2, .mean_y = -0.1};
  for (const SlopeMap& slopes : {isotropic, general})
    for (const double theta : {0.0, 50.0, 85.0, 95.0, 120.0}) {
      CAPTURE(theta);
      const Direction v = from_angles(theta * degree, 0.7);
      check_visible_normals<BeckmannShape>(slopes, v);
      check_visible_normals<GgxShape>(slopes, v);
    }
}
