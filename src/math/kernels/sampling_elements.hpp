/// \file
/// One element of random slopes as they are seen, and of the direction mirrored there. Included once per instruction
/// set, like arithmetic.hpp; sampling.hpp says what they compute.
#pragma once

#include "math/kernels/elements.hpp"

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

struct Turn {
  double cosine, sine;
};

/// cos and sin of 2 pi u, 0 <= u <= 1, absolute error below 3e-16: by their series within a quarter of a turn of 0 or
/// of 1/2.
BRDFPLOT_INLINE Turn turn(double u) {
  constexpr double sine[] = {1.0,
                             -1.0 / 6,
                             1.0 / 120,
                             -1.0 / 5040,
                             1.0 / 362880,
                             -1.0 / 39916800,
                             1.0 / 6227020800,
                             -1.0 / 1307674368000,
                             1.0 / 355687428096000,
                             -1.0 / 121645100408832000,
                             1.0 / 51090942171709440000.0};
  constexpr double cosine[] = {1.0,
                               -1.0 / 2,
                               1.0 / 24,
                               -1.0 / 720,
                               1.0 / 40320,
                               -1.0 / 3628800,
                               1.0 / 479001600,
                               -1.0 / 87178291200,
                               1.0 / 20922789888000,
                               -1.0 / 6402373705728000,
                               1.0 / 2432902008176640000};
  constexpr double two_pi = 0x1.921fb54442d18p2;
  const auto shifted = multiply_add(u, 2.0, integer_shift<double>);
  const double t = two_pi * multiply_add(shifted - integer_shift<double>, -0.5, u);
  const Bits<double> sign = bits(shifted) << 63;
  const double z = t * t, z2 = z * z;
  return {from_bits<double>(bits(polynomial(cosine, z, z2)) ^ sign),
          from_bits<double>(bits(t * polynomial(sine, z, z2)) ^ sign)};
}

/// ln(u + low) for normal u, as `logarithm`, but rounded as a double: to 3e-16 of itself.
BRDFPLOT_INLINE double rounded_logarithm(double u, double low) {
  using F = Format<double>;
  constexpr Bits<double> root_half = 0x3fe6a09e667f3bcd, offset = Bits<double>{1088} << F::fraction_bits;
  constexpr double series[] = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11, 2.0 / 13,
                               2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21, 2.0 / 23};
  const Bits<double> k_bits = (bits(u) + (offset - root_half)) >> F::fraction_bits; // k + 1088
  const double power = from_bits<double>(k_bits | bits(F::integer)) - (F::integer + 1088);
  const auto scale = from_bits<double>((Bits<double>{F::bias + 1088} - k_bits) << F::fraction_bits);
  const double over = multiply_add(u, scale, -1.0) + low * scale;
  const double s = over / (over + 2), z = s * s;
  // 2 s = over - s over, whose rounding does not matter beside over's.
  const double rest = multiply_add(s * z, polynomial(series, z, z * z), -(s * over));
  return multiply_add(power, F::ln2_high, over) + multiply_add(power, F::ln2_low, rest);
}

/// e^x for -700 < x <= 0.
BRDFPLOT_INLINE double normal_exponential(double x) {
  const Exponential<double> e = exponential(x, 0.0, 1.0);
  return from_bits<double>(bits(e.value) + exponent_bits(e.shifted_k));
}

/// sqrt(pi) e^(x^2) erfc(x), x >= 0, as a quotient: (2 x M + N) / (M + 2 x^2 M + x N), with N and M of
/// microfacet/beckmann_lambda.hpp; nothing cancels.
BRDFPLOT_INLINE Quotient<double> scaled_erfc(double x, double square) {
  const double m = polynomial(BeckmannLambdaFit<double>::denominator, x, square);
  const double n = polynomial(BeckmannLambdaFit<double>::numerator, x, square);
  return {multiply_add(x + x, m, n), multiply_add(square + square, m, multiply_add(x, n, m)), 0};
}

/// |erfc^-1(t)| to 8e-5 / max(1, itself) for 2^-53 <= t < 2: with w = -ln(1 - erf^2), its square over w falls from pi/4
/// to 1, as fitted here at Chebyshev's nodes of sqrt(w) in [0, 6.1].
BRDFPLOT_INLINE double first_erfc_inverse(double t) {
  constexpr double above[] = {0.785398216494, 0.152194928246, 0.0239022031750, 0.00144709661505};
  constexpr double below[] = {1.0, 0.170193563327, 0.0269163383432, 0.00145351869823};
  const double w = larger(-rounded_logarithm(t * (2 - t), 0.0), 0.0), w2 = w * w;
  return root(w * polynomial(above, w, w2) / polynomial(below, w, w2));
}

/// The share of what lies further out than u on its side of 1/2, and as much on the other; u = 0 as 2^-54.
BRDFPLOT_INLINE double both_tails(double u) { return 2 * smaller(larger(u, 0x1p-54), 1 - u); }

/// erf^-1(2 u - 1) for u in [0, 1) from x = first_erfc_inverse(both_tails(u)). One step of Newton's rule and two terms
/// more, which are the series of the inverse: absolute error below 1e-15 (1 + |x|).
BRDFPLOT_INLINE double gaussian(double x, double u) {
  const double t = both_tails(u), square = x * x;
  const Quotient<double> q = scaled_erfc(x, square);
  const double e = normal_exponential(-square);
  constexpr double half_root_pi = 0x1.c5bf891b4ef6bp-1;
  // (erfc(x) - t) / erfc'(x)
  const double y = 0.5 * multiply_add(q.numerator, e, -(2 * half_root_pi * t) * q.denominator) / (e * q.denominator);
  const double series = multiply_add(multiply_add(4 * square, 1.0 / 3, 1.0 / 3), y, x);
  const double moved = multiply_add(y, multiply_add(series, y, 1.0), x);
  return __builtin_copysign(moved, u - 0.5);
}

/// erfc of the guess of a slope towards the viewer: erf(-x) = 1 - (1 + C) u^f with C = erf(c / s), f a polynomial in
/// the angle (Heitz and d'Eon 2014).
BRDFPLOT_INLINE double first_erfc(const detail::VisibleConstants& k, double u) {
  const double power = normal_exponential(k.first_power * rounded_logarithm(larger(u, 0x1p-54), 0.0));
  return smaller(multiply_add(k.rest, power, k.below), 2 - 0x1p-50);
}

/// The guess, from t = first_erfc(); where slopes start, their square is as the share: x = lowest +
/// y / (1 + 2 y c / (3 s)), y = sqrt(2 whole u e^(c^2 / s^2) / s).
BRDFPLOT_INLINE double first_facing(const detail::VisibleConstants& k, double t, double u) {
  const double x = __builtin_copysign(first_erfc_inverse(t), t - 1), y = k.rise * root(larger(u, 0x1p-54));
  return larger(x, k.lowest + y / multiply_add(k.bend, y, 1.0));
}

/// L(x) = sqrt(-ln(1 - u)), which is x where it is seen from the horizon.
BRDFPLOT_INLINE double wanted_root(double u) {
  const double above_0 = larger(u, 0x1p-54), complement = 1 - above_0;
  return root(-rounded_logarithm(complement, (1 - complement) - above_0));
}

/// A share of what is seen, taken from the side where it does not cancel: F(x) for x < 0 and 1 - F(x) else; and
/// e^(-x^2).
struct FacingShare {
  double part, e;
};

BRDFPLOT_INLINE FacingShare share_at(const detail::VisibleConstants& k, double x) {
  const double square = x * x, e = normal_exponential(-square);
  const Quotient<double> q = scaled_erfc(magnitude(x), square);
  const double scaled = k.c * (q.numerator / q.denominator);
  const double side = x < 0 ? -1.0 : 1.0, lost = x < 0 ? k.share_lost : 0.0;
  const double part = multiply_add(0.5 * e, multiply_add(side, k.s, scaled), lost);
  return {larger(part * k.inverse_whole, 1e-40), e};
}

/// A step for L(x) = sqrt(-ln(1 - F(x))), F(x) the share of what is seen below x, that is to be `wanted`: L is smooth,
/// and nearly linear where there is little on either side. With h = F' / (1 - F) and its derivatives, of the fourth
/// order (Householder). `at` is share_at(x).
BRDFPLOT_INLINE double facing_step(const detail::VisibleConstants& k, double x, const FacingShare& at, double wanted) {
  const bool low = x < 0;
  const double rest = low ? 1 - at.part : at.part;
  const double l2 = larger(-rounded_logarithm(rest, low ? (1 - rest) - at.part : 0.0), 1e-18), l = root(l2);
  const double d = larger(multiply_add(k.s, x, k.c), 1e-18);
  const double mass = rest * k.whole, inverse = 1 / (d * mass);
  const double h = d * at.e * d * inverse, fall = k.s * mass * inverse, b = fall - 2 * x + h;
  const double inverse2 = 1 / (h * l2), half = 0.5 * h * h * inverse2;
  const double n = 2 * l * (wanted - l) * l2 * inverse2;
  const double a = 0.5 * (b - half);
  const double third = multiply_add(b, b, h * b - fall * fall - 2) * (1.0 / 6) - a * half;
  const double next = x + n * multiply_add(a, n, 1.0) / multiply_add(multiply_add(third, n, 2 * a), n, 1.0);
  return larger(next, k.lowest);
}

/// The last step, from within some 1e-3 of where the share below is u: Newton's rule and two terms more of the series
/// of F's inverse, y = (u - F) / F', which need no logarithm. F is taken as in share_at().
BRDFPLOT_INLINE double last_facing_step(const detail::VisibleConstants& k, double x, double u) {
  const double above_0 = larger(u, 0x1p-54), square = x * x;
  const double e = normal_exponential(-square);
  const Quotient<double> q = scaled_erfc(magnitude(x), square);
  const double area = k.c * q.numerator, edge = k.s * q.denominator;
  const double side = x < 0 ? -1.0 : 1.0, lost = x < 0 ? k.share_lost : 0.0;
  const double wanted = k.whole * (x < 0 ? above_0 : 1 - above_0);
  const double excess = multiply_add(0.5 * e, multiply_add(side, edge, area), (lost - wanted) * q.denominator);
  const double d = larger(multiply_add(k.s, x, k.c), 1e-18), inverse = 1 / (q.denominator * d * e);
  const double y = side * inverse * excess;
  const double fall = edge * e * inverse, b = multiply_add(-2.0, x, fall); // s / d, and F'' / F'
  const double third = multiply_add(b, 2 * b, multiply_add(fall, fall, 2.0)) * (1.0 / 6);
  return larger(multiply_add(y, multiply_add(y, multiply_add(third, y, -0.5 * b), 1.0), x), k.lowest);
}

/// Unit slopes times h, and h.
struct SeenSlope {
  double facing, across, h;
};

/// h (facing, across) of GgxShape::visible_slope.
BRDFPLOT_INLINE SeenSlope ggx_slope(const detail::VisibleConstants& k, double u_azimuth, double u_height) {
  const Turn azimuth = turn(u_azimuth);
  const double h = (1 - u_height) * (1 + k.c);
  const double radius = root(u_height * (1 + k.c) * (k.versine + h));
  return {multiply_add(radius, azimuth.cosine, k.s), radius * azimuth.sine, h};
}

/// The normal, longer by `norm2`, and omega_o mirrored there.
struct MirroredAt {
  double x, y, z, norm2;
};

/// `inverse` is that of norm2.
BRDFPLOT_INLINE MirroredAt normal_of(const detail::VisibleConstants& k, const SeenSlope& s) {
  const double x = multiply_add(s.facing, k.facing[0], multiply_add(s.across, k.across[0], -k.mean[0] * s.h));
  const double y = multiply_add(s.facing, k.facing[1], multiply_add(s.across, k.across[1], -k.mean[1] * s.h));
  return {x, y, s.h, multiply_add(x, x, multiply_add(y, y, s.h * s.h))};
}

BRDFPLOT_INLINE void store_mirrored(const detail::VisibleConstants& k, const MirroredAt& m, double inverse_norm2,
                                    const MirroredAtNormals& out, std::size_t j) {
  const double along = multiply_add(k.o[0], m.x, multiply_add(k.o[1], m.y, k.o[2] * m.z));
  const double twice = 2 * along * inverse_norm2;
  out.x[j] = multiply_add(twice, m.x, -k.o[0]);
  out.y[j] = multiply_add(twice, m.y, -k.o[1]);
  out.z[j] = multiply_add(twice, m.z, -k.o[2]);
}

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
