// The error estimates of the integrals, over random materials of every kind. BRDFPLOT_RANDOM_CASES sets their number.
#include "../materials.hpp"
#include "analysis/integrals.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <random>
#include <vector>

using namespace test;

namespace {

int case_count(int usual) {
  const char* asked = std::getenv("BRDFPLOT_RANDOM_CASES");
  return asked ? std::atoi(asked) : usual;
}

/// A distribution of any kind and roughness under any masking function, and a viewer down to 0.1 degrees.
struct RandomCase {
  MaterialDescription description;
  Direction o;

  RandomCase(std::mt19937_64& engine, const std::string& masking) {
    std::uniform_real_distribution<double> unit(0, 1);
    const double alpha = 0.005 * std::pow(400, unit(engine));
    const double stretch = std::pow(10, 2 * unit(engine) - 1);
    const int kind = static_cast<int>(8 * unit(engine));
    const auto* type = unit(engine) < 0.5 ? "beckmann" : "ggx";
    if (kind == 0) {
      description = describe("phong", std::min(alpha, 1.0), masking);
    } else if (kind == 1) {
      description = describe("gtr", alpha, masking);
      description.distribution.values.set("gamma", 0.5 + 5 * unit(engine));
    } else {
      const bool correlated = kind >= 4;
      const bool sheared = kind >= 6;
      const Vec2 mean = sheared ? Vec2{0.6 * unit(engine) - 0.3, 0.6 * unit(engine) - 0.3} : Vec2{0, 0};
      description = general(type, alpha, kind == 2 ? alpha : std::clamp(alpha * stretch, 0.005, 2.0),
                            correlated ? 1.8 * unit(engine) - 0.9 : 0, mean, masking);
    }
    o = from_angles(unit(engine) * 89.9 * degree, 6.3 * unit(engine));
  }

  double alpha_x() const { return build(description).slopes().alpha_x; }
};

const std::vector<std::string> maskings = {"smith",         "smith_rational",         "v_cavity", "implicit",
                                           "schlick_smith", "schlick_smith_rational", "kelemen"};

/// int <o,m> D dm over the facing normals: c (1 + Lambda) of Smith, in closed form or by its own quadrature.
double facing_area(MaterialDescription description, const Direction& o) {
  description.masking = {.type = "smith", .values = {}};
  const Material smith = build(description);
  return smith.slopes().project(o).c / g1(smith, o);
}

/// The exact value of Eqs. 18 and 36 (Eq. 13 is c times it).
double exact(const RandomCase& one, const Material& material) {
  if (one.description.masking.type == "smith" || one.description.masking.type == "v_cavity") return 1;
  const double area = facing_area(one.description, one.o);
  if (one.description.masking.type == "implicit") return area;
  if (material.has_lambda()) return g1(material, one.o) / material.slopes().project(one.o).c * area;
  return compute_in_plane(Integral::visible_norm, material, one.o, 1e-12).value; // Kelemen's has no closed form
}

} // namespace

TEST_CASE("Eqs. 13, 18 and 36: the error estimate bounds the true error in random cases") {
  std::mt19937_64 engine(20260);
  const int count = case_count(1000);
  for (int k = 0; k < count; ++k) {
    const RandomCase one(engine, maskings[static_cast<std::size_t>(k) % maskings.size()]);
    const Material material = build(one.description);
    const double c = material.slopes().project(one.o).c;
    if (!(c > 0)) continue;
    const double truth = exact(one, material);
    INFO("case " << k << ": " << material.name << ", " << one.description.masking.type
                 << ", alpha_x = " << one.alpha_x() << ", alpha_y = " << material.slopes().alpha_y << ", c = " << c);
    const double rounding = 1e-13 * truth + 1e-15 / c;
    // What the half vectors of Eq. 36 lose at grazing angles on smooth surfaces cannot be had back.
    const SlopeMap& map = material.slopes();
    const double lost = 2e-15 / (c * std::min(map.alpha_x, map.alpha_y) * map.decorrelation());
    for (const Integral integral : {Integral::projected_area, Integral::visible_norm, Integral::weak_furnace})
      for (const double tolerance : {1e-5, 1e-9}) {
        const double scale = integral == Integral::projected_area ? c : 1;
        const Estimate plane = compute_in_plane(integral, material, one.o, tolerance);
        CHECK(std::fabs(plane.value / scale - truth) <= plane.error / scale + rounding);
        CHECK(plane.error <= tolerance * scale + lost);
        const Estimate line = compute(integral, material, one.o, tolerance);
        CHECK(std::fabs(line.value / scale - truth) <= line.error / scale + rounding);
        CHECK(line.error <= tolerance * scale + lost);
      }
  }
}

TEST_CASE("albedos: the error estimate bounds the true error in random cases") {
  std::mt19937_64 engine(20261);
  const std::vector<std::vector<std::string>> shadowings = {
      {"none", ""},
      {"separable", ""},
      {"minimum", ""},
      {"direction_correlated", "ginneken"},
      {"direction_correlated", "ashikhmin"},
      {"direction_correlated", "fitted"},
      {"height_correlated", ""},
      {"height_direction_correlated", "ginneken"},
      {"height_direction_correlated", "ashikhmin"},
      {"height_direction_correlated", "fitted"},
  };
  const int count = case_count(1000) / 8;
  for (int k = 0; k < count; ++k) {
    const bool cavity = k % 4 == 3;
    RandomCase one(engine, cavity ? "v_cavity" : k % 8 == 4 ? "smith_rational" : "smith");
    const auto& shadowing = shadowings[static_cast<std::size_t>(k / 4) % (cavity ? 6 : 10)];
    one.description = shadowed(one.description, shadowing[0], shadowing[1]);
    const Material material = build(one.description);
    if (!(material.slopes().project(one.o).c > 0)) continue;
    INFO("case " << k << ": " << material.name << ", " << shadowing[0] << " " << shadowing[1] << ", alpha_x = "
                 << one.alpha_x() << ", alpha_y = " << material.slopes().alpha_y << ", z = " << one.o.z);
    const Estimate truth = compute(Integral::furnace, material, one.o, 1e-10);
    CHECK(truth.error <= 1e-10);
    for (const double tolerance : {1e-4, 1e-8}) {
      const Estimate estimate = compute(Integral::furnace, material, one.o, tolerance);
      CHECK(std::fabs(estimate.value - truth.value) <= estimate.error + truth.error);
    }
  }
}
