#include "math/quadrature.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace brdfplot;

namespace {

template <class F>
Estimate integral(const F& f, std::vector<double> points, Tolerance tolerance, std::size_t budget = 100000,
                  Jumps jumps = Jumps::none) {
  return integrate(
      [&](const double* x, double* y, std::size_t n) {
        for (std::size_t k = 0; k < n; ++k) y[k] = f(x[k]);
      },
      points, tolerance, budget, jumps);
}

} // namespace

TEST_CASE("integrals of smooth functions cost one rule and are exact to rounding") {
  const auto polynomial = integral([](double x) { return 3 * x * x; }, {0, 2}, {.relative = 1e-12});
  CHECK(polynomial.value == doctest::Approx(8).epsilon(1e-15));
  CHECK(polynomial.evaluations == 21);
  const auto sine = integral([](double x) { return std::sin(x); }, {0, std::numbers::pi}, {.absolute = 1e-12});
  CHECK(std::fabs(sine.value - 2) <= sine.error);
  CHECK(sine.error < 1e-12);
}

TEST_CASE("the error estimate bounds the true error, kinks, endpoint singularities and peaks included") {
  struct Case {
    const char* name;
    double (*f)(double);
    double a, b, truth;
  };
  const Case cases[] = {{"kink", [](double x) { return std::fabs(x - 0.3); }, 0, 1, 0.5 * (0.09 + 0.49)},
                        {"root", [](double x) { return std::sqrt(x); }, 0, 1, 2.0 / 3},
                        {"inverse root", [](double x) { return 1 / std::sqrt(x); }, 0, 1, 2},
                        {"logarithm", [](double x) { return std::log(x); }, 0, 1, -1},
                        {"peak", [](double x) { return 1 / (1e-6 + x * x); }, -1, 1, 2e3 * std::atan(1e3)},
                        {"jump", [](double x) { return x < 0.123456 ? 1.0 : 0.0; }, 0, 1, 0.123456},
                        {"oscillation", [](double x) { return std::cos(50 * x); }, 0, 1, std::sin(50.0) / 50}};
  for (const Case& one : cases)
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
      const auto estimate = integral(one.f, {one.a, one.b}, {.absolute = tolerance});
      INFO(one.name << ", tolerance " << tolerance << ", value " << estimate.value);
      CHECK(std::fabs(estimate.value - one.truth) <= estimate.error);
      CHECK(estimate.error <= std::max(tolerance, 1e-12 * std::fabs(one.truth)));
    }
}

TEST_CASE("an integral that cannot be had says so by its error") {
  const auto estimate = integral([](double x) { return 1 / x; }, {0, 1}, {.absolute = 1e-9}, 2000);
  CHECK(estimate.error > 1e-3);
  CHECK(estimate.evaluations <= 2100);
}

TEST_CASE("cuts where the integrand has kinks make it cheap") {
  const auto f = [](double x) { return std::fabs(x - 0.3); };
  CHECK(integral(f, {0, 0.3, 1}, {.absolute = 1e-12}).evaluations == 42);
  CHECK(integral(f, {0, 0.3, 0.3, 1}, {.absolute = 1e-12}).evaluations == 42);
  CHECK(integral(f, {0, 1}, {.absolute = 1e-12}).evaluations > 200);
  CHECK(integral(f, {1, 1}, {.absolute = 1e-12}).value == 0);
}

TEST_CASE("a jump just beside a cut is not overlooked") {
  // Unless it lies within 0.2 % of the ends of the whole, where no node has ever been.
  for (double jump = 0.003; jump < 0.997; jump += 0.00137) {
    const auto estimate = integral([=](double x) { return x < jump ? 1 + x : 0.0; }, {0, 1}, {.absolute = 1e-9});
    INFO("at " << jump);
    CHECK(std::fabs(estimate.value - (jump + 0.5 * jump * jump)) <= estimate.error);
  }
}

TEST_CASE("where jumps are possible none is overlooked, up to the ends") {
  for (double jump = 1e-9; jump < 1; jump *= 1.037)
    for (const bool at_end : {false, true}) {
      const double share = at_end ? 1 - jump : jump;
      const auto estimate = integral([=](double x) { return x < share ? 1 + x : 0.0; }, {0, 0.4, 1}, {.absolute = 1e-9},
                                     100000, Jumps::possible);
      INFO("at " << share);
      CHECK(std::fabs(estimate.value - (share + 0.5 * share * share)) <= estimate.error);
      CHECK(estimate.error <= 1e-9);
    }
  const auto smooth =
      integral([](double x) { return std::exp(-x); }, {0, 1}, {.absolute = 1e-12}, 100, Jumps::possible);
  CHECK(smooth.evaluations == 23);
  CHECK(std::fabs(smooth.value + std::expm1(-1)) <= smooth.error);
}
