// Half and difference angles as variables of figures.
#include "math/half_difference.hpp"
#include "figure/series/term.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

using namespace brdfplot;
using plot::Setting;

TermDescription ggx() {
  TermDescription term;
  term.distribution.type = "ggx";
  term.distribution.values.set("alpha_x", 0.3);
  term.distribution.values.set("alpha_y", 0.5);
  return term;
}

double value(const std::string& quantity, const std::vector<Setting>& at) {
  return plot::TermFunction({quantity, ggx(), at}, {}, 1e-9)({}).at(0);
}

std::string error(const std::vector<Setting>& at) {
  try {
    value("brdf", at);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

} // namespace

TEST_CASE("half and difference angles set viewer and light") {
  const HalfDifference at{0.4, 1.1, 0.7, 2.0};
  const ViewerAndLight pair = pair_of(at);
  const double expected = evaluate(build(ggx()), Quantity::brdf, pair.o, pair.i, std::nullopt);
  CHECK(expected > 0);
  CHECK(value("brdf", {{"theta_h", 0.4}, {"phi_h", 1.1}, {"theta_d", 0.7}, {"phi_d", 2.0}}) == expected);
  // The half vector is the normal of what asks for one.
  const double d = evaluate(build(ggx()), Quantity::d, pair.o, std::nullopt, from_angles(0.4, 1.1));
  CHECK(value("d", {{"theta_h", 0.4}, {"phi_h", 1.1}, {"theta_d", 0.7}}) == doctest::Approx(d).epsilon(1e-14));
  // phi 0 where it is not set; swept like other directions; nothing below the horizon.
  CHECK(value("brdf", {{"theta_h", 0.4}, {"theta_d", 0.7}}) ==
        value("brdf", {{"theta_h", 0.4}, {"phi_h", 0.0}, {"theta_d", 0.7}, {"phi_d", 0.0}}));
  CHECK(value("brdf", {{"theta_h", 1.0}, {"theta_d", 1.0}}) == 0);
  const plot::TermFunction slice({"brdf", ggx(), {{"theta_h", 0.4}, {"phi_d", 2.0}}}, {"theta_d", "phi_h"}, 1e-9);
  CHECK(slice({{0.1, 0.7}, {0.0, 1.1}}).at(1) == expected);
}

TEST_CASE("half and difference angles stand in the place of those of viewer and light") {
  CHECK(error({{"theta_h", 0.4}, {"theta_d", 0.7}, {"theta_o", 0.1}}) ==
        "found \"theta_h\" beside \"theta_o\"; accepted: the directions of viewer and light, or their half and "
        "difference angles");
  CHECK(error({{"theta_d", 0.7}, {"phi_i", 0.1}}).find("\"theta_d\" beside \"phi_i\"") != std::string::npos);
  CHECK(error({{"theta_h", 0.4}, {"theta_d", 0.7}, {"a", 1.0}}).find("beside \"a\"") != std::string::npos);
  CHECK(error({{"theta_h", 0.4}}) == "found \"theta_h\" without \"theta_d\"; accepted: theta_h and theta_d together");
  CHECK(error({{"phi_d", 0.4}}).find("without \"theta_h\"") != std::string::npos);
}
