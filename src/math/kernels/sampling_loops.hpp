/// \file
/// The loops of directions mirrored at visible normals. Included once per instruction set, like loops.hpp.
#pragma once

#include "math/kernels/loops.hpp"
#include "math/kernels/sampling_elements.hpp"

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

/// The density of slopes 1 / (pi (1 + t^2)^2) needs |m|^4 / (h^2 + (h t)^2)^2, from one division.
inline void mirror_ggx(const detail::VisibleConstants& constants, const double* __restrict u1,
                       const double* __restrict u2, const MirroredAtNormals& out, std::size_t n) {
  const detail::VisibleConstants k = constants;
  const MirroredAtNormals to = out;
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) {
    const SeenSlope s = ggx_slope(k, u1[j], u2[j]);
    const MirroredAt m = normal_of(k, s);
    const double t = multiply_add(s.facing, s.facing, multiply_add(s.across, s.across, s.h * s.h));
    const double inverse = 1 / (m.norm2 * t), inverse_norm2 = inverse * t, ratio = m.norm2 * (inverse * m.norm2);
    store_mirrored(k, m, inverse_norm2, to, j);
    to.pdf[j] = k.density * (ratio * ratio);
  }
}

inline void mirror_beckmann(const detail::VisibleConstants& constants, const double* __restrict u1,
                            const double* __restrict u2, const MirroredAtNormals& out, std::size_t n) {
  const detail::VisibleConstants k = constants;
  const MirroredAtNormals to = out;
  Column<double> x, wanted, across;
  for (std::size_t first = 0; first < n; first += block_size) {
    const std::size_t size = n - first < block_size ? n - first : block_size;
    BRDFPLOT_INDEPENDENT
    for (std::size_t j = 0; j < size; ++j) across[j] = gaussian(u2[first + j]);
    BRDFPLOT_INDEPENDENT
    for (std::size_t j = 0; j < size; ++j) {
      const Facing guess = first_facing(k, u1[first + j]);
      x[j] = guess.x, wanted[j] = guess.wanted;
    }
    for (int step = 0; step < 2; ++step) {
      BRDFPLOT_INDEPENDENT
      for (std::size_t j = 0; j < size; ++j) x[j] = facing_step(k, {x[j], wanted[j]});
    }
    BRDFPLOT_INDEPENDENT
    for (std::size_t j = 0; j < size; ++j) {
      const MirroredAt m = normal_of(k, {x[j], across[j], 1});
      store_mirrored(k, m, 1 / m.norm2, to, first + j);
      const double e = normal_exponential(-multiply_add(x[j], x[j], across[j] * across[j]));
      to.pdf[first + j] = k.density * e * (m.norm2 * m.norm2);
    }
  }
}

constexpr detail::SamplingKernels sampling_kernels() { return {{mirror_beckmann, mirror_ggx}}; }

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
