/// \file
/// BRDFs of flat surfaces over arrays of pairs of directions: diffuse and cloth terms, one loop each for all channels.
/// Like kernels.hpp, which says what holds of every kernel.
#pragma once

#include "math/kernels/kernels.hpp"

#include <cstddef>

namespace brdfplot::kernels {

/// What a term is a sum of. With l, v, h the cosines n.l, n.v, l.h, F_c = 1 - (1 - c)^5, w the factor that rho is
/// wanted with (1, or l), p its parameters:
enum class FlatTerm {
  constant,               ///< w
  through_normal,         ///< w F_l
  through_half,           ///< w F_h
  through_both,           ///< w F_l F_v
  disney,                 ///< w ((1 - p1) f_d + 1.25 p1 f_ss), p0 = sqrt(alpha): brdf/terms/diffuse/disney_diffuse.hpp
  disney_printed,         ///< the same with 1 / (l v) for 1 / (l + v)
  sheen,                  ///< w (1 - h)^5
  hammon,                 ///< w F_l F_v; w f_rough: brdf/terms/diffuse/hammon_diffuse.hpp; w
  velvet,                 ///< w F_h; V; (1 - h)^5 V, V = w (p1 + p2 e^(-p0 cot^2) / sin^4) / (4 (l + v - l v)), of n.h
  uncharted2,             ///< w (p0 v^p1 + p2 (1 - v)^p3 + p4), p1, p3 > 0
  fujii,                  ///< w (1 + p0 s / t): brdf/terms/diffuse/eon.hpp
  eon,                    ///< the same; w B(l) B(v), B as there
  oren_nayar,             ///< w (p0 + k C2 tan beta + ...); w p3 (1 - k (2 beta / pi)^2): brdf/oren_nayar.hpp,
                          ///< p1 = C2 / (sin alpha - ...), p2 = C3 / (4 alpha beta / pi^2)^2
  oren_nayar_qualitative, ///< w (p0 + p1 max(0, k) sin alpha tan beta)
};
inline constexpr int flat_terms = static_cast<int>(FlatTerm::oren_nayar_qualitative) + 1;

struct FlatParameters {
  double p[5];
  double factors[3][3]; ///< of each channel, of each part
};

/// Writes the sum of factors times parts into each of `channels` (1 or 3) arrays; 0 where a direction is at or below
/// the horizon. Each part is right within some roundings of what it is at its largest; where w = l it is finite
/// wherever it is determined; sheen within some roundings of itself where |o - i| > 1e-7. constant, through_normal,
/// through_both and oren_nayar_qualitative give the same bytes on every instruction set.
void flat_brdf(FlatTerm term, const FlatParameters& parameters, Vectors<double> o, Vectors<double> i, bool times_cosine,
               int channels, double* const* out, std::size_t n);

} // namespace brdfplot::kernels
