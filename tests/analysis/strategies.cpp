#include "materials.hpp"

#include "analysis/integrals.hpp"
#include "analysis/sampling_check.hpp"
#include "analysis/weight_moments.hpp"
#include "microfacet/distributions/ggx.hpp"
#include "sampling/points.hpp"
#include "sampling/weights.hpp"

#include <doctest/doctest.h>

using namespace test;

namespace {

TermDescription of_type(const std::string& type) {
  TermDescription description;
  description.type = description.name = type;
  return description;
}

Material eon(double roughness) {
  TermDescription description = of_type("eon");
  description.values.set("roughness", roughness);
  description.values.set("albedo", Rgb{0.9, 0.5, 0.2});
  return build(description);
}

/// Kelemen and Szirmay-Kalos' specular part and the matte one that takes what it leaves.
Material kelemen(double m) {
  TermDescription specular = of_type("kelemen"), matte = of_type("complement");
  specular.distribution.type = "beckmann";
  specular.distribution.values.set("alpha", m);
  specular.fresnel = {"schlick", {}};
  specular.fresnel.values.set("f0", 0.04);
  matte.of.push_back(specular);
  matte.values.set("color", Rgb{0.9, 0.5, 0.2});
  return build(MaterialDescription("both", {specular, matte}, true));
}

void check_all(const Material& material, const std::string& strategy) {
  const Sampler sampler(material, strategy);
  SamplingTest test;
  test.significance = sidak(0.01, 5);
  for (const double theta : {0.0, 30.0, 60.0, 85.0, 89.9}) {
    const Direction o = from_angles(theta * degree, 0.4);
    if (!(material.mesosurface().project(o).c > 0)) continue;
    const SamplingFindings found = check_sampling(material, sampler, o, test);
    CAPTURE(material.name);
    CAPTURE(strategy);
    CAPTURE(theta);
    for (const std::string& fault : found.faults(test)) FAIL_CHECK(fault);
  }
}

/// From many samples, with its standard error.
Estimate sampled_variance(const Material& material, const Sampler& sampler, const Direction& o) {
  WeightedSamples drawn;
  constexpr std::size_t n = 200000;
  draw(material, sampler, o, points(PointKind::random, 9, 0, 0, n), drawn);
  double sum = 0, squares = 0, fourth = 0;
  for (std::size_t k = 0; k < n; ++k) sum += drawn.weights[k];
  const double mean = sum / n;
  for (std::size_t k = 0; k < n; ++k) {
    const double d = drawn.weights[k] - mean;
    squares += d * d, fourth += d * d * d * d;
  }
  const double variance = squares / n;
  return {variance, std::sqrt(std::fmax(fourth / n - variance * variance, 0) / n), 0};
}

} // namespace

TEST_CASE("Heitz's map of 2018, EON's lobes and Kelemen and Szirmay-Kalos' parts are drawn by their densities") {
  check_all(material("ggx", 0.5), "heitz_2018");
  check_all(build(general("ggx", 1e-3, 0.4, 0.5, {0.1, 0})), "heitz_2018");
  for (const double roughness : {0.0, 0.3, 1.0}) check_all(eon(roughness), "eon");
  for (const double m : {0.1, 0.4, 0.8}) check_all(kelemen(m), "kelemen");
}

TEST_CASE("strategies are had by what they are made for") {
  const auto has = [](const Material& m, std::size_t term, Strategy strategy) {
    const std::vector<Strategy> all = strategies_of(m.terms[term]);
    return std::ranges::find(all, strategy) != all.end();
  };
  CHECK(has(material("ggx", 0.5), 0, Strategy::heitz_2018));
  CHECK_FALSE(has(material("beckmann", 0.5), 0, Strategy::heitz_2018));
  CHECK(has(eon(0.5), 0, Strategy::eon));
  CHECK(has(kelemen(0.4), 0, Strategy::kelemen));
  CHECK(has(kelemen(0.4), 1, Strategy::kelemen));
  CHECK_FALSE(has(material("ggx", 0.5), 0, Strategy::kelemen));
  CHECK_THROWS_WITH_AS((void)Sampler(material("beckmann", 0.5), "heitz_2018"), doctest::Contains("has no strategy"),
                       InputError);
}

TEST_CASE("Heitz's map keeps its digits at the rim of the disc, seen from near the horizon") {
  for (const double c : {1e-8, 1e-3, 0.5, 1.0})
    for (const double u1 : {0.0, 0.5, 1 - 1e-12, 1 - 0x1p-53})
      for (const double u2 : {0.0, 0.25, 0.5, 0.75, 0.75 + 1e-9}) {
        const double s = std::sqrt((1 - c) * (1 + c));
        const UnitSlope slope = GgxShape::visible_slope_2018(c, s, u1, u2);
        CAPTURE(c);
        CAPTURE(u1);
        CAPTURE(u2);
        CHECK(std::isfinite(slope.facing));
        CHECK(std::isfinite(slope.across));
        CHECK(c + s * slope.facing >= -1e-9 * (1 + std::hypot(slope.facing, slope.across)));
      }
}

TEST_CASE("variances by quadrature are those of many samples, and weights stay within bounds that are known") {
  for (const auto* type : {"ggx", "beckmann"})
    for (const double alpha : {0.1, 0.5})
      for (const auto* strategy : {"half_vector", "visible_normals"})
        for (const double theta : {0.0, 40.0, 75.0}) {
          const Material m = material(type, alpha);
          const Sampler sampler(m, strategy);
          const Direction o = from_angles(theta * degree, 0);
          const Estimate sampled = sampled_variance(m, sampler, o);
          CAPTURE(type);
          CAPTURE(alpha);
          CAPTURE(strategy);
          CAPTURE(theta);
          CHECK(std::fabs(weight_variance(m, sampler, o, 1e-6) - sampled.value) < 5 * sampled.error + 1e-6);
          // G2 / G1 is at most 1, and so is a sum of them.
          if (std::string(strategy) == "visible_normals") CHECK(largest_weight(m, sampler, o) <= 1 + 1e-9);
        }
  // cos theta_i / cos beta < 2 (Kelemen and Szirmay-Kalos 2001, section 2.1.4).
  TermDescription specular = of_type("kelemen");
  specular.distribution.type = "beckmann";
  for (const double m : {0.1, 0.4, 0.8}) {
    specular.distribution.values.set("alpha", m);
    const Material material = build(specular);
    const Sampler sampler(material, "half_vector");
    for (const double theta : {0.0, 45.0, 80.0, 89.0})
      CHECK(largest_weight(material, sampler, from_angles(theta * degree, 0)) < 2);
  }
}
