/// \file
/// Scaled slope coordinates u = (u_1, u_2), aligned with the viewer.
#pragma once

#include "math/direction.hpp"
#include "microfacet/slopes.hpp"

#include <array>
#include <cstddef>

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

} // namespace brdfplot
