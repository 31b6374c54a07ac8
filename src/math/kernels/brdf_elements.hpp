/// \file
/// One element of the densities and of the BRDFs: the half vector, the two sides, and one quotient. Included once per
/// instruction set, like arithmetic.hpp; kernels.hpp says what they compute. All of it is double: for arrays of float
/// the errors of some forty operations in float would add up to more than 8 ulp.
#pragma once

#include "math/kernels/elements.hpp"

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

using Vector3 = Vector<double>;

BRDFPLOT_INLINE double times(double x, const detail::Constant<double>& k) { return times(x, k.high, k.low); }

BRDFPLOT_INLINE double times(double x, double x_low, const detail::Constant<double>& k) {
  const Pair<double> result = product(x, x_low, k.high, k.low);
  return result.high + result.low;
}

/// z^2 |u|^2 of the normal m + low, the scaled norm of Heitz 2014, Eq. 95.
template <bool plain>
BRDFPLOT_INLINE double scaled_norm2(const Constants<double>& k, const Vector3& m, const Vector3& low) {
  if constexpr (plain) {
    const double u = times(m.x, k.inverse_x), v = times(m.y, k.inverse_y);
    return multiply_add(u, u, v * v);
  } else {
    const Pair<double> u = sum_of_product(m.x, k.mean_x, m.z), v = sum_of_product(m.y, k.mean_y, m.z);
    const double u_low = u.low + multiply_add(k.mean_x, low.z, low.x);
    const double v_low = v.low + multiply_add(k.mean_y, low.z, low.y);
    const double skewed = -k.skew.high * u.high;
    const Pair<double> w = sum_of_product(skewed, k.alpha_x, v.high);
    const double w_low = w.low - (product_low(k.skew.high, u.high, -skewed) + k.skew.low * u.high) +
                         multiply_add(k.alpha_x, v_low, -k.skew.high * u_low);
    const double p = times(u.high, u_low, k.inverse_x), q = times(w.high, w_low, k.inverse_det);
    return multiply_add(p, p, q * q);
  }
}

/// e^(-n2 / z2) and 1 / z2. Where n2 / z2 > 900 the exponential is taken for zero, and z2 larger, which keeps its
/// inverse finite.
struct SlopeExponential {
  Exponential<double> e;
  double inverse_z2;
};

BRDFPLOT_INLINE SlopeExponential slope_exponential(double n2, double z) {
  const double z2 = z * z, least = n2 * (1.0 / 900);
  const double inverse = 1 / larger(z2, least);
  const Exponential<double> e = exponential(-(n2 * inverse), 0.0, 1.0);
  return {{z2 < least ? 0 : e.value, e.shifted_k, 0}, inverse};
}

template <bool plain>
BRDFPLOT_INLINE double d_beckmann(const Constants<double>& k, const Vector3& m) {
  const SlopeExponential s = slope_exponential(scaled_norm2<plain>(k, m, Vector3{}), m.z);
  const double d = scaled(((k.inverse_pi_det * s.inverse_z2) * s.inverse_z2) * s.e.value, s.e.shifted_k);
  return m.z > 0 ? d : 0;
}

template <bool plain>
BRDFPLOT_INLINE double d_ggx(const Constants<double>& k, const Vector3& m) {
  const double t = multiply_add(m.z, m.z, scaled_norm2<plain>(k, m, Vector3{}));
  const double d = 1 / ((k.pi_det * t) * t);
  return m.z > 0 ? d : 0;
}

/// omega_o + omega_i, scaled by a power of two to be neither tiny nor huge: D |h|^4 does not depend on its length.
struct HalfVector {
  Vector3 h, low; ///< and what rounding dropped of the sums
  double norm2;
};

template <bool plain>
BRDFPLOT_INLINE HalfVector half_vector(const Vector3& o, const Vector3& i) {
  const double x = o.x + i.x, y = o.y + i.y, z = o.z + i.z;
  const double f = normalizer(larger(magnitude(x), larger(magnitude(y), magnitude(z))));
  const Vector3 h{x * f, y * f, z * f};
  const double norm2 = multiply_add(h.x, h.x, multiply_add(h.y, h.y, h.z * h.z));
  // The dropped parts matter only where a sheared or correlated distribution subtracts components from each other.
  if constexpr (plain) return {h, {}, norm2};
  return {h, {sum_low(o.x, i.x, x) * f, sum_low(o.y, i.y, y) * f, sum_low(o.z, i.z, z) * f}, norm2};
}

template <bool plain>
BRDFPLOT_INLINE double squared_roughness(const Projected<double>& p) {
  const double along = plain ? p.along.high : p.along.high + p.along.low;
  const double across = plain ? p.across.high : p.across.high + p.across.low;
  return multiply_add(along, along, across * across);
}

/// With v = sqrt(c^2 + s^2) of either side, tau = (v - c) / 2: c_o c_i + c_i tau_o + c_o tau_i = (c_i v_o + c_o v_i) /
/// 2 and c + tau = (c + v) / 2. Nothing is subtracted, and tau itself is never formed.
template <Shadowing shadowing>
BRDFPLOT_INLINE double twice_inverse_visibility(double c_o, double v_o, double c_i, double v_i) {
  if constexpr (shadowing == Shadowing::none) return c_i * (c_o + v_o);
  if constexpr (shadowing == Shadowing::separable) return 0.5 * (c_o + v_o) * (c_i + v_i);
  if constexpr (shadowing == Shadowing::minimum) return larger(c_i * (c_o + v_o), c_o * (c_i + v_i));
  return multiply_add(c_i, v_o, c_o * v_i);
}

/// |h|^4 / (2 pi det (h_z^2 + N2)^2 (twice the inverse of G2 / (c_o c_i))): one division.
template <Shadowing shadowing, bool plain>
BRDFPLOT_INLINE double brdf_ggx(const Constants<double>& k, const Vector3& o, const Vector3& i) {
  const HalfVector half = half_vector<plain>(o, i);
  const Projected<double> p_o = project<plain>(k, o), p_i = project<plain>(k, i);
  // One root by the divider, one by the multipliers: at the same time.
  const double v_o = root_by_products(multiply_add(p_o.c, p_o.c, squared_roughness<plain>(p_o)));
  const double v_i = shadowing == Shadowing::none ? 0 : root(multiply_add(p_i.c, p_i.c, squared_roughness<plain>(p_i)));
  const double t = multiply_add(half.h.z, half.h.z, scaled_norm2<plain>(k, half.h, half.low));
  const double inverse = twice_inverse_visibility<shadowing>(p_o.c, v_o, p_i.c, v_i);
  const double value = (half.norm2 * half.norm2) / (((2 * k.pi_det) * t) * (t * inverse));
  const bool lit = (p_o.c > 0) & (p_i.c > 0) & (half.h.z > 0);
  return lit ? value : 0;
}

/// What the masking of one direction is computed from.
struct BeckmannInput {
  double c, s, a;
};

/// The first step of the Beckmann BRDF: both sides' a, and e^(-N2 / h_z^2) (|h| / h_z)^4 / (4 pi det), which is
/// factor 2^k. The factor is zero where the half vector is undefined or points below the surface.
struct BeckmannGeometry {
  BeckmannInput o, i;
  double factor, shifted_k;
};

template <bool plain>
BRDFPLOT_INLINE BeckmannGeometry beckmann_geometry(const Constants<double>& k, const Vector3& o, const Vector3& i) {
  const HalfVector half = half_vector<plain>(o, i);
  const Projected<double> p_o = project<plain>(k, o), p_i = project<plain>(k, i);
  const double s_o = larger(root(squared_roughness<plain>(p_o)), 0x1p-200);
  const double s_i = larger(root(squared_roughness<plain>(p_i)), 0x1p-200);
  const double inverse = 1 / (s_o * s_i);
  const SlopeExponential s = slope_exponential(scaled_norm2<plain>(k, half.h, half.low), half.h.z);
  const double secant2 = half.norm2 * s.inverse_z2;
  const double factor = (((0.25 * k.inverse_pi_det) * secant2) * secant2) * s.e.value;
  return {{p_o.c, s_o, (p_o.c * s_i) * inverse},
          {p_i.c, s_i, (p_i.c * s_o) * inverse},
          half.h.z > 0 ? factor : 0,
          s.e.shifted_k};
}

/// tau = area / denominator; the division is left to the end.
struct BeckmannSide {
  double area, denominator;
};

/// No compensation for the rounding of a: where e^(-a^2) magnifies it, Lambda is nothing beside the 1 of 1 + Lambda.
/// For the same reason a need not exceed 26, where e^(-a^2) is still normal.
BRDFPLOT_INLINE BeckmannSide beckmann_side(double s, double a_unbounded) {
  const double a = smaller(magnitude(a_unbounded), 26.0);
  const double square = a * a;
  const Quotient<double> r = scaled_beckmann_lambda(a, square, 0.0);
  const Exponential<double> e = exponential(-square, 0.0, quarter_over_root_pi<double>);
  const auto gauss = from_bits<double>(bits(e.value) + exponent_bits(e.shifted_k));
  return {s * (gauss * r.numerator), r.denominator};
}

/// G2 / (c_o c_i) = high / low, without a division.
template <Shadowing shadowing>
BRDFPLOT_INLINE Pair<double> visibility(double c_o, const BeckmannSide& o, double c_i, const BeckmannSide& i) {
  const double u_o = multiply_add(c_o, o.denominator, o.area);
  if constexpr (shadowing == Shadowing::none) return {o.denominator, c_i * u_o};
  const double u_i = multiply_add(c_i, i.denominator, i.area);
  const double both = o.denominator * i.denominator;
  if constexpr (shadowing == Shadowing::separable) return {both, u_o * u_i};
  const double first = c_i * i.denominator * u_o;
  if constexpr (shadowing == Shadowing::minimum) return {both, larger(first, c_o * o.denominator * u_i)};
  return {both, multiply_add(c_o * o.denominator, i.area, first)};
}

/// The last step of the Beckmann BRDF.
template <Shadowing shadowing>
BRDFPLOT_INLINE double brdf_beckmann(const BeckmannGeometry& g, const BeckmannSide& o, const BeckmannSide& i) {
  const Pair<double> v = visibility<shadowing>(g.o.c, o, g.i.c, i);
  const double value = scaled((g.factor * v.high) / v.low, g.shifted_k);
  const bool lit = (g.o.c > 0) & (g.i.c > 0);
  return lit ? value : 0;
}

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
