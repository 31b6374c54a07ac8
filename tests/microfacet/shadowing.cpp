#include "../materials.hpp"

#include "brdf/evaluate_single.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

using namespace test;

namespace {

double g2(const std::string& type, const std::string& factor, const Direction& o, const Direction& i) {
  return value(build(shadowed(describe("ggx", 0.8), type, factor)), Quantity::g2, o, i);
}

} // namespace

TEST_CASE("G2 in all its forms, from G1 and Lambda") {
  const Material m = material("ggx", 0.8);
  for (const double phi : {0.0, 0.4, 2.0, 3.14159, 5.0, -0.4}) {
    const Direction o = from_angles(1.2, 0.3), i = from_angles(0.9, 0.3 + phi);
    const double wrapped = std::fabs(std::remainder(phi, 2 * std::numbers::pi));
    const double lo = lambda(m, o), li = lambda(m, i), go = 1 / (1 + lo), gi = 1 / (1 + li);
    INFO("phi = " << phi);
    CHECK(relative(g2("none", "", o, i), go) < 4e-15);
    CHECK(relative(g2("separable", "", o, i), go * gi) < 4e-15);
    CHECK(relative(g2("minimum", "", o, i), std::min(go, gi)) < 4e-15);
    CHECK(relative(g2("height_correlated", "", o, i), 1 / (1 + lo + li)) < 4e-15);
    const DirectionPair pair{wrapped, {o.z, 0.8 * std::sin(1.2)}, {i.z, 0.8 * std::sin(0.9)}};
    for (const auto* factor : {"ashikhmin", "ginneken", "fitted"}) {
      const double l = factor[0] == 'a'   ? 1 - std::exp(-7.3 * wrapped * wrapped)
                       : factor[0] == 'g' ? 4.41 * wrapped / (4.41 * wrapped + 1)
                                          : fitted_direction_correlation(pair).lambda;
      CHECK(relative(g2("direction_correlated", factor, o, i), l * go * gi + (1 - l) * std::min(go, gi)) < 1e-13);
      CHECK(relative(g2("height_direction_correlated", factor, o, i),
                     1 / (1 + std::max(lo, li) + l * std::min(lo, li))) < 1e-13);
    }
  }
}

TEST_CASE("at the hotspot nothing that is seen is in shadow") {
  const Direction o = from_angles(1.3, 0.7);
  const double masking = g1(material("ggx", 0.8), o);
  for (const auto* type : {"direction_correlated", "height_direction_correlated"})
    for (const auto* factor : {"ashikhmin", "ginneken", "fitted"})
      CHECK(relative(g2(type, factor, o, o), masking) < 1e-14);
  CHECK(g2("height_correlated", "", o, o) < 0.8 * masking);
}

TEST_CASE("the normal has no azimuth: the difference is 0 for every factor and every sign of zero") {
  const Direction lights[] = {from_angles(1, 0.7), from_angles(1, 2.5), from_angles(1, -0.7), from_angles(1, -2.5)};
  for (const auto* masking : {"smith", "kelemen", "v_cavity"})
    for (const auto* type : {"direction_correlated", "height_direction_correlated"})
      for (const auto* factor : {"ashikhmin", "ginneken", "fitted"}) {
        const bool lambda = std::string(masking) == "smith";
        if (!lambda && std::string(type) == "height_direction_correlated") continue;
        const Material m = build(shadowed(describe("ggx", 0.4, masking), type, factor));
        const double expected = value(m, Quantity::g2, {0, 0, 1}, lights[0]);
        for (const double x : {0.0, -0.0})
          for (const double y : {0.0, -0.0})
            for (const Direction& light : lights) {
              INFO(masking << ", " << type << ", " << factor << ", light " << light.x << " " << light.y);
              CHECK(relative(value(m, Quantity::g2, {x, y, 1}, light), expected) < 1e-14);
              CHECK(relative(value(m, Quantity::g2, light, {x, y, 1}), expected) < 1e-14);
              std::array<float, 1> single{};
              const Direction normal{x, y, 1};
              const auto columns = [](const Direction& d) { return Columns{&d.x, &d.y, &d.z}; };
              evaluate(m, Quantity::g2, {1, columns(normal), columns(light), {}}, single.data());
              CHECK(relative(single[0], expected) < 1e-6);
            }
      }
  // What is not quite the normal has the azimuth that it has, however near.
  const Material m = build(shadowed(describe("ggx", 0.4, "kelemen"), "direction_correlated", "ginneken"));
  CHECK(value(m, Quantity::g2, {1e-200, 0, 1}, from_angles(1, std::numbers::pi)) ==
        doctest::Approx(value(m, Quantity::g2, {1e-9, 0, 1}, from_angles(1, std::numbers::pi))));
}

TEST_CASE("the factors are those of RTR4, Eqs. 9.29 and 9.30") {
  const auto factor = [](DirectionFactor which, double phi) { return direction_correlation(which, {phi}).lambda; };
  CHECK(factor(DirectionFactor::ginneken, std::numbers::pi) == doctest::Approx(0.9327).epsilon(1e-3));
  CHECK(factor(DirectionFactor::ashikhmin, 20 * degree) == doctest::Approx(0.589).epsilon(1e-3));
  CHECK(factor(DirectionFactor::ginneken, 20 * degree) == doctest::Approx(0.606).epsilon(1e-3));
  CHECK(factor(DirectionFactor::ashikhmin, 0) == 0);
  CHECK(factor(DirectionFactor::ginneken, 0) == 0);
}

TEST_CASE("V-cavities default to the minimum of masking and shadowing") {
  const Material m = material("beckmann", 0.6, "v_cavity");
  const Direction o = from_angles(1.3, 0), i = from_angles(0.5, 2.5), h = half_vector(o, i);
  const double expected = std::min({1.0, 2 * h.z * o.z / dot(o, h), 2 * h.z * i.z / dot(i, h)});
  CHECK(value(m, Quantity::g2, o, i) == doctest::Approx(expected).epsilon(1e-14));
}

TEST_CASE("implicit and Kelemen cancel the denominator of the BRDF as printed") {
  const Direction o = from_angles(1.0, 0), i = from_angles(0.7, 2.5), h = half_vector(o, i);
  const double d = value_at_normal(material("ggx", 0.4), Quantity::d, o, h);
  CHECK(value(material("ggx", 0.4, "implicit"), Quantity::brdf, o, i) == doctest::Approx(d / 4).epsilon(1e-14));
  CHECK(value(material("ggx", 0.4, "kelemen"), Quantity::brdf, o, i) ==
        doctest::Approx(d / (4 * dot(o, h) * dot(i, h))).epsilon(1e-14));
}
