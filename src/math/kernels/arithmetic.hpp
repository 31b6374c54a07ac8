/// \file
/// The arithmetic that the kernels are made of: branch-free functions of one element, float or double. Included once
/// per instruction set, inside a namespace of its own; nothing of the standard library is called, because its inline
/// functions would be compiled for that instruction set and shared with everybody.
#ifndef BRDFPLOT_KERNELS_NAMESPACE
#error "included by the sources of one instruction set only"
#endif
#pragma once

#include "math/beckmann_lambda_coefficients.hpp"
#include "math/kernels/exponential_coefficients.hpp"

#include <cstdint>

#define BRDFPLOT_INLINE [[gnu::always_inline]] static inline
#define BRDFPLOT_INLINE_MEMBER [[gnu::always_inline]]

/// Before a loop: its elements do not depend on each other. Before a short one: it is written out.
#ifdef __clang__
#define BRDFPLOT_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#define BRDFPLOT_UNROLL _Pragma("clang loop unroll(full)")
#else
#define BRDFPLOT_INDEPENDENT _Pragma("GCC ivdep")
#define BRDFPLOT_UNROLL _Pragma("GCC unroll 8")
#endif

#if defined(__FMA__) || defined(__FP_FAST_FMA)
#define BRDFPLOT_KERNELS_FMA 1
#else
#define BRDFPLOT_KERNELS_FMA 0
#endif

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

template <class T>
struct Format;

template <>
struct Format<double> {
  using Bits = std::uint64_t;
  static constexpr int fraction_bits = 52;
  static constexpr Bits exponent_mask = 0x7ff0000000000000;
  static constexpr int bias = 1023;
  static constexpr double integer = 0x1p52; ///< its sum with a small integer has that integer in its last bits
  static constexpr double splitter = 0x1p27 + 1;
  static constexpr double inverse_ln2 = 0x1.71547652b82fep0;
  static constexpr double ln2_high = 0x1.62e42feep-1; ///< short: its product with a small integer is exact
  static constexpr double ln2_low = 0x1.a39ef35793c76p-33;
  /// Squares of numbers below `tiny` are lost; times `enlarge` they are not, and those below 1 do not overflow.
  static constexpr double tiny = 0x1p-480, enlarge = 0x1p540, reduce = 0x1p-540;
  static constexpr int lift = 300; ///< see `scaled`
  static constexpr double lifted_smallest_normal = 0x1p-722;
  static constexpr double largest_a = 30;      ///< s Lambda is zero beyond it for s < 2^200
  static constexpr double nothing = 0x1p-1014; ///< see `not_zero`
};

template <>
struct Format<float> {
  using Bits = std::uint32_t;
  static constexpr int fraction_bits = 23;
  static constexpr Bits exponent_mask = 0x7f800000;
  static constexpr int bias = 127;
  static constexpr float integer = 0x1p23f;
  static constexpr float splitter = 0x1p12f + 1;
  static constexpr float inverse_ln2 = 0x1.715476p0f;
  static constexpr float ln2_high = 0x1.63p-1f;
  static constexpr float ln2_low = -0x1.bd0106p-13f;
  static constexpr float tiny = 0x1p-50f, enlarge = 0x1p80f, reduce = 0x1p-80f;
  static constexpr int lift = 100;
  static constexpr float lifted_smallest_normal = 0x1p-26f;
  static constexpr float largest_a = 11; ///< for s < 2^20
  static constexpr float nothing = 0x1p-126f;
};

template <class T>
using Bits = typename Format<T>::Bits;

template <class T>
BRDFPLOT_INLINE Bits<T> bits(T x) {
  return __builtin_bit_cast(Bits<T>, x);
}
template <class T>
BRDFPLOT_INLINE T from_bits(Bits<T> b) {
  return __builtin_bit_cast(T, b);
}

/// The second where the first is NaN.
template <class T>
BRDFPLOT_INLINE T smaller(T x, T y) {
  return x < y ? x : y;
}
template <class T>
BRDFPLOT_INLINE T larger(T x, T y) {
  return x > y ? x : y;
}

/// x, unless that is 0: a divisor. For x = 0 and x >= 2^-960 (float: 2^-101), which the sum rounds to. It costs one
/// instruction, a maximum several: GCC spreads its comparison over what follows.
template <class T>
BRDFPLOT_INLINE T not_zero(T x) {
  return x + Format<T>::nothing;
}

BRDFPLOT_INLINE double magnitude(double x) { return __builtin_fabs(x); }
BRDFPLOT_INLINE float magnitude(float x) { return __builtin_fabsf(x); }
BRDFPLOT_INLINE double root(double x) { return __builtin_sqrt(x); }
BRDFPLOT_INLINE float root(float x) { return __builtin_sqrtf(x); }

#if BRDFPLOT_KERNELS_FMA
BRDFPLOT_INLINE double multiply_add(double x, double y, double z) { return __builtin_fma(x, y, z); }
BRDFPLOT_INLINE float multiply_add(float x, float y, float z) { return __builtin_fmaf(x, y, z); }

/// x y - product, exactly, for the rounded product.
template <class T>
BRDFPLOT_INLINE T product_low(T x, T y, T product) {
  return multiply_add(x, y, -product);
}

/// x - y z, rounded once.
template <class T>
BRDFPLOT_INLINE T residual(T x, T y, T z) {
  return multiply_add(-y, z, x);
}

/// x (k + k_low), rounded once but for what is twice as small.
template <class T>
BRDFPLOT_INLINE T times(T x, T k, T k_low) {
  return multiply_add(x, k, x * k_low);
}
#else
/// Without the instruction a fused multiply-add is a function call; two roundings then have to do.
template <class T>
BRDFPLOT_INLINE T multiply_add(T x, T y, T z) {
  return x * y + z;
}

/// x y - product, exactly, for the rounded product (Dekker 1971).
template <class T>
BRDFPLOT_INLINE T product_low(T x, T y, T product) {
  const T x_big = Format<T>::splitter * x, y_big = Format<T>::splitter * y;
  const T x_high = x_big - (x_big - x), y_high = y_big - (y_big - y);
  const T x_low = x - x_high, y_low = y - y_high;
  return ((x_high * y_high - product) + x_high * y_low + x_low * y_high) + x_low * y_low;
}

/// x - y z for a z near x / y, as if rounded once.
template <class T>
BRDFPLOT_INLINE T residual(T x, T y, T z) {
  const T product = y * z;
  return (x - product) - product_low(y, z, product);
}

/// x (k + k_low), rounded once but for what is twice as small.
template <class T>
BRDFPLOT_INLINE T times(T x, T k, T k_low) {
  const T product = x * k;
  return product + (product_low(x, k, product) + x * k_low);
}
#endif

/// x + y = sum + what this returns, exactly (Knuth).
template <class T>
BRDFPLOT_INLINE T sum_low(T x, T y, T sum) {
  const T y_part = sum - x;
  return (x - (sum - y_part)) + (y - y_part);
}

/// A number in about twice the working precision.
template <class T>
struct Pair {
  T high, low;
};

template <class T>
BRDFPLOT_INLINE Pair<T> sum(T x, T y) {
  const T high = x + y;
  return {high, sum_low(x, y, high)};
}

/// x + y z.
template <class T>
BRDFPLOT_INLINE Pair<T> sum_of_product(T x, T y, T z) {
  const T product = y * z;
  const Pair<T> total = sum(x, product);
  return {total.high, total.low + product_low(y, z, product)};
}

/// (x + x_low) (k + k_low), rounded once but for what is twice as small.
template <class T>
BRDFPLOT_INLINE Pair<T> product(T x, T x_low, T k, T k_low) {
  const T high = x * k;
  return {high, product_low(x, k, high) + multiply_add(x, k_low, x_low * k)};
}

/// c[first] + c[first + 2] x + c[first + 4] x^2 + ...
template <std::size_t first, class T, std::size_t size>
BRDFPLOT_INLINE T every_other(const T (&c)[size], T x) {
  constexpr std::size_t last = first + (size - 1 - first) / 2 * 2;
  T total = c[last];
  BRDFPLOT_UNROLL
  for (std::size_t i = last; i > first; i -= 2) total = multiply_add(total, x, c[i - 2]);
  return total;
}

/// c[0] + c[1] x + c[2] x^2 + ... as two chains, of the even and of the odd powers: one alone would leave the processor
/// waiting for each step. `square` is x x.
template <class T, std::size_t size>
BRDFPLOT_INLINE T polynomial(const T (&c)[size], T x, T square) {
  return multiply_add(every_other<1>(c, square), x, every_other<0>(c, square));
}

/// sqrt(x) by multiplications, error below 1 ulp, for x = 0 and normal x: where the divider, which also extracts roots,
/// is the bottleneck and the multipliers wait. The first guess of 1 / sqrt(x) is half the exponent, negated; each of
/// two steps raises its error to the fourth power.
BRDFPLOT_INLINE double root_by_products(double x) {
#if BRDFPLOT_KERNELS_FMA
  const double guess = from_bits<double>(0x5fe6eb50c7b537a9 - (bits(x) >> 1));
  const double first = x * guess;
  const double e = multiply_add(-first, guess, 1.0);
  const double inverse = multiply_add(multiply_add(multiply_add(0.3125, e, 0.375), e, 0.5) * e, guess, guess);
  const double second = x * inverse;
  const double f = multiply_add(-second, inverse, 1.0);
  return multiply_add(multiply_add(multiply_add(0.3125, f, 0.375), f, 0.5) * f, second, second);
#else
  return root(x);
#endif
}

/// In float there is nothing to gain.
BRDFPLOT_INLINE float root_by_products(float x) { return root(x); }

/// The power of two that brings x into [1/2, 1). 0 and subnormal numbers get that of the smallest normal one.
/// 0 <= x < 2^1000 (float: 2^100).
template <class T>
BRDFPLOT_INLINE T normalizer(T x) {
  constexpr Bits<T> top = static_cast<Bits<T>>(2 * Format<T>::bias - 1) << Format<T>::fraction_bits;
  return from_bits<T>(top - (bits(x) & Format<T>::exponent_mask));
}

/// An integer k, as the sum with 1.5 2^52 (float: 2^23) that rounded to it: its last bits are those of k.
template <class T>
inline constexpr T integer_shift = T(1.5) * Format<T>::integer;

/// The exponent bits of such a k, modulo their width.
template <class T>
BRDFPLOT_INLINE Bits<T> exponent_bits(T shifted_k) {
  return bits(shifted_k) << Format<T>::fraction_bits;
}

/// m 2^k for an integer -1300 <= k <= 0 (float: -180), given as its shifted sum, and m >= 0; unless k = 0, 2^-700 < m
/// (float: 2^-40). A multiplication whose result is subnormal costs the processor a hundred cycles and more. Here it is
/// made 2^lift times too large, where it is normal, and rounded by adding the smallest normal number, as large: the
/// bits of the subnormal result are those of the sum less those of that number.
template <class T>
BRDFPLOT_INLINE T scaled(T m, T shifted_k) {
  using F = Format<T>;
  constexpr Bits<T> lifted_one = static_cast<Bits<T>>(F::bias + F::lift) << F::fraction_bits;
  const Bits<T> k = exponent_bits(shifted_k);
  const T lifted = m * from_bits<T>(k + lifted_one);
  const Bits<T> subnormal = bits(lifted + F::lifted_smallest_normal) - bits(F::lifted_smallest_normal);
  return from_bits<T>(lifted < F::lifted_smallest_normal ? subnormal : bits(m) + k);
}

/// factor e^(x + low) = value 2^k, x <= 0 and low tiny: value in [0.7, 1.42] factor, relative error below 1 ulp, k as
/// its shifted sum. The low part joins the reduced argument, where it costs nothing, and the factor the last addition.
template <class T>
struct Exponential {
  T value, shifted_k;
  T value_low; ///< what the last addition dropped
};

template <class T>
BRDFPLOT_INLINE Exponential<T> exponential(T x, T low, T factor) {
  using F = Format<T>;
  const T shifted_k = multiply_add(x, F::inverse_ln2, integer_shift<T>);
  const T k = shifted_k - integer_shift<T>;
  const T r = multiply_add(-k, F::ln2_high, x) + multiply_add(-k, F::ln2_low, low);
  const T square = r * r;
  const T less_one = multiply_add(square, polynomial(ExponentialFit<T>::g, r, square), r);
  const T value = multiply_add(less_one, factor, factor);
  return {value, shifted_k, multiply_add(less_one, factor, factor - value)};
}

/// a Lambda(a) e^(a^2) 4 sqrt(pi) = numerator / denominator of the Beckmann distribution: twice the R of
/// microfacet/beckmann_lambda.hpp. `square` is a a, rounded, and `square_low` what it lacks of the true square.
template <class T>
struct Quotient {
  T numerator, denominator;
  T denominator_low; ///< what the last addition to the denominator dropped
};

/// Half the coefficients N of that R, which saves doubling the other terms of its denominator.
template <class T>
struct HalfNumerator {
  static constexpr std::size_t size = sizeof(BeckmannLambdaFit<T>::numerator) / sizeof(T);
  T values[size] = {};
  constexpr HalfNumerator() {
    for (std::size_t k = 0; k < size; ++k) values[k] = BeckmannLambdaFit<T>::numerator[k] / 2;
  }
};
template <class T>
inline constexpr HalfNumerator<T> half_numerator;

template <class T>
BRDFPLOT_INLINE Quotient<T> scaled_beckmann_lambda(T a, T square, T square_low) {
  const T half_n = polynomial(half_numerator<T>.values, a, square);
  const T m = polynomial(BeckmannLambdaFit<T>::denominator, a, square);
  const T square_plus_half = multiply_add(a, a, T(0.5));
  const T rest = multiply_add(square_low, m, a * half_n);
  const T denominator = multiply_add(square_plus_half, m, rest);
  const T main = square_plus_half * m;
  return {m, denominator, (main - denominator) + rest + product_low(square_plus_half, m, main)};
}

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
