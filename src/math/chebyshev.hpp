/// \file
/// Polynomials through the Chebyshev points of [-1, 1].
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace brdfplot {

/// The k-th Chebyshev point of n.
inline double chebyshev_node(std::size_t k, std::size_t n) {
  return std::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(n));
}

/// sum of c(k) T_k(x) over k < n, by Clenshaw's recurrence.
template <class Coefficient>
double chebyshev_sum(std::size_t n, double x, const Coefficient& c) {
  double one = 0, two = 0;
  for (std::size_t k = n - 1; k > 0; --k) {
    const double next = c(k) + 2 * x * one - two;
    two = one;
    one = next;
  }
  return c(0) + x * one - two;
}

/// Replaces n values at the Chebyshev points, `stride` apart, by the coefficients of the polynomial through them.
inline void to_chebyshev_coefficients(double* values, std::size_t n, std::size_t stride = 1) {
  std::vector<double> c(n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < n; ++k)
      c[j] += values[k * stride] * std::cos(std::numbers::pi * static_cast<double>(j) * (static_cast<double>(k) + 0.5) /
                                            static_cast<double>(n));
    c[j] = c[j] * (j == 0 ? 1.0 : 2.0) / static_cast<double>(n);
  }
  for (std::size_t j = 0; j < n; ++j) values[j * stride] = c[j];
}

} // namespace brdfplot
