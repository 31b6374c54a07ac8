// Integrals of shapes that users write, with narrow peaks, jumps and corners that only the formula knows of: what holds
// for every distribution holds for them, and what another model gives they give too.
#include "../materials.hpp"
#include "../sample.hpp"
#include "analysis/integrals.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace test;

namespace {

constexpr double asked = 1e-9;

TermDescription with_masking(const std::string& shape, const std::string& masking, bool general_slopes) {
  TermDescription description =
      general_slopes ? general("custom", 0.2, 0.6, -0.5, {0.2, -0.1}, masking) : describe("custom", 0.5, masking);
  description.distribution.values.set("shape", shape);
  return description;
}

Estimate honest(const Estimate& estimate) {
  CHECK(estimate.error <= asked);
  return estimate;
}

} // namespace

TEST_CASE("Eqs. 14, 18, 36 and 37 hold for shapes with rings, jumps, corners and two scales") {
  for (const auto* shape :
       {"exp(-((t - 1) / 0.01)^2)", "exp(-((t - 1) / 0.002)^2)", "exp(-t2) * (1 + 0.5 * exp(-((t - 1) / 0.01)^2))",
        "exp(-t2) + 1000 * exp(-1e4 * t2)", "exp(-t2) + exp(-1e4 * t2)", "t2 < 1 ? 1 : 0", "t2 < 1.00001 ? 1 : 0",
        "max(0, 1 - t2)", "max(exp(-t2), 0.1 * exp(-t2 / 9))", "exp(-t2) + (t < 2 ? 0.1 : 0)"})
    for (const bool general_slopes : {false, true})
      for (const auto* masking : {"smith", "v_cavity"}) {
        const Material m = build(with_masking(shape, masking, general_slopes));
        Material diffuse = m;
        diffuse.terms[0].term = FacetDiffuse{m.surface(), {}};
        for (const double theta : {0.0, 0.8, 1.5}) {
          if (sampled() && (theta != 1.5 || general_slopes)) continue;
          INFO(std::string(shape) << ", " << std::string(masking) << std::string(general_slopes ? ", general" : "")
                                  << ", theta_o = " << theta);
          const Direction o = from_angles(theta, 2.5);
          const double c = m.surface().slopes().project(o).c;
          const Estimate area = compute(Integral::projected_area, m, o, asked);
          CHECK(area.error <= asked * c);
          CHECK(std::fabs(area.value - c) <= area.error + 1e-12);
          for (const Integral integral : {Integral::visible_norm, Integral::weak_furnace}) {
            const Estimate estimate = honest(compute(integral, m, o, asked));
            // Lambda is from a table to 1e-10.
            CHECK(std::fabs(estimate.value - 1) <= estimate.error + 2e-10);
          }
          const Estimate white = honest(compute(Integral::weak_furnace, diffuse, o, asked));
          CHECK(std::fabs(white.value - 1) <= white.error + 2e-10);
        }
      }
}

TEST_CASE("a mixture cuts the integrals of the part that is a ring, and of no other") {
  auto ring = general("custom", 0.5, 0.3, 0.4);
  ring.distribution.values.set("shape", std::string("exp(-((t - 1) / 0.01)^2)"));
  const Material m = build(mixture({{1, ring.distribution}, {3, general("ggx", 0.1, 0.2, 0).distribution}}));
  for (const double theta : {0.0, 0.8, 1.5}) {
    INFO("theta_o = " << theta);
    const Estimate norm = honest(compute(Integral::visible_norm, m, from_angles(theta, 2.5), asked));
    CHECK(std::fabs(norm.value - 1) <= norm.error + 2e-10);
  }
}

TEST_CASE("a shape of two scales is the mixture of the two distributions") {
  // Mass 1 and 1000 / 1e4.
  const auto as_mixture = mixture({{10, general("beckmann", 0.5, 0.3, 0.4).distribution},
                                   {1, general("beckmann", 0.005, 0.003, 0.4).distribution}});
  TermDescription as_shape = general("custom", 0.5, 0.3, 0.4);
  as_shape.distribution.values.set("shape", std::string("exp(-t2) + 1000 * exp(-1e4 * t2)"));
  for (const auto* masking : {"smith", "v_cavity", "kelemen", "implicit"}) {
    TermDescription one = as_shape, other = as_mixture;
    one.masking.type = other.masking.type = masking;
    const Material a = build(one), b = build(other);
    Material diffuse_a = a, diffuse_b = b;
    diffuse_a.terms[0].term = FacetDiffuse{a.surface(), {}};
    diffuse_b.terms[0].term = FacetDiffuse{b.surface(), {}};
    for (const double theta : {0.0, 0.8, 1.5}) {
      INFO(std::string(masking) << ", theta_o = " << theta);
      const Direction o = from_angles(theta, 0.3), i = from_angles(1, 2);
      const Estimate x = honest(compute(Integral::albedo, a, o, asked)), y = compute(Integral::albedo, b, o, asked);
      CHECK(std::fabs(x.value - y.value) <= x.error + y.error + 1e-12);
      CHECK(relative(value(diffuse_a, Quantity::brdf, o, i), value(diffuse_b, Quantity::brdf, o, i)) < 2e-9);
    }
  }
}

TEST_CASE("a disc of slopes that a horizon cuts beside its rim, as diffuse facets") {
  // int over t < 1 of <o,m> <i,m> / (pi c_o c_i) d^2 u, with a Gauss rule of 60 nodes per panel between the cuts.
  TermDescription description = general("custom", 2.9892020990839416, 2.9892020990839416, -0.7737068353875869);
  description.distribution.values.set("shape", std::string("t2 < 1 ? 1 : 0"));
  description.masking = {.type = "custom", .values = {}};
  description.masking.values.set("g1", std::string("1 / (1 + 0.5 * tan_theta)"));
  Material m = build(shadowed(description, "minimum"));
  m.terms[0].term = FacetDiffuse{m.surface(), {}};
  const Direction i = normalized({-0.8569031790234277, 0.05750313701001446, 0.5122600228531901});
  CHECK(relative(value(m, Quantity::brdf, {0, 0, 1}, i), 0.13403422296933257) < 1e-10);
}
