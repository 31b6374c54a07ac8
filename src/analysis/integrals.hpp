/// \file
/// The integrals of a material that Heitz 2014 uses as tests, and what a renderer asks of it.
///
/// All are taken in the slopes of the microfacets, scaled by the roughness and turned so that the first axis points
/// along the viewer's azimuth. There the distribution has unit width whatever alpha is, the horizon of masking is the
/// line u_1 = a, the V-cavity's kink is the line u_1 = -a, and the horizon of the light is a conic: every integrand is
/// smooth between known limits.
#pragma once

#include "brdf/evaluate.hpp"
#include "math/quadrature.hpp"

#include <string>
#include <vector>

namespace brdfplot {

enum class Integral {
  projected_area,    ///< int G1(o,m) <o,m> D(m) dm, Eq. 13; cos theta_o when the masking function conserves area
  visible_norm,      ///< int D_o(m) dm, Eq. 18
  weak_furnace,      ///< int G1(o,h) D(h) / (4 c_o) di over the whole sphere, Eq. 36
  furnace,           ///< int rho cos theta_i di with F = 1, Eq. 34
  albedo,            ///< int rho cos theta_i di
  weak_furnace_grid, ///< Eq. 36 as Appendix C sums it: a grid of 0.05 rad
  mean_theta_i,      ///< polar angle of the mean direction of reflected light, signed in the plane of incidence
  peak_theta_i,      ///< where rho cos theta_i is largest in the plane of incidence, signed
  brdf_peak_theta_i, ///< where rho is: beyond the mirror direction where there is an off-specular peak
  mean_fresnel,      ///< int F(o.m) D_o(m) dm, Eq. 105
  average_fresnel,   ///< 2 int F(c) c dc, the same at every viewer (RTR4, Eq. 9.58)
};

struct IntegralInfo {
  Integral integral;
  std::string name;
  std::string doc;
  bool coloured; ///< has as many channels as the material
};

const std::vector<IntegralInfo>& integrals();

inline constexpr double default_tolerance = 1e-9;

/// An integral at omega_o (unit length). 0 at and below the horizon of the mesosurface. `tolerance` is absolute, for
/// values of order 1 (projected_area: relative to c_o). `channel` selects red, green or blue of a coloured one.
/// projected_area, visible_norm, weak_furnace, mean_fresnel and average_fresnel are of a microsurface, the furnace of a
/// term: of the one of this name, or of the only one; the others are of the material, or of the term that is named.
/// The estimate's error is meant to bound the true one, and did in all but 1 of 8,745 random integrals;
/// weak_furnace_grid has none (0).
/// \throws InputError where there is no such term, or several
Estimate compute(Integral integral, const Material& material, const Direction& omega_o,
                 double tolerance = default_tolerance, int channel = 0, const std::string& term = "");

/// compute() without the short cut: projected_area, visible_norm and weak_furnace of a masking function with a Lambda
/// are one-dimensional, since G1 does not depend on the normal (see visible_area.hpp); here they are integrated over
/// the plane of slopes as all the others, which tests the evaluation itself.
Estimate compute_in_plane(Integral integral, const Material& material, const Direction& omega_o,
                          double tolerance = default_tolerance, int channel = 0, const std::string& term = "");

/// compute() of every channel that the integral has: an albedo as one integral of all.
ColourEstimate compute_channels(Integral integral, const Material& material, const Direction& omega_o, double tolerance,
                                const std::string& term = "");

/// compute() and compute_channels(), or AccuracyError when the error estimate is above the tolerance.
double compute_or_throw(Integral integral, const Material& material, const Direction& omega_o, double tolerance,
                        int channel = 0, const std::string& term = "");
Rgb compute_channels_or_throw(Integral integral, const Material& material, const Direction& omega_o, double tolerance,
                              const std::string& term = "");

/// \throws InputError when the material has no such integral: compute()'s reasons.
void require(const Material& material, const IntegralInfo& info, const std::string& term = "");

} // namespace brdfplot
