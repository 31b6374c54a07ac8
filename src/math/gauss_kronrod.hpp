/// \file
/// Gauss-Kronrod rules as tables of nodes and weights, and the error that goes with them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace brdfplot {

/// Nodes of the Kronrod rule of N points on [-1, 1] in ascending order with both weights; a Gauss weight of 0 where the
/// node is not one of Gauss's N / 2. N: 15, 21, 31, 61.
template <std::size_t N>
struct GaussKronrod {
  std::array<double, N> x, kronrod, gauss;
  /// Weights that give the last two coefficients of f in Legendre polynomials that Gauss's nodes can tell.
  std::array<double, N> last, before_last;

  static const GaussKronrod& rule();
};

/// What two rules say of one function on [-1, 1].
struct RuleSums {
  double kronrod = 0, gauss = 0; ///< the two integrals
  double magnitude = 0;          ///< of |f|
  double spread = 0;             ///< of |f - mean|
  double coefficient = 0;        ///< the larger of the last two; 0 where not asked for

  /// QUADPACK's error of the Kronrod rule (Piessens et al. 1983): the difference of the two rules is the error of the
  /// worse one, and is scaled by how well they converge; never below 50 roundings. The difference may be small by
  /// accident. But Gauss's rule of n points, of degree 2 n - 1, and Kronrod's, of degree 3 n + 1, cannot be good while
  /// coefficients of degree n are not small: the error is never below the cube of these.
  double error() const;
};

/// The sum of f(0) ... f(N - 1) in four strands, which the processor adds at the same time.
template <std::size_t N, class Function>
double sum_in_strands(const Function& f) {
  std::array<double, 4> strand{};
  constexpr std::size_t whole = N - N % 4;
  for (std::size_t k = 0; k < whole; k += 4)
    for (std::size_t j = 0; j < 4; ++j) strand[j] += f(k + j);
  for (std::size_t k = whole; k < N; ++k) strand[k - whole] += f(k);
  return (strand[0] + strand[1]) + (strand[2] + strand[3]);
}

/// Applies a rule to values at its nodes.
template <std::size_t N>
RuleSums apply_rule(const std::array<double, N>& values) {
  const auto& rule = GaussKronrod<N>::rule();
  const auto sum_with = [&](const std::array<double, N>& weights) {
    return sum_in_strands<N>([&](std::size_t k) { return weights[k] * values[k]; });
  };
  RuleSums sums;
  sums.kronrod = sum_with(rule.kronrod);
  sums.gauss = sum_with(rule.gauss);
  sums.magnitude = sum_in_strands<N>([&](std::size_t k) { return rule.kronrod[k] * std::fabs(values[k]); });
  const double mean = 0.5 * sums.kronrod;
  sums.spread = sum_in_strands<N>([&](std::size_t k) { return rule.kronrod[k] * std::fabs(values[k] - mean); });
  sums.coefficient = std::fmax(std::fabs(sum_with(rule.last)), std::fabs(sum_with(rule.before_last)));
  return sums;
}

} // namespace brdfplot
