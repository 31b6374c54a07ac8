/// \file
/// Gauss-Kronrod rules as tables of nodes and weights, and the error that goes with them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace brdfplot {

/// Nodes of the Kronrod rule of N points on [-1, 1] in ascending order with both weights; a Gauss weight of 0 where the
/// node is not one of Gauss's n = (N - 1) / 2. N: 15, 21, 31, 61.
template <std::size_t N>
struct GaussKronrod {
  static constexpr std::size_t gauss_count = N / 2;
  static constexpr std::size_t exact_degree = 3 * gauss_count + 1; ///< of polynomials that Kronrod's rule integrates
  static constexpr std::size_t last_degree = exact_degree / 2;     ///< of Legendre coefficients that it can tell
  static constexpr std::size_t apart = 5; ///< degrees by which the coefficients before are lower

  std::array<double, N> x, kronrod, gauss;
  /// Weights that give the coefficients of f in Legendre polynomials: of the last degrees, in pairs (odd and even
  /// functions lack every second one), and of as many lower ones.
  std::array<std::array<double, N>, 2> last, next_to_last;
  std::array<std::array<double, N>, 4> before;
  std::array<double, N> at_end; ///< weights of the polynomial through the nodes at x = 1

  static const GaussKronrod& rule();
};

/// What two rules say of one function on [-1, 1].
struct RuleSums {
  double kronrod = 0;   ///< the integral
  double magnitude = 0; ///< of |f|
  double gap = 0;       ///< |Kronrod - Gauss|
  /// The largest coefficient of each group.
  double last = 0, next_to_last = 0, before = 0;
};

/// The error of Kronrod's rule, judged by how fast the Legendre coefficients c_d of f fall. Gauss's rule errs like
/// c_2n, Kronrod's like c_(3n+2): both are guessed from the last coefficients, and from the difference of the rules, at
/// the rate at which coefficients fell so far, over the last two degrees or the last five, whichever is slower. What
/// falls like a power of d, as the coefficients of a kink do, gets little credit for converging. Nor is that rate
/// believed without end: a small part that falls slowly may just have come to light. Then the rules differ by as much
/// as the last coefficients are large, where smooth functions have them differ far less; what that makes one expect
/// (with constants that were measured over random integrals), up to a tenth of the last coefficients, is a floor, and
/// so is 1/400 of these.
/// (QUADPACK judges by the size of the difference alone, and believes the rule where a small kink is left in a smooth
/// function.) Never below 50 roundings.
template <std::size_t N>
double error_of(const RuleSums& sums) {
  using Rule = GaussKronrod<N>;
  const double rounding = 50 * std::numeric_limits<double>::epsilon() * sums.magnitude;
  // The last ones may be small by accident: what those before make one expect counts too.
  const double falling = sums.next_to_last < sums.before ? sums.next_to_last / sums.before : 1;
  const double last = std::max(sums.last, sums.next_to_last * falling);
  if (!(std::max(sums.gap, 4 * last) > rounding)) return rounding;
  const auto log_rate = [](double factor, double earlier, double later, double degrees) {
    return factor * later < earlier ? std::log(factor * later / earlier) / degrees : 0;
  };
  const double rate = std::max(log_rate(2, sums.before, last, Rule::apart), log_rate(1.2, sums.next_to_last, last, 2));
  constexpr double from_gauss = Rule::gauss_count + 2;
  constexpr double from_last = Rule::exact_degree + 1 - (Rule::last_degree - 0.5);
  const double slow = last > 0 ? std::min(last / 10, 3 * sums.gap * std::sqrt(sums.gap / last)) : 0;
  return std::max(
      {sums.gap * std::exp(from_gauss * rate), 4 * last * std::exp(from_last * rate), slow, last / 400, rounding});
}

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
  sums.gap = std::fabs(sums.kronrod - sum_with(rule.gauss));
  sums.magnitude = sum_in_strands<N>([&](std::size_t k) { return rule.kronrod[k] * std::fabs(values[k]); });
  const auto largest = [&](const auto& group) {
    double most = 0;
    for (const auto& weights : group) most = std::max(most, std::fabs(sum_with(weights)));
    return most;
  };
  sums.last = largest(rule.last);
  sums.next_to_last = largest(rule.next_to_last);
  sums.before = largest(rule.before);
  return sums;
}

} // namespace brdfplot
