/// \file
/// Integration over the normals in scaled slope coordinates u = (u_1, u_2), aligned with the viewer.
#pragma once

#include "brdf/material.hpp"
#include "math/direction.hpp"
#include "math/quadrature.hpp"

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
  /// d omega_m / d^2 u = det M z_m^3.
  double jacobian(const Direction& omega_m) const { return determinant_ * omega_m.z * omega_m.z * omega_m.z; }

  double c() const { return projection_.c; }
  double s() const { return projection_.s; }
  /// Horizon of masking: facets with u_1 >= a face away. Infinite at the normal.
  double a() const { return s() > 0 ? c() / s() : infinity; }

  /// How far the ray u = r (cos psi, sin psi) runs, r > 0, before the facet turns away from the viewer (u_1 = a) or,
  /// with `lit_only`, before it reflects below the horizon of the mesosurface. With h the normal of slope m~, the
  /// latter reads c B - 2 s B u_1 - 2 s u_1 b.u - c |M u|^2 > 0, B = 1 + |mean|^2, b = M^T mean: a disc around (-tan
  /// theta_o, 0) when the distribution is isotropic and centred.
  double reach(double cos_psi, double sin_psi, bool lit_only) const;

  /// Whether the mirror image u_2 -> -u_2 changes nothing.
  bool symmetric() const { return symmetric_; }

private:
  Projection projection_;
  double determinant_;
  std::array<double, 2> mean_, b_;
  std::array<double, 4> m_; ///< M, row-major
  double big_b_;
  bool symmetric_;
};

/// Values of the integrand (per solid angle of omega_m) at n normals.
using NormalIntegrand = std::function<void(const std::vector<Direction>& normals, std::vector<double>& values)>;

/// Integral over the normals of `f`: those facing the viewer, or (`lit_only`) those that reflect it above the horizon.
/// In polar coordinates u = tan v (cos psi, sin psi): tails that fall like a power (GGX) are smooth up to v = pi / 2.
Estimate integrate_normals(const SlopeFrame& frame, const NormalIntegrand& f, bool lit_only, double tolerance);

} // namespace brdfplot
