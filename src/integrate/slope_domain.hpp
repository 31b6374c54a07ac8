/// \file
/// Integration over the normals in scaled slope coordinates u = (u_1, u_2), aligned with the viewer.
#pragma once

#include "math/direction.hpp"
#include "math/quadrature.hpp"
#include "microfacet/slopes.hpp"

#include <array>
#include <functional>
#include <vector>

namespace brdfplot {

/// The slopes m~ = mean + M u with M = L R: L L^T = Q^-1 (Eq. 88), R turning the first axis into the viewer's azimuth,
/// so that o.m / z_m = c - s u_1.
class SlopeFrame {
public:
  SlopeFrame(const SlopeMap& map, const Direction& omega_o);

  Direction normal(double u1, double u2) const;
  /// The normals of n slopes along the viewer's azimuth, u_2 = 0.
  void normals_along(const double* u1, double* x, double* y, double* z, std::size_t n) const;
  /// d^2 u / d^2 m~.
  double determinant() const { return determinant_; }
  /// d omega_m / d^2 u = det M z_m^3.
  double jacobian(const Direction& omega_m) const { return determinant_ * omega_m.z * omega_m.z * omega_m.z; }

  double c() const { return projection_.c; }
  double s() const { return projection_.s; }
  /// Horizon of masking: facets with u_1 >= a face away. Infinite at the normal.
  double a() const { return s() > 0 ? c() / s() : infinity; }

  /// How far the ray u = r (cos psi, sin psi) runs, r > 0, before the facet reflects below the horizon of the
  /// mesosurface (or turns away from the viewer, which comes later). With h the normal of slope m~, the light is above
  /// where c B - 2 s B u_1 - 2 s u_1 b.u - c |M u|^2 > 0, B = 1 + |mean|^2, b = M^T mean: a disc around (-tan theta_o,
  /// 0) when the distribution is isotropic and centred.
  double reach(double cos_psi, double sin_psi) const;

  /// Whether the mirror image u_2 -> -u_2 changes nothing.
  bool symmetric() const { return symmetric_; }
  bool centred() const { return mean_[0] == 0 && mean_[1] == 0; }
  /// psi of the slopes in the plane of incidence, where they are centred.
  double plane_of_incidence() const { return plane_; }

private:
  Projection projection_;
  double determinant_;
  std::array<double, 2> mean_, b_;
  std::array<double, 4> m_; ///< M, row-major
  double big_b_;
  double plane_;
  bool symmetric_;
};

/// Values of the integrand (per solid angle of omega_m) at n normals.
using NormalIntegrand = std::function<void(const std::vector<Direction>& normals, std::vector<double>& values)>;

/// What is known of an integrand over the normals that face the viewer.
struct FacingIntegrand {
  NormalIntegrand value;
  bool symmetric = false; ///< u_2 -> -u_2 changes nothing
  bool kink = false;      ///< at u_1 = -a, where the V-cavity's other normal starts to face the viewer
};

/// Integral over the normals that face the viewer. Two charts, polar and with algebraic maps, so that power laws are
/// smooth at infinity: the disc r < a, and beyond it r = a sqrt(1 + s^2) with psi from atan s, where the horizon u_1 =
/// a cuts the ring, to pi (in two parts where there is a kink).
Estimate integrate_facing(const SlopeFrame& frame, const FacingIntegrand& f, double tolerance);

/// What changes its sign where an integrand is not smooth.
struct Switch {
  NormalIntegrand value;
  bool root = false; ///< the integrand leaves its value there like a square root, on either side
};

/// What is known of an integrand over the normals that reflect the viewer above the horizon of the mesosurface.
struct LitIntegrand {
  NormalIntegrand value;
  std::vector<Switch> switches{};          ///< the integrand may have a kink where one of these changes its sign,
  bool kink_in_plane_of_incidence = false; ///< and where azimuths are equal or opposite
  bool symmetric = false;                  ///< u_2 -> -u_2 changes nothing
};

/// Integral over the normals that reflect the viewer above the horizon of the mesosurface, in polar coordinates around
/// the mean normal. Rays end at the horizon and are cut where a switch changes its sign.
Estimate integrate_lit(const SlopeFrame& frame, const LitIntegrand& f, double tolerance);

} // namespace brdfplot
