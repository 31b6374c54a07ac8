#include "math/chebyshev.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace brdfplot;

TEST_CASE("the polynomial through Chebyshev points is the one of those values, and that of an exponential is it to "
          "rounding") {
  constexpr std::size_t n = 21, apart = 3;
  std::array<double, n * apart> values{};
  for (std::size_t k = 0; k < n; ++k) values[k * apart] = std::exp(chebyshev_node(k, n));
  to_chebyshev_coefficients(values.data(), n, apart);
  const auto at = [&](double x) { return chebyshev_sum(n, x, [&](std::size_t k) { return values[k * apart]; }); };
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon() * 2.72; // of the sum of all coefficients
  for (double x = -1; x <= 1; x += 0.0625) CHECK(std::fabs(at(x) - std::exp(x)) < rounding);
  CHECK(values[1] == 0);
  // x^3 = (3 T_1 + T_3) / 4.
  std::array<double, 5> cubic{};
  for (std::size_t k = 0; k < cubic.size(); ++k) cubic[k] = std::pow(chebyshev_node(k, cubic.size()), 3);
  to_chebyshev_coefficients(cubic.data(), cubic.size());
  constexpr std::array<double, 5> exact = {0, 0.75, 0, 0.25, 0};
  for (std::size_t k = 0; k < cubic.size(); ++k) CHECK(std::fabs(cubic[k] - exact[k]) < 2e-16);
}
