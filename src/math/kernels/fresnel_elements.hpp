/// \file
/// One element of the reflectances. Included once per instruction set, like arithmetic.hpp; kernels.hpp says what they
/// compute. But for the power of a general exponent nothing here is a fused multiplication and addition whose result
/// depends on being fused: the bytes are the same on every instruction set.
#pragma once

#include "math/kernels/arithmetic.hpp"
#include "math/kernels/table.hpp"

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

/// c, c^2 and what it lacks, sin^2 = 1 - c^2, rounded once, and Re(n^2) - sin^2.
struct Incidence {
  double c, cosine2, cosine2_low, sine2, t;
};

/// t = (Re(n^2) - 1) + c^2 is rounded once but for some 2^-150: at the critical angle the two cancel, and the
/// reflectance changes like the root of what is left.
BRDFPLOT_INLINE Incidence incidence(const detail::IndexConstants& k, double c) {
  const double square = c * c, square_low = product_low(c, c, square), rest = 1 - square;
  const Pair<double> high = sum(k.above[0], square), low = sum(k.above[1], square_low);
  return {c, square, square_low, rest + (((1 - rest) - square) - square_low),
          ((high.high + low.high) + high.low) + (low.low + k.above[2])};
}

/// With p = sqrt(n^2 - sin^2) and q its real part, |r_s|^2 = |c - p|^2 / |c + p|^2 = |n^2 - 1|^2 / |c + p|^4 and
/// |r_p|^2 = |r_s|^2 (A - B) / (A + B), A = |p|^2 c^2 + sin^4, B = 2 c q sin^2. The mean is |r_s|^2 A / (A + B). Of
/// |r_s|^2 the first form where little is subtracted, |c -+ p|^2 = (c^2 + |p|^2) -+ 2 c q, as for metals, else the
/// second, which doubles the errors of |c + p|^2: what its sums drop is kept. Rounded, the mean may be above 1, which
/// no reflectance is.
BRDFPLOT_INLINE double mean_reflectance(const detail::IndexConstants& k, const Incidence& i, double p2, double q) {
  const double a = p2 * i.cosine2 + i.sine2 * i.sine2, twice = (i.c + i.c) * q;
  const Pair<double> both = sum(i.cosine2, p2), sum2 = sum(both.high, twice);
  const double low = sum2.low + (both.low + i.cosine2_low), square = sum2.high * sum2.high;
  const double power4 = square + (product_low(sum2.high, sum2.high, square) + (sum2.high + sum2.high) * low);
  const double numerator = twice < 0.4 * both.high ? (both.high - twice) * sum2.high : k.contrast;
  return smaller((numerator * a) / not_zero(power4 * (a + twice * i.sine2)), 1.0);
}

BRDFPLOT_INLINE double dielectric(const detail::IndexConstants& k, double c) {
  const Incidence i = incidence(k, c);
  const double p2 = larger(i.t, 0.0);
  const double f = mean_reflectance(k, i, p2, root(p2));
  return i.t < 0 ? 1 : f;
}

/// p is the root of t + i Im(n^2): the larger of its parts first, the other by division.
BRDFPLOT_INLINE double conductor(const detail::IndexConstants& k, double c) {
  const Incidence i = incidence(k, c);
  const double p2 = root(i.t * i.t + k.imaginary_squared);
  const double sum2 = p2 + magnitude(i.t), twice_larger = root(sum2 + sum2);
  const double q = i.t >= 0 ? 0.5 * twice_larger : k.imaginary / not_zero(twice_larger);
  return mean_reflectance(k, i, p2, q);
}

/// (1 - c)^exponent and its complement.
struct Grazing {
  double power, complement;
};

/// The complement is c (1 + u + u^2 + u^3 + u^4), u = 1 - c.
BRDFPLOT_INLINE Grazing fifth_power(double c) {
  const double u = 1 - c, square = u * u;
  return {square * square * u, c * (1 + u * (1 + u * (1 + u * (1 + u))))};
}

/// ln(u + low) - less ln 2 for 2^-1020 <= u <= 1 and a whole number `less`, to some 2^-64 of itself: with m in
/// [sqrt(1/2), sqrt(2)) and s = (m - 1) / (m + 1), ln m = 2 s + 2 s^3 / 3 + 2 s^5 / 5 + ..., |s| < 0.172.
BRDFPLOT_INLINE Pair<double> logarithm(double u, double low, double less) {
  using F = Format<double>;
  constexpr Bits<double> root_half = 0x3fe6a09e667f3bcd, offset = Bits<double>{1088} << F::fraction_bits;
  const Bits<double> k_bits = (bits(u) + (offset - root_half)) >> F::fraction_bits; // k + 1088
  const double power = from_bits<double>(k_bits | bits(F::integer)) - (F::integer + 1088) - less;
  const auto scale = from_bits<double>((Bits<double>{F::bias + 1088} - k_bits) << F::fraction_bits);
  const double m = u * scale, m_low = low * scale;
  const Pair<double> over = sum(m - 1, m_low), under = sum(m, 1.0);
  const double inverse = 1 / under.high, s = over.high * inverse;
  const double missing = residual(over.high, s, under.high) + (over.low - s * (under.low + m_low));
  const double s_low = missing * inverse;
  const Pair<double> square = product(s, s_low, s, s_low), cube = product(square.high, square.low, s, s_low);
  const Pair<double> third = product(cube.high, cube.low, 2.0 / 3, 0x1.5555555555555p-55);
  constexpr double series[] = {2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11, 2.0 / 13, 2.0 / 15,
                               2.0 / 17, 2.0 / 19, 2.0 / 21, 2.0 / 23, 2.0 / 25};
  const double z = square.high;
  const double rest = (cube.high * z) * polynomial(series, z, z * z);
  const Pair<double> first = sum(power * F::ln2_high, s + s), second = sum(first.high, third.high);
  return sum(second.high, first.low + (second.low + (power * F::ln2_low + ((s_low + s_low) + (third.low + rest)))));
}

/// By e^(exponent ln(1 - c)); the complement of one near 1 is what the exponential function has before it adds 1.
BRDFPLOT_INLINE Grazing power(double c, double exponent) {
  const double u = 1 - c;
  const Pair<double> ln = logarithm(larger(u, 0x1p-60), (1 - u) - c, 0);
  const Pair<double> x = product(ln.high, ln.low, exponent, 0.0);
  const bool nothing = (x.high < -800) | (u <= 0);
  const Exponential<double> e = exponential(larger(x.high, -800.0), nothing ? 0 : x.low, 1.0);
  const double value = nothing ? 0 : scaled(e.value, e.shifted_k);
  return {value, e.shifted_k == integer_shift<double> && !nothing ? (1 - e.value) - e.value_low : 1 - value};
}

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
