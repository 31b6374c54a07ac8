#include "math/cubature.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace brdfplot;

namespace {

template <class F>
Estimate integral(const F& f, const std::vector<Rectangle>& rectangles, double tolerance, std::size_t budget = 400000) {
  return integrate_plane(
      [&](std::size_t chart, const double* x, const double* y, double* out, std::size_t n) {
        for (std::size_t k = 0; k < n; ++k) out[k] = f(chart, x[k], y[k]);
      },
      rectangles, {.absolute = tolerance}, budget);
}

} // namespace

TEST_CASE("smooth functions of the plane cost one rule a rectangle") {
  const auto f = [](std::size_t, double x, double y) { return std::exp(x) * std::cos(y); };
  const auto e = integral(f, {{0, 1, 0, 1}}, 1e-12);
  CHECK(e.evaluations == 465);
  CHECK(std::fabs(e.value - (std::numbers::e - 1) * std::sin(1.0)) <= e.error);
  CHECK(e.error < 1e-12);
}

TEST_CASE("several functions at once: each meets the tolerance, and the hardest pays") {
  // One of no width is 0 everywhere, at its centre too.
  const auto peak = [](double width, double x, double y) {
    return width > 0 ? width / (width * width + x * x + y * y) : 0;
  };
  const std::array<double, 3> widths = {1, 0.05, 0};
  const PlaneFunction f = [&](std::size_t, const double* x, const double* y, double* out, std::size_t n) {
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < n; ++k) out[c * n + k] = peak(widths[c], x[k], y[k]);
  };
  const std::vector<Rectangle> square = {{-1, 1, -1, 1}};
  const ColourEstimate all = integrate_plane(f, 3, square, {.absolute = 1e-10});
  std::array<std::size_t, 3> alone{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto one = integral([&](std::size_t, double x, double y) { return peak(widths[c], x, y); }, square, 1e-12);
    CHECK(all.error[c] <= 1e-10);
    CHECK(std::fabs(all.value[c] - one.value) <= all.error[c] + one.error);
    alone[c] =
        integral([&](std::size_t, double x, double y) { return peak(widths[c], x, y); }, square, 1e-10).evaluations;
  }
  CHECK(static_cast<double>(all.evaluations) < 1.2 * static_cast<double>(alone[1])); // not the sum
  CHECK(all.value[2] == 0);
}

TEST_CASE("rectangles of several charts are summed, empty ones are free") {
  const auto f = [](std::size_t chart, double x, double) { return chart == 1 ? 2 * x : 1; };
  const auto e = integral(f, {{0, 3, 0, 2, 0}, {0, 1, 0, 1, 1}, {1, 1, 0, 1, 0}}, 1e-10);
  CHECK(e.value == doctest::Approx(7).epsilon(1e-14));
  CHECK(e.evaluations == 2 * 465);
}

TEST_CASE("peaks, edge singularities, kinks and jumps: the error estimate bounds the true error") {
  struct Case {
    const char* name;
    double (*f)(double x, double y);
    double truth;
  };
  const double disc = std::numbers::pi / 4;
  const Case cases[] = {
      {"peak", [](double x, double y) { return std::exp(-1e3 * ((x - 0.3) * (x - 0.3) + (y - 0.6) * (y - 0.6))); },
       std::numbers::pi / 1e3},
      {"root", [](double x, double y) { return std::sqrt(x) * y; }, 1.0 / 3},
      {"ridge across x", [](double x, double) { return 1 / (1e-4 + (x - 0.5) * (x - 0.5)); }, 200 * std::atan(50.0)},
      {"kink", [](double x, double y) { return std::fabs(x - 0.3) * y; }, 0.145},
      {"jump", [](double x, double y) { return y < 0.123456 ? x : 0; }, 0.061728},
      {"disc", [](double x, double y) { return std::max(0.0, 1 - x * x - y * y); }, disc / 2}};
  for (const Case& one : cases)
    for (const double tolerance : {1e-3, 1e-5, 1e-6}) {
      const auto e = integral([&](std::size_t, double x, double y) { return one.f(x, y); }, {{0, 1, 0, 1}}, tolerance);
      INFO(one.name << ", tolerance " << tolerance << ", value " << e.value << ", cost " << e.evaluations);
      CHECK(std::fabs(e.value - one.truth) <= e.error);
      CHECK(e.error <= tolerance);
    }
}

TEST_CASE("a plane integral that cannot be had says so by its error") {
  const auto e = integral([](std::size_t, double x, double) { return 1 / x; }, {{0, 1, 0, 1}}, 1e-9, 20000);
  CHECK(e.error > 1e-3);
}
