// The error estimates of the integrals, over random materials of every kind. BRDFPLOT_RANDOM_CASES sets their number.
#include "../materials.hpp"
#include "../sample.hpp"
#include "analysis/integrals.hpp"
#include "brdf/diffuse.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <utility>
#include <vector>

using namespace test;

namespace {

int case_count(std::size_t all, std::size_t some) {
  return static_cast<int>(random_inputs("BRDFPLOT_RANDOM_CASES", all, some));
}

/// A distribution of any kind and roughness under any masking function, and a viewer down to 0.1 degrees.
struct RandomCase {
  TermDescription description;
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

  double alpha_x() const { return build(description).surface().slopes().alpha_x; }
};

const std::vector<std::string> maskings = {"smith",         "smith_rational",         "v_cavity", "implicit",
                                           "schlick_smith", "schlick_smith_rational", "kelemen"};

/// int <o,m> D dm over the facing normals: c (1 + Lambda) of Smith, in closed form or by its own quadrature.
double facing_area(TermDescription description, const Direction& o) {
  description.masking = {.type = "smith", .values = {}};
  const Material smith = build(description);
  return smith.surface().slopes().project(o).c / g1(smith, o);
}

/// The exact value of Eqs. 18 and 36 (Eq. 13 is c times it).
double exact(const RandomCase& one, const Material& material) {
  if (one.description.masking.type == "smith" || one.description.masking.type == "v_cavity") return 1;
  const double area = facing_area(one.description, one.o);
  if (one.description.masking.type == "implicit") return area;
  if (material.surface().has_lambda()) return g1(material, one.o) / material.surface().slopes().project(one.o).c * area;
  return compute_in_plane(Integral::visible_norm, material, one.o, 1e-12).value; // Kelemen's has no closed form
}

} // namespace

TEST_CASE("Eqs. 13, 18 and 36: the error estimate bounds the true error in random cases") {
  std::mt19937_64 engine(20260);
  const int count = case_count(1000, 60);
  for (int k = 0; k < count; ++k) {
    const RandomCase one(engine, maskings[static_cast<std::size_t>(k) % maskings.size()]);
    const Material material = build(one.description);
    const double c = material.surface().slopes().project(one.o).c;
    if (!(c > 0)) continue;
    const double truth = exact(one, material);
    INFO("case " << k << ": " << material.name << ", " << one.description.masking.type << ", alpha_x = "
                 << one.alpha_x() << ", alpha_y = " << material.surface().slopes().alpha_y << ", c = " << c);
    const double rounding = 1e-13 * truth + 1e-15 / c;
    // What the half vectors of Eq. 36 lose at grazing angles on smooth surfaces cannot be had back.
    const SlopeMap& map = material.surface().slopes();
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
  const int count = case_count(1000, 60) / 8;
  for (int k = 0; k < count; ++k) {
    const bool cavity = k % 4 == 3;
    RandomCase one(engine, cavity ? "v_cavity" : k % 8 == 4 ? "smith_rational" : "smith");
    const auto& shadowing = shadowings[static_cast<std::size_t>(k / 4) % (cavity ? 6 : 10)];
    one.description = shadowed(one.description, shadowing[0], shadowing[1]);
    const Material material = build(one.description);
    if (!(material.surface().slopes().project(one.o).c > 0)) continue;
    INFO("case " << k << ": " << material.name << ", " << shadowing[0] << " " << shadowing[1] << ", alpha_x = "
                 << one.alpha_x() << ", alpha_y = " << material.surface().slopes().alpha_y << ", z = " << one.o.z);
    const Estimate truth = compute(Integral::furnace, material, one.o, 1e-10);
    CHECK(truth.error <= 1e-10);
    for (const double tolerance : {1e-4, 1e-8}) {
      const Estimate estimate = compute(Integral::furnace, material, one.o, tolerance);
      CHECK(std::fabs(estimate.value - truth.value) <= estimate.error + truth.error);
    }
  }
}

TEST_CASE("the furnace: the error estimate bounds the true error in random cases of every G2") {
  constexpr std::array<std::pair<const char*, const char*>, 8> shadowings = {
      {{"none", ""},
       {"separable", ""},
       {"minimum", ""},
       {"height_correlated", ""},
       {"direction_correlated", "ashikhmin"},
       {"direction_correlated", "ginneken"},
       {"height_direction_correlated", "ashikhmin"},
       {"height_direction_correlated", "ginneken"}}};
  std::mt19937_64 engine(8);
  std::uniform_real_distribution<double> unit(0, 1);
  const int count = case_count(80, 16);
  for (int k = 0; k < count; ++k) {
    const bool cavity = k % 4 == 3;
    // Anisotropic by up to 200 to 1.
    const auto roughness = [&] { return 0.005 * std::pow(200, unit(engine)); };
    const Vec2 mean = k % 3 == 0 ? Vec2{0.3 * unit(engine), -0.3 * unit(engine)} : Vec2{0, 0};
    const auto* type = unit(engine) < 0.5 ? "beckmann" : "ggx";
    const auto [shadowing, factor] = shadowings[static_cast<std::size_t>(k) % (cavity ? 3 : shadowings.size())];
    const double ax = roughness(), ay = roughness(), r = k % 2 == 1 ? 1.8 * unit(engine) - 0.9 : 0;
    const Material m =
        build(shadowed(general(type, ax, ay, r, mean, cavity ? "v_cavity" : "smith"), shadowing, factor));
    const Direction o = from_angles(k % 5 == 0 ? 0 : unit(engine) * 89.9 * degree, 6.3 * unit(engine));
    if (!(m.surface().slopes().project(o).c > 0)) continue;
    INFO("case " << k << ": " << m.name << ", alpha_x = " << ax << ", alpha_y = " << ay << ", r = " << r
                 << ", z = " << o.z);
    const Estimate fine = compute(Integral::furnace, m, o, 1e-10);
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      const Estimate e = compute(Integral::furnace, m, o, tolerance);
      CHECK(std::fabs(e.value - fine.value) <= e.error + fine.error);
    }
    CHECK(fine.value <= 1 + 1e-9);
  }
}

TEST_CASE("a shape that begins with all derivatives 0 does not deceive the estimates, at grazing angles too") {
  TermDescription description = general("custom", 0.2, 0.6, -0.5, {0.2, -0.1});
  description.distribution.values.set("shape", std::string("exp(-1/t2) / (0.1 + t2^2)"));
  for (const auto* masking : {"smith", "v_cavity"}) {
    description.masking.type = masking;
    const Material m = build(description);
    for (const double theta : sample_of<double>({0.5, 1.45, 1.5}, 2))
      for (const double phi : sample_of<double>({45.0, 100.0, 225.0}, 2)) {
        const Direction o = from_angles(theta, phi * degree); // at 1.5 and 45 degrees c is 2e-4
        const double c = m.surface().slopes().project(o).c;
        if (!(c > 0)) continue;
        INFO(masking << ", theta_o = " << theta << ", phi_o = " << phi);
        for (const double tolerance : {1e-5, 1e-9}) {
          for (const auto integral : {Integral::projected_area, Integral::visible_norm, Integral::weak_furnace}) {
            const Estimate e = compute_in_plane(integral, m, o, tolerance);
            CHECK(std::fabs(e.value - (integral == Integral::projected_area ? c : 1)) <= e.error);
          }
          const Estimate e = diffuse_weak_furnace(m.surface(), o, tolerance);
          CHECK(std::fabs(e.value - 1) <= e.error);
        }
        const Estimate fine = compute(Integral::furnace, m, o, 1e-10);
        const Estimate e = compute(Integral::furnace, m, o, 1e-7);
        CHECK(std::fabs(e.value - fine.value) <= e.error + fine.error);
      }
  }
}
