/// \file
/// Cloth, one pair and the loops over arrays. Included once per instruction set, like loops.hpp; cloth.hpp says what
/// they compute.
#pragma once

#include "math/kernels/cloth.hpp"
#include "math/kernels/flat_elements.hpp"

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

template <bool times_cosine, bool rgb>
void wrap_all(const WrapParameters& parameters, const double* o_z, const double* i_z, double* const* out,
              std::size_t n) {
  const WrapParameters k = parameters;
  double* __restrict const red = out[0];
  double* __restrict const green = rgb ? out[1] : nullptr;
  double* __restrict const blue = rgb ? out[2] : nullptr;
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) {
    const double l = i_z[j], up = larger(l, 0.0);
    const bool lit = (o_z[j] > 0) & (times_cosine | (l > 0));
    const double wrapped = smaller(larger(l + k.w, 0.0), k.most), light = times_cosine ? wrapped : wrapped / l;
    const double red_value = k.scale[0] * smaller(k.scatter[0] + up, 1.0) * light;
    red[j] = lit ? red_value : 0;
    if constexpr (rgb) {
      const double green_value = k.scale[1] * smaller(k.scatter[1] + up, 1.0) * light;
      const double blue_value = k.scale[2] * smaller(k.scatter[2] + up, 1.0) * light;
      green[j] = lit ? green_value : 0;
      blue[j] = lit ? blue_value : 0;
    }
  }
}

/// sin^(2 m) of the half vector, by 1 - z^2 where that is near 1.
BRDFPLOT_INLINE double power_of_sine(const Vector3& o, const Vector3& i, double m) {
  const HalfSquares h = half_squares(o, i);
  const double total = h.across2 + h.z2, inverse = 1 / not_zero(total);
  const double z2 = h.z2 * inverse, near_one = 1 - z2;
  const bool low = z2 < 0.5;
  const double u = low ? near_one : larger(h.across2 * inverse, 0x1p-1000), rest = low ? (1 - near_one) - z2 : 0;
  const double value = exponential_or_none(smaller(rounded_logarithm(u, rest) * m, 0.0));
  return h.across2 > 0 ? value : 0;
}

/// 1 + Lambda(c) is finite down to c = 0.
BRDFPLOT_INLINE double fitted_lambda(const SheenParameters& k, double at_half, double c) {
  const bool low = c < 0.5;
  const double x = low ? c : larger(1 - c, 0.0);
  const double power = normal_exponential(rounded_logarithm(larger(x, 0x1p-1000), 0.0) * k.power);
  const double l = k.a / (1 + k.b * (x > 0 ? power : 0)) + (k.d * x + k.e);
  return normal_exponential(low ? l : at_half + at_half - l);
}

template <SheenMasking masking, bool times_cosine>
void sheen_all(const SheenParameters& parameters, double at_half, Vectors<double> o, Vectors<double> i, double* out,
               std::size_t n) {
  const SheenParameters k = parameters;
  const double scale = (k.m + 1) * (0.25 / (half_pi + half_pi));
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) {
    const Vector3 viewer{o.x[j], o.y[j], o.z[j]}, light{i.x[j], i.y[j], i.z[j]};
    const double v = viewer.z, l = light.z, d = scale * power_of_sine(viewer, light, k.m);
    double value = 0;
    if constexpr (masking == SheenMasking::unmasked) {
      value = d * ((times_cosine ? l : 1) / (l + v * (1 - l)));
    } else {
      const double lambdas = fitted_lambda(k, at_half, v) + fitted_lambda(k, at_half, l);
      value = d / (v * (1 + lambdas) * (times_cosine ? 1 : l));
    }
    const bool lit = (v > 0) & (l > 0) & (d > 0);
    out[j] = lit ? value : 0;
  }
}

constexpr detail::ClothKernels cloth_kernels() {
  return {{{wrap_all<false, false>, wrap_all<false, true>}, {wrap_all<true, false>, wrap_all<true, true>}},
          {{sheen_all<SheenMasking::fitted, false>, sheen_all<SheenMasking::fitted, true>},
           {sheen_all<SheenMasking::unmasked, false>, sheen_all<SheenMasking::unmasked, true>}}};
}

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
