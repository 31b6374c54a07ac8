/// \file
/// The loops of directions. Included once per instruction set, like loops.hpp; directions.hpp says what they compute.
#pragma once

#include "math/kernels/arithmetic.hpp"
#include "math/kernels/table.hpp"

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

inline void half_vectors_of(Vectors<double> o, Vectors<double> i, double* __restrict x, double* __restrict y,
                            double* __restrict z, std::size_t n) {
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) {
    const double sum_x = o.x[j] + i.x[j], sum_y = o.y[j] + i.y[j], sum_z = o.z[j] + i.z[j];
    const double norm2 = sum_x * sum_x + sum_y * sum_y + sum_z * sum_z; // of unit vectors: 0 or no less than 1e-33
    const double inverse = 1 / root(not_zero(norm2)), scale = norm2 > 0 ? inverse : 0;
    x[j] = sum_x * scale;
    y[j] = sum_y * scale;
    z[j] = sum_z * scale;
  }
}

inline void careful_dots_of(Vectors<double> u, Vectors<double> v, double* __restrict out, std::size_t n) {
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) {
    const double x = u.x[j] * v.x[j], y = u.y[j] * v.y[j], z = u.z[j] * v.z[j], xy = x + y, xyz = xy + z;
    const double products =
        product_low(u.x[j], v.x[j], x) + product_low(u.y[j], v.y[j], y) + product_low(u.z[j], v.z[j], z);
    out[j] = xyz + (sum_low(x, y, xy) + sum_low(xy, z, xyz) + products);
  }
}

constexpr detail::DirectionKernels direction_kernels() { return {half_vectors_of, careful_dots_of}; }

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
