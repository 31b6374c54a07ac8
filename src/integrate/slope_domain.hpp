/// \file
/// Integration over the normals in scaled slope coordinates.
#pragma once

#include "integrate/slope_frame.hpp"
#include "math/quadrature.hpp"

#include <functional>
#include <vector>

namespace brdfplot {

/// Values of the integrand (per solid angle of omega_m) at n normals; channel c of normal k at values[c n + k].
using NormalIntegrand = std::function<void(const std::vector<Direction>& normals, std::vector<double>& values)>;

/// What changes its sign where an integrand is not smooth. Of one channel.
struct Switch {
  NormalIntegrand value;
  bool root = false; ///< the integrand leaves its value there like a square root, on either side
};

/// What is known of an integrand over the normals that face the viewer.
struct FacingIntegrand {
  NormalIntegrand value;
  std::vector<Switch> switches{}; ///< the integrand may have a kink where one of these changes its sign,
  bool kink = false;              ///< and at u_1 = -a, where the V-cavity's other normal starts to face the viewer, of
                                  ///< slopes whose mean is the mesosurface's, without switches and without radii,
  bool symmetric = false;         ///< u_2 -> -u_2 changes nothing
};

/// Integral over the normals that face the viewer. Two charts, polar and with algebraic maps, so that power laws are
/// smooth at infinity: the disc r < a, and beyond it r = a sqrt(1 + s^2) with psi from atan s, where the horizon u_1 =
/// a cuts the ring, to pi (in two parts where there is a kink). Of a part that is seen from below, a <= 0, the second
/// one alone, r > |a|. With switches, or radii of the frame, along rays as integrate_lit().
Estimate integrate_facing(const SlopeFrame& frame, const FacingIntegrand& f, double tolerance);

/// What is known of an integrand over the normals that reflect the viewer above the horizon of the mesosurface.
struct LitIntegrand {
  NormalIntegrand value;
  std::size_t channels = 1;
  std::vector<Switch> switches{};          ///< the integrand may have a kink where one of these changes its sign,
  bool kink_in_plane_of_incidence = false; ///< and where azimuths are equal or opposite
  bool symmetric = false;                  ///< u_2 -> -u_2 changes nothing
};

/// Integrals over the normals that reflect the viewer above the horizon of the mesosurface, in polar coordinates around
/// the mean normal of the frame. Rays lie between the horizons and are cut where a switch changes its sign, and at the
/// frame's radii.
ColourEstimate integrate_lit(const SlopeFrame& frame, const LitIntegrand& f, double tolerance);

} // namespace brdfplot
