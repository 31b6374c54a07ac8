#include "brdf/evaluate_single.hpp"
#include "../materials.hpp"

#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <random>
#include <vector>

using namespace test;

namespace {

/// Directions above and below the horizon, whose components are floats: of the values only the arithmetic is single.
struct Rows {
  std::array<std::vector<double>, 9> columns;
  std::size_t n = 0;

  explicit Rows(std::size_t count) : n(count) {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> cosine(-0.1, 1), azimuth(0, 2 * std::numbers::pi);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t side = 0; side < 3; ++side) {
        const Direction omega = from_angles(std::acos(cosine(engine)), azimuth(engine));
        columns[3 * side].push_back(static_cast<float>(omega.x));
        columns[3 * side + 1].push_back(static_cast<float>(omega.y));
        columns[3 * side + 2].push_back(static_cast<float>(omega.z));
      }
  }
  Columns side(std::size_t first) const {
    return {columns[first].data(), columns[first + 1].data(), columns[first + 2].data()};
  }
};

std::vector<Material> materials() {
  std::vector<Material> all;
  for (const char* type : {"beckmann", "ggx"}) {
    all.push_back(material(type, 0.25));
    all.push_back(build(general(type, 0.25, 0.75, 0.5, {0.25, -0.5})));
    all.push_back(build(shadowed(general(type, 0.25, 0.125, 0), "separable")));
    all.push_back(build(shadowed(describe(type, 0.5), "direction_correlated", "ginneken"))); // no kernel for its BRDF
    all.push_back(build(shadowed(general(type, 0.25, 0.5, 0.5), "height_direction_correlated", "fitted")));
    all.push_back(material(type, 0.5, "v_cavity"));
  }
  all.push_back(gtr(0.25, 1.5));
  TermDescription metal = describe("ggx", 0.25);
  metal.fresnel.type = "conductor";
  metal.fresnel.values.set("eta", Rgb{0.14, 0.38, 1.44});
  metal.fresnel.values.set("k", Rgb{3.98, 2.39, 1.60});
  all.push_back(build(metal));
  return all;
}

/// In units in the last place of a float, subnormal ones included.
double distance(float value, double exact) {
  if (value == exact) return 0;
  const double size = std::max(std::fabs(exact), 0x1p-126);
  return std::fabs(value - exact) / std::ldexp(1.0, std::ilogb(size) - 23);
}

/// What the rounding of c and s to floats, 3 ulp of them together, makes of Lambda of Beckmann: e^(-a^2) magnifies it
/// 2 a^2 times, a = c / s.
double conditioning(const Material& m, const Direction& o) {
  const Projection p = m.surface().slopes().project(o);
  return p.c > 0 ? 6 * (p.c / p.s) * (p.c / p.s) : 0;
}

} // namespace

TEST_CASE("single precision is within 8 ulp of a float of the double value") {
  const Rows rows(3 * 256 + 7); // whole blocks, and a rest
  for (const Material& m : materials())
    for (const QuantityInfo& info : quantities()) {
      if (info.quantity == Quantity::lambda && !m.surface().has_lambda()) continue;
      for (const bool with_m : {true, false}) {
        const Batch batch{rows.n, rows.side(0), rows.side(3), with_m ? rows.side(6) : Columns{}};
        const auto channels = static_cast<std::size_t>(info.coloured() ? m.channels() : 1);
        std::vector<float> single(rows.n * channels);
        std::vector<double> exact(rows.n * channels);
        evaluate(m, info.quantity, batch, single.data());
        evaluate(m, info.quantity, batch, exact.data());
        INFO(m.name << ", " << info.name);
        for (std::size_t k = 0; k < exact.size(); ++k) {
          const std::size_t row = k % rows.n;
          const Direction o{batch.o.x[row], batch.o.y[row], batch.o.z[row]};
          REQUIRE(distance(single[k], exact[k]) <= 8 + (info.quantity == Quantity::lambda ? conditioning(m, o) : 0));
        }
      }
    }
}

TEST_CASE("what rounding directions to float costs the BRDF is what docs/accuracy.md and --help say") {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto columns = [](const Direction& d) { return Columns{&d.x, &d.y, &d.z}; };
  for (const char* type : {"ggx", "beckmann"})
    for (const double alpha : {1.0, 0.1, 1e-2, 1e-3, 8e-4, 1e-4, 1e-5, 2e-6}) {
      const Material m = material(type, alpha);
      double worst = 0, of_bound = 0;
      for (int k = 0; k < 20000; ++k) {
        const Direction o = from_angles(89.9 * degree * uniform(engine), 2 * std::numbers::pi * uniform(engine));
        const double slope = 2 * alpha * std::sqrt(uniform(engine)), psi = 2 * std::numbers::pi * uniform(engine);
        const Direction h = normalized({slope * std::cos(psi), slope * std::sin(psi), 1});
        const Direction i = reflected(o, h);
        const double cosine = std::min(o.z, i.z);
        if (!(cosine > std::cos(89.9 * degree))) continue;
        const double exact = value(m, Quantity::brdf, o, i);
        float single = 0;
        evaluate(m, Quantity::brdf, {1, columns(o), columns(i), {}}, &single);
        const double error = relative(single, exact), bound = 0x1p-22 * (1 + 1 / (alpha * cosine));
        INFO(type << " " << alpha << ", o.z = " << o.z << ", i.z = " << i.z);
        if (bound < 0.1) CHECK(error <= bound);
        if (bound < 0.1) of_bound = std::max(of_bound, error / bound);
        worst = std::max(worst, error);
      }
      INFO(type << " " << alpha << ": worst " << worst << ", of the bound " << of_bound);
      if (alpha > 2e-6) CHECK(of_bound > 0.15); // the bound is no exaggeration
      const bool ggx = std::string(type) == "ggx";
      if (alpha == 0.1) CHECK(worst == doctest::Approx(5e-5).epsilon(0.5));
      if (alpha == 8e-4) CHECK(worst == doctest::Approx(ggx ? 0.03 : 0.06).epsilon(0.5));
      if (alpha == 2e-6) CHECK(worst > 10);
      if (alpha == 2e-6) CHECK(worst < 100);
    }
}

TEST_CASE("single precision needs the directions that double needs") {
  const Rows rows(1);
  float out = 0;
  CHECK_THROWS_AS(evaluate(material("ggx", 0.5), Quantity::brdf, {1, rows.side(0), {}, {}}, &out), InputError);
  CHECK_THROWS_AS(evaluate(material("ggx", 0.5, "v_cavity"), Quantity::lambda, {1, rows.side(0), {}, {}}, &out),
                  InputError);
}
