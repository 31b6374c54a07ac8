#include "materials.hpp"

#include "analysis/integrals.hpp"
#include "analysis/weight_moments.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

using namespace test;

namespace {

/// Of the weights: their variance over the square of their mean, of all samples and of those above the horizon.
struct Relative {
  double all, above;
};

/// The reciprocal Phong model, (n + 2) / (2 pi) cos^n of the angle from the mirrored viewer, drawn by the density that
/// its lobe is: weights are cos theta_i but for a factor, and 0 below the horizon (Lafortune and Willems 1994). By the
/// midpoint rule in the numbers that the lobe is drawn by.
Relative phong(double theta, double n) {
  constexpr int steps = 700;
  double seen = 0, first = 0, second = 0;
  for (int j = 0; j < steps; ++j) {
    const double along = std::pow((j + 0.5) / steps, 1 / (n + 1)), across = std::sqrt(1 - along * along);
    for (int k = 0; k < steps; ++k) {
      const double phi = 2 * std::numbers::pi * (k + 0.5) / steps;
      const double z = along * std::cos(theta) + across * std::cos(phi) * std::sin(theta);
      if (z <= 0) continue;
      seen += 1, first += z, second += z * z;
    }
  }
  return {second * steps * steps / (first * first) - 1, second * seen / (first * first) - 1};
}

Relative kelemen(double theta, double m, double seen) {
  TermDescription specular;
  specular.type = specular.name = "kelemen";
  specular.distribution = test::distribution("beckmann", {{"alpha", m}}).distribution;
  const Material material = build(specular);
  const Direction o = from_angles(theta, 0);
  const double albedo = compute_or_throw(Integral::albedo, material, o, 1e-8, 0);
  const double all = weight_variance(material, Sampler(material, "kelemen"), o, 1e-7) / (albedo * albedo);
  return {all, seen * (1 + all) - 1};
}

/// The share of half vectors' samples that are above the horizon.
double share_above(double theta, double m) {
  constexpr int steps = 700;
  int above = 0;
  for (int j = 0; j < steps; ++j) {
    const double t = m * std::sqrt(-std::log1p(-(j + 0.5) / steps)), z = 1 / std::hypot(1, t);
    for (int k = 0; k < steps; ++k) {
      const double phi = 2 * std::numbers::pi * (k + 0.5) / steps;
      const double facing = t * z * std::cos(phi) * std::sin(theta) + z * std::cos(theta);
      above += 2 * facing * z - std::cos(theta) > 0 ? 1 : 0;
    }
  }
  return above / static_cast<double>(steps * steps);
}

} // namespace

TEST_CASE("the report's table of Phong's sampling beside Kelemen and Szirmay-Kalos' is what the formulas give") {
  std::ifstream file(BRDFPLOT_SOURCE_DIR "/configs/reports/sampling_phong.csv");
  std::string line;
  REQUIRE(std::getline(file, line));
  int rows = 0;
  double least = infinity, most = 0;
  for (; std::getline(file, line); ++rows) {
    std::replace(line.begin(), line.end(), ',', ' ');
    line.erase(line.find("°"), 2);
    std::istringstream cells(line);
    double degrees = 0, n = 0, m = 0, of_phong = 0, of_kelemen = 0, times = 0, phong_above = 0, kelemen_above = 0;
    REQUIRE((cells >> degrees >> n >> m >> of_phong >> of_kelemen >> times >> phong_above >> kelemen_above));
    CAPTURE(line);
    const double theta = degrees * degree;
    const Relative p = phong(theta, 1 / (2 * m * m) - 1), k = kelemen(theta, m, share_above(theta, m));
    CHECK(of_phong == doctest::Approx(p.all).epsilon(0.02));
    CHECK(of_kelemen == doctest::Approx(k.all).epsilon(0.01));
    CHECK(phong_above == doctest::Approx(p.above).epsilon(0.02));
    CHECK(kelemen_above == doctest::Approx(k.above).epsilon(0.03));
    CHECK(times == doctest::Approx(of_phong / of_kelemen).epsilon(0.01));
    least = std::fmin(least, times), most = std::fmax(most, times);
  }
  CHECK(rows == 18);
  // What the caption says: Phong's weights vary more everywhere.
  CHECK(least == doctest::Approx(1.2).epsilon(0.001));
  CHECK(most == doctest::Approx(3.43).epsilon(0.001));
}
