/// \file
/// Smith's Lambda of the Beckmann distribution, exact over the whole domain.
///
/// Printed (Heitz 2014, Eq. 69; Smith 1967): Lambda(a) = (erf a - 1) / 2 + e^(-a^2) / (2 a sqrt(pi)). Evaluated so, the
/// two terms cancel: half of the digits are lost at a = 4, all of them from a = 5.5 on. With erfc in place of erf - 1
/// they still do (the terms agree to 1 / (2 a^2)). Here nothing cancels. With
///
///   R(a) = 2 sqrt(pi) a e^(a^2) Lambda(a) = 1 - sqrt(pi) a erfcx(a) = 1 / (1 + 2 a^2 + a U(a)),
///
/// U is smooth and positive, falls from sqrt(pi) at 0 to 2 / a at infinity, and is fitted by one rational N / M with
/// positive coefficients (relative error of R: 2e-17). The rounding of N / M reaches R damped, by a U R < 0.3.
#pragma once

#include "math/beckmann_lambda_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace brdfplot {

namespace detail {

/// c0 + c1 x + c2 x^2 + ... as two chains, even and odd powers, which the processor runs side by side.
template <std::size_t size>
double even_odd_polynomial(const double (&c)[size], double x) {
  const double square = x * x;
  double even = 0;
  double odd = 0;
  for (std::size_t i = size; i-- > 0;) {
    double& chain = i % 2 ? odd : even;
    chain = chain * square + c[i];
  }
  return even + x * odd;
}

/// a Lambda(a) = factor (numerator / denominator). The factor is 1 unless the quotient alone would be subnormal.
struct BeckmannTerms {
  double numerator;
  double denominator;
  double factor;
};

inline BeckmannTerms beckmann_terms(double a) {
  constexpr double half_over_root_pi = 0x1.20dd750429b6dp-2;
  const double a_u = a * (even_odd_polynomial(BeckmannLambdaFit<double>::numerator, a) /
                          even_odd_polynomial(BeckmannLambdaFit<double>::denominator, a));
  // The rounding error of a^2 is the one that matters: e^(-a^2) magnifies it a^2 times.
  const double square = a * a;
  const double square_low = std::fma(a, a, -square);
  // 1 + 2 a^2 + a U in two sums, larger term first, so that each difference below is exactly what the sum dropped.
  const double sum = 1 + 2 * square;
  const double sum_low = (std::max(1.0, 2 * square) - sum) + std::min(1.0, 2 * square);
  const double denominator = sum + a_u;
  const double denominator_low = (sum - denominator) + a_u + sum_low + 2 * square_low;
  // Near the end of the range the exponential goes in as two halves: one rounding, the last, may be subnormal.
  const bool tiny = square > 700;
  const double exponential = std::exp(tiny ? -square / 2 : -square);
  const double numerator = half_over_root_pi * exponential;
  return {numerator - numerator * (square_low + denominator_low / denominator), denominator, tiny ? exponential : 1};
}

/// Where e^(-a^2) has left the range of doubles and a^2 has not.
inline constexpr double beckmann_largest_a = 27.5;

} // namespace detail

/// a Lambda(a) of the Beckmann distribution (Heitz 2014, Eq. 69): the projected area that is masked, over the projected
/// roughness. Domain a >= 0, infinity included: 1 / (2 sqrt(pi)) at a = 0, decreasing, subnormal for a > 26.5 and 0 for
/// a > 27.3. Error: at most 4 ulp. A NaN stays NaN.
inline double beckmann_a_lambda(double a) {
  const detail::BeckmannTerms t = detail::beckmann_terms(std::min(a, detail::beckmann_largest_a));
  return t.numerator / t.denominator * t.factor;
}

/// Lambda(a) of the Beckmann distribution (Heitz 2014, Eq. 69), a = cot(theta_o) / alpha_o. Domain a >= 0, infinity
/// included: infinite at a = 0 (like 1 / (2 a sqrt(pi))), decreasing, 0 for a > 27.3. Error: at most 4 ulp. A NaN stays
/// NaN. Where the product cos(theta_o) Lambda is wanted, beckmann_a_lambda gives it without the infinity.
inline double beckmann_lambda(double a) {
  const double clamped = std::min(a, detail::beckmann_largest_a);
  const detail::BeckmannTerms t = detail::beckmann_terms(clamped);
  return t.numerator / (clamped * t.denominator) * t.factor;
}

} // namespace brdfplot
