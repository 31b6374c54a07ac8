/// \file
/// The loops of the reflectances over arrays of cosines. Included once per instruction set, like loops.hpp.
#pragma once

#include "math/kernels/fresnel_elements.hpp"

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

template <double (*reflectance)(const detail::IndexConstants&, double)>
void over_cosines(const detail::IndexConstants& constants, const double* __restrict c, double* __restrict f,
                  std::size_t n) {
  const detail::IndexConstants k = constants;
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) f[j] = reflectance(k, c[j]);
}

template <bool fifth>
void schlick_all(const detail::SchlickConstants& constants, const double* __restrict c, double* __restrict f,
                 std::size_t n) {
  const detail::SchlickConstants k = constants;
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) {
    const Grazing grazing = fifth ? fifth_power(c[j]) : power(c[j], k.exponent);
    f[j] = k.f0 * grazing.complement + k.f90 * grazing.power;
  }
}

constexpr detail::FresnelKernels fresnel_kernels() {
  return {over_cosines<dielectric>, over_cosines<conductor>, {schlick_all<false>, schlick_all<true>}};
}

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
