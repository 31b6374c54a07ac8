/// \file
/// Cloth over arrays of pairs of directions: wrap lighting, and the mirror of Imageworks' sheen. Like kernels.hpp,
/// which says what holds of every kernel.
#pragma once

#include "math/kernels/kernels.hpp"

#include <cstddef>

namespace brdfplot::kernels {

/// scale clamp(scatter + l^+) min((l + w)^+, most) of each channel, l = n.i and clamp(x) = min(max(x, 0), 1): rho l
/// where n.o > 0, below the horizon of the light too; or rho, that over l, and 0 where l <= 0.
struct WrapParameters {
  double w, most;
  double scale[3], scatter[3];
};
void wrap(const WrapParameters& parameters, const double* o_z, const double* i_z, bool times_cosine, int channels,
          double* const* out, std::size_t n);

/// What stands in D / (4 ...) for n.l n.v / G2: fitted, l v (1 + Lambda(l) + Lambda(v)) with the published fit;
/// unmasked, l + v - l v.
enum class SheenMasking { fitted, unmasked };

/// D = (m + 1) / pi sin^(2 m). Lambda(c) = e^L(c) for c < 1/2, e^(2 L(1/2) - L(1 - c)) else,
/// L(x) = a / (1 + b x^power) + d x + e (Estevez and Kulla 2017).
struct SheenParameters {
  double m, a, b, power, d, e;
};

/// The BRDF of mirrors with F = 1, or that times l; 0 where a direction is at or below the horizon. Its logarithm is
/// right within 1e-15 times (1 + |ln sin^(2 m)|).
void sheen_brdf(SheenMasking masking, const SheenParameters& parameters, Vectors<double> o, Vectors<double> i,
                bool times_cosine, double* out, std::size_t n);

} // namespace brdfplot::kernels
