/// \file
/// Scaled slope coordinates u = (u_1, u_2), aligned with the viewer.
#pragma once

#include "math/direction.hpp"
#include "microfacet/slopes.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace brdfplot {

/// The slopes m~ = mean + M u with M = L R: L L^T = Q^-1 (Eq. 88), R turning the first axis into the viewer's azimuth,
/// so that o.m / z_m = c - s u_1.
class SlopeFrame {
public:
  /// `mesosurface`: the slope of the surface that the viewer and the light are above, which is another than the mean of
  /// these slopes where they are those of a part. Such a part may be seen from below its own: c() < 0.
  /// `radii`: |u|, ascending, at which an integral is to be cut.
  SlopeFrame(const SlopeMap& map, const Direction& omega_o, const Vec2& mesosurface, std::vector<double> radii = {});
  SlopeFrame(const SlopeMap& map, const Direction& omega_o) : SlopeFrame(map, omega_o, Vec2{map.mean_x, map.mean_y}) {}

  Direction normal(double u1, double u2) const;
  /// The normals of n slopes.
  void normals(const double* u1, const double* u2, Direction* m, std::size_t n) const;
  /// The normals of n slopes along the viewer's azimuth, u_2 = 0.
  void normals_along(const double* u1, double* x, double* y, double* z, std::size_t n) const;
  /// d^2 u / d^2 m~.
  double determinant() const { return determinant_; }
  /// d omega_m / d^2 u = det M z_m^3.
  double jacobian(const Direction& omega_m) const { return determinant_ * omega_m.z * omega_m.z * omega_m.z; }

  double c() const { return projection_.c; }
  double s() const { return projection_.s; }
  const std::vector<double>& radii() const { return radii_; }
  /// Horizon of masking: facets with u_1 >= a face away. Infinite at the normal.
  double a() const { return s() > 0 ? c() / s() : infinity; }

  /// A part of a ray; none where to = from.
  struct Reach {
    double from = 0, to = infinity;
  };
  /// Where facets face the viewer on the ray u = r (cos psi, sin psi), r > 0: c - s u_1 > 0.
  Reach facing(double cos_psi, double sin_psi) const;
  /// Where they also reflect it above the horizon of the mesosurface. With n~ its slope, c~ the viewer's c on it, and h
  /// the normal of slope m~, the light is above where 2 (o.h) (1 + n~.m~) / z_h > c~ / z_h^2:
  ///   2 (c - s u_1) (B~ + b~.u) - c~ (B + 2 b.u + |M u|^2) > 0,
  /// B = 1 + |mean|^2, b = M^T mean, B~ = 1 + mean.n~, b~ = M^T n~: a disc around (-tan theta_o, 0) when the
  /// distribution is isotropic and centred. Half vectors of o and of a half space are a convex set of slopes (a disc of
  /// the plane that touches the sphere at o), so that a ray has one part in it. Where the mean of the slopes is n~ the
  /// ray begins at r = 0, and the horizon of facing comes later than that of the light.
  Reach lit(double cos_psi, double sin_psi) const;

  /// Whether the mirror image u_2 -> -u_2 changes nothing.
  bool symmetric() const { return symmetric_; }
  bool centred() const { return mean_[0] == 0 && mean_[1] == 0; }
  /// psi of the slopes in the plane of incidence, where they are centred.
  double plane_of_incidence() const { return plane_; }

private:
  Projection projection_;
  double determinant_;
  std::array<double, 2> mean_, b_, b_mesosurface_;
  std::array<double, 4> m_; ///< M, row-major
  double big_b_, big_b_mesosurface_;
  double c_mesosurface_;
  double plane_;
  bool symmetric_;
  std::vector<double> radii_;
};

} // namespace brdfplot
