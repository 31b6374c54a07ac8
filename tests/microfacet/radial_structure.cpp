// Where shapes that users write jump, bend and change their scale: found from the formula alone.
#include "microfacet/distributions/radial_structure.hpp"

#include "../materials.hpp"
#include "brdf/integrals/components.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace test;

namespace {

std::vector<double> radii(const std::string& shape) {
  return components(build(custom(shape, 0.5)).surface().distribution)[0].radii;
}

/// The radii are these, to a relative 1e-9.
void check_radii(const std::string& shape, const std::vector<double>& expected) {
  INFO(shape);
  const auto found = radii(shape);
  REQUIRE(found.size() == expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) CHECK(relative(found[k], expected[k]) < 1e-9);
}

} // namespace

TEST_CASE("smooth shapes of one scale are cut nowhere") {
  for (const auto* shape :
       {"exp(-t2)", "1 / (1 + t2)^3", "3 / (1 + t2)^2", "1 / (1 + t2)^1.6", "exp(-t)", "exp(-sqrt(t))",
        "t2 * exp(-t2^1.1)", "t^2 * exp(-t)", "exp(-1/t2) / (0.1 + t2^2)", "exp(-t2) * (1 + 0.9 * sin(6 * t))",
        "1 / (1 + t2^4)", "exp(-t2^20)", "1 / (1 + t2^40)", "1 - tanh(1000 * (t - 1))",
        "exp(-t2) + 0.01 * exp(-t2 / 30)", "(0.2 + 6 * exp(-1/t2)) / (1 + t2)^3"})
    check_radii(shape, {});
}

TEST_CASE("jumps and corners are found where they are, however small") {
  check_radii("t2 < 1 ? 1 : 0", {1});
  check_radii("t2 < 1.00001 ? 1 : 0", {std::sqrt(1.00001)});
  check_radii("max(0, 1 - t2)", {1});
  check_radii("t < 0.01 ? 1000 : exp(-t)", {0.01});
  check_radii("abs(t - 1) < 0.3 ? abs(t - 1) : 0", {0.7, 1, 1.3});
  check_radii("exp(-t2) * (1 + 0.001 * abs(t - 1))", {1});
  check_radii("max(exp(-t2), 0.1 * exp(-t2 / 9))", {std::sqrt(9.0 / 8 * std::log(10.0))});
  check_radii("exp(-t2) + (t < 2 ? 1e-6 : 0)", {2});
}

TEST_CASE("narrow peaks are cut out, and none of their neighbours is wider than a hundred times the peak") {
  struct Peak {
    const char* shape;
    double at, width;
  };
  for (const Peak& peak : {Peak{"exp(-((t - 1) / 0.01)^2)", 1, 0.01},
                           {"exp(-((t - 1) / 0.002)^2)", 1, 0.002},
                           {"exp(-t2) * (1 + 0.5 * exp(-((t - 1) / 0.01)^2))", 1, 0.01},
                           {"exp(-t2) + 1e-3 * exp(-((t - 2) / 0.02)^2)", 2, 0.02},
                           {"exp(-t2) + 1000 * exp(-1e4 * t2)", 0, 0.01},
                           {"exp(-t2) + exp(-1e4 * t2)", 0, 0.01}}) {
    INFO(std::string(peak.shape));
    double before = 0, after = INFINITY;
    for (const double r : radii(peak.shape)) {
      if (r <= peak.at) before = r;
      if (r > peak.at) after = std::min(after, r);
    }
    CHECK(after - before < 100 * peak.width);
  }
}

TEST_CASE("a shape of more pieces than can be integrated is refused, and says of how many") {
  try {
    build(custom("sin(1000 * t) > 0 ? exp(-t2) : 0", 0.5));
    FAIL("accepted");
  } catch (const MaterialError& error) {
    INFO(error.what());
    CHECK(std::string(error.what()).find("jumps and corners") != std::string::npos);
    CHECK(std::string(error.what()).find("accepted: 64 of both") != std::string::npos);
  }
}
