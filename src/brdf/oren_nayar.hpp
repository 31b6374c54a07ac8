/// \file
/// The fits of Oren and Nayar (1994) to the BRDF of V-cavities with diffuse facets.
#pragma once

#include "math/direction.hpp"
#include "math/kernels/flat.hpp"
#include "models/parameters.hpp"

namespace brdfplot {

/// Which of them. All are for V-cavities with the distribution `oren_nayar`, of which they know sigma (radians);
/// written here for albedo 1. With alpha and beta the larger and the smaller polar angle, k the cosine of the
/// difference of azimuths, s = sigma^2:
///   direct          (C1 + k C2 tan beta + (1 - |k|) C3 tan((alpha + beta) / 2)) / pi,
///                   C1 = 1 - s / (2 s + 0.66), C2 = 0.45 s / (s + 0.09) (sin alpha - [k < 0] (2 beta / pi)^3),
///                   C3 = 0.125 s / (s + 0.09) (4 alpha beta / pi^2)^2: stands for Eq. 31 of Heitz 2014
///   full            direct + 0.17 s / (s + 0.13) (1 - k (2 beta / pi)^2) / pi, light that was reflected twice
///   qualitative     (C1 + 0.45 s / (s + 0.09) max(0, k) sin alpha tan beta) / pi
enum class OrenNayarFit { full, direct, qualitative };

/// The kernel that computes a fit, and its parameters. With an albedo A, rho = (A once + A^2 twice) / pi: light that
/// was reflected once, and twice.
kernels::FlatTerm oren_nayar_term(OrenNayarFit fit);
kernels::FlatParameters oren_nayar_parameters(OrenNayarFit fit, double sigma, const Rgb& albedo);

/// Value (1/sr) of albedo 1 at unit vectors above the horizon; 0 elsewhere. Reciprocal. Where both directions are
/// grazing on one side it grows like tan beta; grazing on opposite sides, `direct` is negative for sigma > 2 / 3, as
/// published. Relative error of each term below 1e-14: sin alpha - (2 beta / pi)^3, which cancels at grazing, is taken
/// by the angles above the horizon, and tan((alpha + beta) / 2) by the sines and cosines.
double oren_nayar_brdf(OrenNayarFit fit, double sigma, const Direction& omega_o, const Direction& omega_i);

} // namespace brdfplot
