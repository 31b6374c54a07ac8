/// \file
/// One element of the kernels of a single direction: projection, masked area, Lambda. Included once per instruction
/// set, like arithmetic.hpp; kernels.hpp says what they compute.
#pragma once

#include "math/kernels/arithmetic.hpp"
#include "math/kernels/table.hpp"

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

template <class T>
using Constants = detail::StretchConstants<T>;

/// 1 / (4 sqrt(pi))
template <class T>
inline constexpr T quarter_over_root_pi = T(0x1.20dd750429b6dp-3);

template <class T>
struct Vector {
  T x, y, z;
};

/// z - x mean_x - y mean_y, to an error of some 2^-105 of its terms (float: 2^-46): it may cancel to that.
template <class T>
BRDFPLOT_INLINE T projected_area(const Constants<T>& k, const Vector<T>& omega) {
  const T x = -k.mean_x * omega.x, y = -k.mean_y * omega.y;
  const Pair<T> first = sum(omega.z, x), total = sum(first.high, y);
  // What these three and the two products dropped, summed likewise.
  const Pair<T> products = sum(product_low(-k.mean_x, omega.x, x), product_low(-k.mean_y, omega.y, y));
  const Pair<T> with_first = sum(products.high, first.low), with_total = sum(with_first.high, total.low);
  const Pair<T> c = sum(total.high, with_total.high);
  return c.high + (c.low + (products.low + with_first.low + with_total.low));
}

/// c, and the two lengths whose squares sum to s^2.
template <class T>
struct Projected {
  T c;
  Pair<T> along, across;
};

/// `plain`: r = 0 and centred; otherwise the sums that cancel are carried with their rounding errors.
template <bool plain, class T>
BRDFPLOT_INLINE Projected<T> project(const Constants<T>& k, const Vector<T>& omega) {
  if constexpr (plain) {
    return {omega.z, product(omega.x, T(0), k.alpha_x, T(0)), product(omega.y, T(0), k.alpha_y, T(0))};
  } else {
    const Pair<T> skewed = product(omega.y, T(0), k.skew.high, k.skew.low);
    const Pair<T> along = sum_of_product(skewed.high, k.alpha_x, omega.x);
    return {projected_area(k, omega),
            {along.high, along.low + skewed.low},
            product(omega.y, T(0), k.across.high, k.across.low)};
  }
}

/// sqrt(x^2 + y^2) without underflow of the squares, rounded once but for what is twice as small.
template <class T>
BRDFPLOT_INLINE T length(const Pair<T>& x, const Pair<T>& y) {
  const bool small = larger(magnitude(x.high), magnitude(y.high)) < Format<T>::tiny;
  const T up = small ? Format<T>::enlarge : T(1);
  const T down = small ? Format<T>::reduce : T(1);
  const T u = x.high * up, v = y.high * up;
  const T u2 = u * u, v2 = v * v;
  const Pair<T> squares = sum(u2, v2);
  const T u_low = multiply_add(u + u, x.low * up, product_low(u, u, u2));
  const T v_low = multiply_add(v + v, y.low * up, product_low(v, v, v2));
  const T estimate = root(squares.high);
  const T missing = residual(squares.high, estimate, estimate) + (squares.low + (u_low + v_low));
  return (estimate + missing * (T(0.5) / not_zero(estimate))) * down;
}

/// c / s, at most largest_a, where Lambda is zero.
template <class T>
struct Ratio {
  T a, square, square_low; ///< a, a a, and (c / s)^2 - a a to first order
};

/// c >= 0.
template <class T>
BRDFPLOT_INLINE Ratio<T> ratio(T c, T s) {
  const T divisor = not_zero(s);
  const T dividend = smaller(c, Format<T>::largest_a * divisor);
  const T inverse = 1 / divisor;
  const T a = dividend * inverse;
  const T a_low = residual(dividend, a, divisor) * inverse;
  const T square = a * a;
  return {a, square, multiply_add(a + a, a_low, product_low(a, a, square))};
}

/// The same for a ratio that is given as such, not negative.
template <class T>
BRDFPLOT_INLINE Ratio<T> ratio_of(T given) {
  const T a = smaller(given, Format<T>::largest_a);
  const T square = a * a;
  return {a, square, product_low(a, a, square)};
}

/// The last step of the Beckmann masked area, s e^(-a^2) R(a) / (2 sqrt(pi)): the exponential has the factor. What
/// its steps drop is added at the end: a product of two G1 has the errors of two masked areas.
template <class T>
BRDFPLOT_INLINE T masked_area_beckmann(T c, T s, const Exponential<T>& e, const Quotient<T>& r) {
  const T quotient = r.numerator / r.denominator;
  const T missing = multiply_add(-quotient, r.denominator_low, residual(r.numerator, quotient, r.denominator));
  const Pair<T> scale = product(s, T(0), e.value, e.value_low);
  const Pair<T> m = product(scale.high, scale.low, quotient, missing / r.denominator);
  return scaled(m.high + m.low, e.shifted_k) + larger(-c, T(0));
}

/// That of Lambda: infinite for a = 0.
template <class T>
BRDFPLOT_INLINE T lambda_beckmann(T a, const Exponential<T>& e, const Quotient<T>& r) {
  const T m = (e.value * r.numerator) / (a * r.denominator);
  return scaled(m, e.shifted_k);
}

/// sqrt(c^2 + s^2) of the numbers scaled to the larger one.
template <class T>
struct Hypotenuse {
  T c, s, root;
};

template <class T>
BRDFPLOT_INLINE Hypotenuse<T> hypotenuse(T c, T s) {
  const T absolute = magnitude(c);
  const T factor = normalizer(larger(absolute, s));
  const T u = absolute * factor, v = s * factor;
  return {u, v, root_by_products(multiply_add(u, u, v * v))};
}

/// As careful as Beckmann's, but for the root.
template <class T>
BRDFPLOT_INLINE T masked_area_ggx(T c, T s) {
  const Hypotenuse<T> h = hypotenuse(c, s);
  const Pair<T> both = sum(h.c, h.root);
  const T half = T(0.5) * h.s, divisor = not_zero(both.high);
  const T quotient = half / divisor;
  const T missing = multiply_add(-quotient, both.low, residual(half, quotient, divisor));
  // The factor s keeps its size, so that only true underflow is underflow.
  return times(s, quotient, missing / divisor) + larger(-c, T(0));
}

template <class T>
BRDFPLOT_INLINE T lambda_ggx(T c, T s) {
  const Hypotenuse<T> h = hypotenuse(c, s);
  const T lambda = (h.s * h.s) / ((h.c + h.c) * (h.c + h.root));
  return c > 0 ? lambda : T(__builtin_inf());
}

/// `factor` times a Lambda(a) of Walter's fit, a = c / s.
template <class T>
BRDFPLOT_INLINE T walter(T c, T s, T factor) {
  const T u = multiply_add(multiply_add(T(0.396), c, T(-1.259) * s), c, s * s);
  return c < T(1.6) * s ? factor * (u / (s * multiply_add(T(2.181), c, T(3.535) * s))) : T(0);
}

template <class T>
BRDFPLOT_INLINE T masked_area_walter(T c, T s) {
  const T factor = normalizer(s);
  const T scaled_s = not_zero(s * factor);
  return walter(smaller(magnitude(c) * factor, 2 * scaled_s), scaled_s, s) + larger(-c, T(0));
}

template <class T>
BRDFPLOT_INLINE T lambda_walter(T c, T s) {
  const T factor = normalizer(s);
  const T scaled_s = not_zero(s * factor);
  const T scaled_c = smaller(magnitude(c) * factor, 2 * scaled_s);
  return c > 0 ? walter(scaled_c, scaled_s, scaled_s / scaled_c) : T(__builtin_inf());
}

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
