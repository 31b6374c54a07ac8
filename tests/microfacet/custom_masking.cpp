#include "../materials.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace test;

namespace {

const std::string ggx_lambda = "(sqrt(1 + 1 / a^2) - 1) / 2";

} // namespace

TEST_CASE("a formula of Lambda is the built-in function that it spells") {
  const auto general_ggx = general("ggx", 0.3, 0.7, 0.4, {0.2, -0.1});
  const Material built_in = build(general_ggx);
  for (const auto& formula : {ggx_lambda, std::string("(sqrt(1 + (alpha * tan_theta)^2) - 1) / 2"),
                              std::string("(sqrt(1 + tan(theta)^2 * ((alpha_x * cos(phi))^2 + (alpha_y * sin(phi))^2 + "
                                          "2 * correlation * alpha_x * alpha_y * cos(phi) * sin(phi))) - 1) / 2")}) {
    INFO(formula);
    const Material custom = build(with_formula(general_ggx, "lambda", formula));
    for (const double theta : {0.0, 1e-3, 0.5, 1.2, 1.5})
      for (const double phi : {-2.0, 0.0, 0.7, 3.0}) {
        const Direction o = from_angles(theta, phi), i = from_angles(0.8, 1.0);
        CHECK(g1(custom, o) == doctest::Approx(g1(built_in, o)).epsilon(1e-12));
        // Height-correlated by default, as for everything that has a Lambda.
        CHECK(value(custom, Quantity::brdf, o, i) ==
              doctest::Approx(value(built_in, Quantity::brdf, o, i)).epsilon(1e-12));
      }
  }
}

TEST_CASE("a formula of G1 may depend on the normal") {
  const Material built_in = material("beckmann", 0.5, "v_cavity");
  const Material custom = build(with_formula(describe("beckmann", 0.5), "g1",
                                             "min(1, 2 * cos_theta_m * cos_theta / o_dot_m) + 0 * theta_m * phi_m"));
  CHECK_FALSE(custom.surface().has_lambda());
  for (const double theta : {0.0, 0.9, 1.5}) {
    const Direction o = from_angles(theta, 0.4), m = from_angles(0.7, 0.2);
    CHECK(value_at_normal(custom, Quantity::g1, o, m) ==
          doctest::Approx(value_at_normal(built_in, Quantity::g1, o, m)).epsilon(1e-14));
    CHECK(value_at_normal(custom, Quantity::g1, o, from_angles(1.5, 3.5)) ==
          value_at_normal(built_in, Quantity::g1, o, from_angles(1.5, 3.5))); // faces away
  }
  CHECK(value_at_normal(custom, Quantity::g1, {1, 0, 0}, from_angles(0.5, 0)) == 0);
}

TEST_CASE("a formula of o.m has its digits where both directions graze") {
  const Material built_in = build(describe("ggx", 0.5, "kelemen"));
  const Material custom = build(with_formula(describe("ggx", 0.5), "g1", "cos_theta / o_dot_m"));
  for (const double c : {1e-3, 1e-8, 1e-12}) {
    const double s = std::sqrt((1 - c) * (1 + c));
    const auto at = [&](double phi) { return Direction{s * std::cos(phi), s * std::sin(phi), c}; };
    const Direction o = at(0.4), i = at(0.4 + std::numbers::pi + 0.7 * c);
    CHECK(evaluate(custom, Quantity::g1, o, i, std::nullopt) ==
          doctest::Approx(evaluate(built_in, Quantity::g1, o, i, std::nullopt)).epsilon(1e-14));
  }
}

TEST_CASE("phi does not know the sign of a zero") {
  TermDescription description = describe("ggx", 0.5, "custom");
  description.masking.values.set("lambda", std::string("2 + sin(phi / 2)"));
  const Material of_lambda = build(description);
  CHECK(lambda(of_lambda, {-0.6, -0.0, 0.8}) == lambda(of_lambda, {-0.6, 0.0, 0.8}));
  CHECK(lambda(of_lambda, {-0.0, -0.0, 1}) == lambda(of_lambda, {0, 0, 1}));
  description.masking.values = {};
  description.masking.values.set("g1", std::string("0.5 + sin(phi_m / 2) / 4"));
  const Material of_g1 = build(description);
  const Direction o = from_angles(0.3, 1);
  CHECK(evaluate(of_g1, Quantity::g1, o, std::nullopt, {{-0.6, -0.0, 0.8}}) ==
        evaluate(of_g1, Quantity::g1, o, std::nullopt, {{-0.6, 0.0, 0.8}}));
}

TEST_CASE("below the mesosurface no formula is asked; above it one that is not a number is an error") {
  const Material custom = build(with_formula(describe("ggx", 0.5), "lambda", "sqrt(theta - 0.5)"));
  CHECK(g1(custom, from_angles(2, 0)) == 0);
  CHECK(g1(custom, from_angles(1, 0)) > 0);
  CHECK_THROWS_WITH_AS(g1(custom, from_angles(0.25, 1)),
                       doctest::Contains("\"sqrt(theta - 0.5)\" is not a number at theta = 0.25, phi = 1"), InputError);
}

TEST_CASE("formulas that cannot be are refused with what may stand in them") {
  const auto refuses = [](const std::string& key, const std::string& formula, const std::string& what) {
    INFO(formula);
    CHECK_THROWS_WITH_AS(build(with_formula(describe("ggx", 0.5), key, formula)), doctest::Contains(what.c_str()),
                         MaterialError);
  };
  refuses("lambda", "tan_teta", "unknown name \"tan_teta\"; did you mean \"tan_theta\"? accepted: theta, phi");
  refuses("lambda", "o_dot_m", "unknown name \"o_dot_m\"");
  refuses("lambda", "1 +", "the formula \"1 +\": ");
  refuses("g1", "", "the formula \"\": ");
  auto both = with_formula(describe("ggx", 0.5), "lambda", "a");
  both.masking.values.set("g1", std::string("1"));
  CHECK_THROWS_AS(build(both), MaterialError);
}
