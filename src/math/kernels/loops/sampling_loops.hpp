/// \file
/// The loops of directions mirrored at visible normals. Included once per instruction set, like loops.hpp.
#pragma once

#include "math/kernels/loops/loops.hpp"
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

/// Unit slopes at right angles to the viewer, of at most block_size numbers.
inline void slopes_across(const double* __restrict u2, double* __restrict across, std::size_t size) {
  Column<double> guess;
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) guess[j] = first_erfc_inverse(both_tails(u2[j]));
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) across[j] = gaussian(guess[j], u2[j]);
}

/// Those towards the viewer.
inline void slopes_facing(const detail::VisibleConstants& constants, const double* __restrict u1,
                          double* __restrict facing, std::size_t size) {
  const detail::VisibleConstants k = constants;
  Column<double> erfc, guess, wanted, part, e, close;
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) erfc[j] = first_erfc(k, u1[j]);
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) guess[j] = first_facing(k, erfc[j], u1[j]);
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) wanted[j] = wanted_root(u1[j]);
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) {
    const FacingShare share = share_at(k, guess[j]);
    part[j] = share.part, e[j] = share.e;
  }
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) close[j] = facing_step(k, guess[j], {part[j], e[j]}, wanted[j]);
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) facing[j] = last_facing_step(k, close[j], u1[j]);
}

/// In short loops: what one slope takes is a chain of hundreds of operations that wait for each other, and a processor
/// does not look far enough ahead to work on the next slopes meanwhile. One loop takes half as long again.
inline void mirror_beckmann(const detail::VisibleConstants& constants, const double* __restrict u1,
                            const double* __restrict u2, const MirroredAtNormals& out, std::size_t n) {
  const detail::VisibleConstants k = constants;
  const MirroredAtNormals to = out;
  Column<double> facing, across;
  for (std::size_t first = 0; first < n; first += block_size) {
    const std::size_t size = n - first < block_size ? n - first : block_size;
    slopes_facing(k, u1 + first, facing.values, size);
    slopes_across(u2 + first, across.values, size);
    BRDFPLOT_INDEPENDENT
    for (std::size_t j = 0; j < size; ++j) {
      const MirroredAt m = normal_of(k, {facing[j], across[j], 1});
      store_mirrored(k, m, 1 / m.norm2, to, first + j);
      const double e = normal_exponential(-multiply_add(facing[j], facing[j], across[j] * across[j]));
      to.pdf[first + j] = k.density * e * (m.norm2 * m.norm2);
    }
  }
}

constexpr detail::SamplingKernels sampling_kernels() { return {{mirror_beckmann, mirror_ggx}}; }

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
