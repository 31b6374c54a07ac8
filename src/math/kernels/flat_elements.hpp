/// \file
/// One pair of directions of the flat terms. Included once per instruction set, like arithmetic.hpp; flat.hpp says what
/// they compute.
#pragma once

#include "math/kernels/brdf_elements.hpp"
#include "math/kernels/flat.hpp"
#include "math/kernels/sampling_elements.hpp"

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

inline constexpr double half_pi = 0x1.921fb54442d18p0;

/// The parts of a term.
struct Parts {
  double a, b, c;
};

BRDFPLOT_INLINE double fifth(double x) {
  const double x2 = x * x;
  return x2 * x2 * x;
}

/// 1 - m^5 for l = 1 - m, as a product of what does not cancel.
BRDFPLOT_INLINE double one_less_fifth(double m, double l) {
  const double m2 = m * m;
  return l * ((1 + m) * (1 + m2) + m2 * m2);
}
BRDFPLOT_INLINE double one_less_fifth(double l) { return one_less_fifth(1 - l, l); }

/// o + i, whose square is 4 (l.h)^2. Of opposite directions at grazing the square is 0; l.h is then below 1e-153.
BRDFPLOT_INLINE Vector3 sum_of(const Vector3& o, const Vector3& i) { return {o.x + i.x, o.y + i.y, o.z + i.z}; }
BRDFPLOT_INLINE double square_of(const Vector3& v) { return multiply_add(v.x, v.x, multiply_add(v.y, v.y, v.z * v.z)); }

/// l.h and what it is short of 1.
struct HalfCosine {
  double lh, one_less_lh;
};

/// With c = l.h, |o - i|^2 = 4 (1 - c^2), so that 1 - c = (|o - i|^2 + (2 - 2 c)^2) / 8, of which the first square is
/// right to some roundings and the second, off by (2 - 2 c) 1e-15 + 1e-31, counts for no more than 1 - c of the sum. No
/// division waits for the root. (2 - 2 c)^2 is at most the other square; for o = i both are 0.
BRDFPLOT_INLINE HalfCosine half_cosine(const Vector3& o, const Vector3& i) {
  const double twice = root(square_of(sum_of(o, i))), rest = 2 - twice;
  const double apart = square_of({o.x - i.x, o.y - i.y, o.z - i.z});
  return {0.5 * twice, 0.125 * (apart + smaller(rest * rest, apart))};
}

template <bool printed>
BRDFPLOT_INLINE Parts disney(const double (&p)[5], const Vector3& o, const Vector3& i, double w) {
  const double l = i.z, v = o.z;
  const double m_l = fifth(1 - l), m_v = fifth(1 - v), rest_l = one_less_fifth(l), rest_v = one_less_fifth(v);
  const double ss90 = 0.25 * p[0] * square_of(sum_of(o, i)), d90 = 0.5 + 2 * ss90;
  const double f_d = (rest_l + d90 * m_l) * (rest_v + d90 * m_v);
  const double f_subsurface = (rest_l + ss90 * m_l) * (rest_v + ss90 * m_v);
  const double among = printed ? w / l / v : w / (l + v);
  const double f_ss = (among - 0.5 * w) * f_subsurface + 0.5 * w;
  return {(1 - p[1]) * f_d * w + 1.25 * p[1] * f_ss, 0, 0};
}

/// k = (l.h)^2: k (0.9 - 0.4 k) (0.5 + n.h) / n.h without n.h, which may be 0.
BRDFPLOT_INLINE Parts hammon(const Vector3& o, const Vector3& i, double w) {
  const double square = square_of(sum_of(o, i)), k = 0.25 * square, lh = 0.5 * root(square);
  const double rough = (0.9 - 0.4 * k) * (k * w + k * lh * (w / (i.z + o.z)));
  return {one_less_fifth(i.z) * one_less_fifth(o.z) * w, rough, w};
}

/// Squares of the horizontal part and of z of h, of any length: the sum of opposite directions at grazing may be so
/// short that its square is 0, and is scaled by a power of two.
struct HalfSquares {
  double across2, z2;
};

BRDFPLOT_INLINE HalfSquares half_squares(const Vector3& o, const Vector3& i) {
  const Vector3 sum = sum_of(o, i);
  const double up = normalizer(larger(larger(magnitude(sum.x), magnitude(sum.y)), magnitude(sum.z)));
  const double x = sum.x * up, y = sum.y * up, z = sum.z * up;
  return {x * x + y * y, z * z};
}

/// cot^2 where e^(-p0 cot^2) is below 1e-390 counts as there.
BRDFPLOT_INLINE Parts velvet(const double (&p)[5], const Vector3& o, const Vector3& i, double w) {
  const HalfCosine half = half_cosine(o, i);
  const HalfSquares h = half_squares(o, i);
  const double least = h.z2 * p[0] * (1.0 / 900);
  const double cot2 = h.z2 / not_zero(larger(h.across2, least));
  const Exponential<double> e = exponential(-(p[0] * cot2), 0.0, 1.0);
  const double inverted = scaled(h.across2 < least ? 0 : e.value, e.shifted_k) * ((1 + cot2) * (1 + cot2));
  // n.l + n.v - (n.l)(n.v)
  const double cloth = (p[1] + p[2] * inverted) * (0.25 * (w / (i.z + o.z * (1 - i.z))));
  return {one_less_fifth(half.one_less_lh, half.lh) * w, cloth, fifth(half.one_less_lh) * cloth};
}

/// e^x within 3e-16 of 1, x <= 0; 0 from -700.
BRDFPLOT_INLINE double exponential_or_none(double x) {
  const double value = normal_exponential(larger(x, -700.0));
  return x > -700 ? value : 0;
}

/// u^exponent for 0 < u <= 1, subnormal numbers too. The logarithm x is right within 5e-16 of itself, and so is e^x
/// within 5e-16 / e of 1, since -x e^x is at most 1 / e.
BRDFPLOT_INLINE double power_of(double u, double exponent) {
  const bool tiny = u < 0x1p-1000;
  const double ln = rounded_logarithm(tiny ? u * 0x1p64 : u, 0) - (tiny ? 64 * 0x1.62e42fefa39efp-1 : 0);
  return exponential_or_none(ln * exponent);
}

/// (1 - c)^exponent, whose logarithm knows what the difference was rounded by: large powers of what is near 1.
BRDFPLOT_INLINE double power_of_rest(double c, double exponent) {
  const double u = 1 - c;
  const double value = exponential_or_none(rounded_logarithm(larger(u, 0x1p-60), (1 - u) - c) * exponent);
  return u > 0 ? value : 0;
}

BRDFPLOT_INLINE Parts uncharted2(const double (&p)[5], double v, double w) {
  return {(p[0] * power_of(v, p[1]) + p[2] * power_of_rest(v, p[3]) + p[4]) * w, 0, 0};
}

/// asin x = value + slope above / below for 0 <= x <= 1: for x <= 1/2 by a minimax quotient of polynomials in x^2,
/// whose error is 1.6e-19 of x, and for x > 1/2 by pi/2 - 2 asin sqrt((1 - x) / 2). Relative error below 5e-16.
struct Arcsine {
  double value, slope, above, below;
};

BRDFPLOT_INLINE Arcsine arcsine_parts(double x) {
  constexpr double above[] = {0x1.5555555555553p-3,  -0x1.4e8af227db1ebp-2, 0x1.9f63aefd63986p-3,
                              -0x1.4cd3fe9916b67p-5, 0x1.aa12693cc9ffap-11, 0x1.2fa37f43986fcp-15};
  constexpr double below[] = {1.0, -2.410211469741579, 2.0336991187722546, -0.6956344959716322, 0.07829920744124669};
  const bool large = x > 0.5;
  const double z = large ? larger(0.5 * (1 - x), 0.0) : x * x, r = large ? root(z) : x, z2 = z * z;
  return {large ? half_pi - (r + r) : r, large ? -(r + r) : r, z * polynomial(above, z, z2), polynomial(below, z, z2)};
}

BRDFPLOT_INLINE double arcsine(double x) {
  const Arcsine a = arcsine_parts(x);
  return a.value + a.slope * (a.above / a.below);
}

/// At grazing s is divided by what is small: it must be right where the azimuths are at right angles, and its terms
/// cancel.
BRDFPLOT_INLINE double fujii(double roughness, const Vector3& o, const Vector3& i, double w) {
  const double x = o.x * i.x, y = o.y * i.y, rounded = x + y;
  const double s = rounded + (sum_low(x, y, rounded) + (product_low(o.x, i.x, x) + product_low(o.y, i.y, y)));
  const double over_larger = w / larger(o.z, i.z);
  return w + roughness * s * (s > 0 ? over_larger : w);
}

/// B(mu) = k1 pi - G(mu), G as in the source, as a quotient; with arccos mu = s (pi/2 - mu psi(mu)), s = sin theta:
///   B = mu (s^2 (psi + 1) + mu pi/2 - (2/3) (mu + s (1 + s + s^2)) / (1 + s)),
/// where nothing cancels at either end. psi = N / D within 5e-17 for 0 <= mu <= 1, by interpolation at the zeros of
/// Chebyshev's polynomial, in 60 digits; `both` is N + D.
BRDFPLOT_INLINE Quotient<double> lost(double mu) {
  constexpr double below[] = {1.0,
                              0x1.9f156cb129ae4p+1,
                              0x1.046de1d2bd395p+2,
                              0x1.3d8857f8328e3p+1,
                              0x1.81ee4f17e86edp-1,
                              0x1.a93fa3151c8bap-4,
                              0x1.364193dcb3be2p-8};
  constexpr double both[] = {2.0,
                             below[1] + 0x1.3a8d7f6018fb2p+1,
                             below[2] + 0x1.182f91e337188p+1,
                             below[3] + 0x1.b71a2b2730619p-1,
                             below[4] + 0x1.2182892ee94bap-3,
                             below[5] + 0x1.ded50dc8d1e17p-8,
                             below[6] + 0x1.b588aef1f535cp-20};
  const double square = mu * mu, s2 = larger((1 - mu) * (1 + mu), 0.0), s = root(s2);
  const double d = polynomial(below, mu, square), m = polynomial(both, mu, square), denominator = (1 + s) * d;
  const double kept = (2.0 / 3) * (mu + s * (1 + s + s2));
  return {mu * ((s2 * (1 + s)) * m - kept * d + half_pi * mu * denominator), denominator, 0};
}

BRDFPLOT_INLINE Parts eon(const double (&p)[5], const Vector3& o, const Vector3& i, double w) {
  const Quotient<double> v = lost(o.z), l = lost(i.z);
  return {fujii(p[0], o, i, w), v.numerator * l.numerator * w / (v.denominator * l.denominator), 0};
}

/// What the fits of Oren and Nayar see: alpha is the larger polar angle, beta the smaller; theirs above the horizon are
/// what they are short of pi/2. One arcsine each, of the smaller of sine and cosine.
struct Polar {
  double sine, theta, elevation;
};

BRDFPLOT_INLINE Polar polar(const Vector3& d) {
  const double s = root(d.x * d.x + d.y * d.y);
  const double small = arcsine(smaller(s, d.z)), large = half_pi - small;
  return {s, s < d.z ? small : large, s < d.z ? large : small};
}

/// sin alpha sin beta k.
BRDFPLOT_INLINE double horizontal_dot(const Vector3& o, const Vector3& i) { return o.x * i.x + o.y * i.y; }

/// At the normal, where k is undefined, nothing depends on it. sin alpha - (2 beta / pi)^3, which cancels at grazing,
/// by what both are short of 1.
BRDFPLOT_INLINE Parts oren_nayar(const double (&p)[5], const Vector3& o, const Vector3& i, double w) {
  const Polar a = polar(o), b = polar(i);
  const double flat = horizontal_dot(o, i), both = a.sine * b.sine;
  const double k = larger(-1.0, smaller(flat / not_zero(both), 1.0));
  const double low_z = smaller(o.z, i.z), high_z = larger(o.z, i.z);
  const double sin_alpha = larger(a.sine, b.sine);
  const double q = (1 / half_pi) * larger(a.elevation, b.elevation);
  const double backward = q * (3 - q * (3 - q)) - low_z * low_z / (1 + sin_alpha);
  const double along = flat * (w / high_z) * (flat >= 0 ? 1 : backward / not_zero(sin_alpha));
  const double angles = 1 / (half_pi * half_pi) * a.theta * b.theta;
  const double across = (1 - magnitude(k)) * (angles * angles) * ((a.sine + b.sine) * (w / (o.z + i.z)));
  const double half = (1 / half_pi) * smaller(a.theta, b.theta);
  return {p[0] * w + p[1] * along + p[2] * across, p[3] * (1 - k * half * half) * w, 0};
}

BRDFPLOT_INLINE Parts oren_nayar_qualitative(const double (&p)[5], const Vector3& o, const Vector3& i, double w) {
  return {p[0] * w + p[1] * larger(horizontal_dot(o, i), 0.0) * (w / larger(o.z, i.z)), 0, 0};
}

template <FlatTerm term>
BRDFPLOT_INLINE Parts parts_of(const double (&p)[5], const Vector3& o, const Vector3& i, double w) {
  if constexpr (term == FlatTerm::constant) return {w, 0, 0};
  if constexpr (term == FlatTerm::through_normal) return {one_less_fifth(i.z) * w, 0, 0};
  if constexpr (term == FlatTerm::through_both) return {one_less_fifth(i.z) * one_less_fifth(o.z) * w, 0, 0};
  if constexpr (term == FlatTerm::disney) return disney<false>(p, o, i, w);
  if constexpr (term == FlatTerm::disney_printed) return disney<true>(p, o, i, w);
  if constexpr (term == FlatTerm::hammon) return hammon(o, i, w);
  if constexpr (term == FlatTerm::velvet) return velvet(p, o, i, w);
  if constexpr (term == FlatTerm::uncharted2) return uncharted2(p, o.z, w);
  if constexpr (term == FlatTerm::fujii) return {fujii(p[0], o, i, w), 0, 0};
  if constexpr (term == FlatTerm::eon) return eon(p, o, i, w);
  if constexpr (term == FlatTerm::oren_nayar) return oren_nayar(p, o, i, w);
  if constexpr (term == FlatTerm::oren_nayar_qualitative) return oren_nayar_qualitative(p, o, i, w);
  const HalfCosine h = half_cosine(o, i);
  return {(term == FlatTerm::sheen ? fifth(h.one_less_lh) : one_less_fifth(h.one_less_lh, h.lh)) * w, 0, 0};
}

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
