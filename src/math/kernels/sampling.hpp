/// \file
/// Directions mirrored at random visible normals (Heitz 2014, Eq. 16), over arrays of numbers in [0, 1), with their
/// densities. Like kernels.hpp, which says what holds of every kernel.
#pragma once

#include "math/kernels/kernels.hpp"

#include <cstddef>

namespace brdfplot::kernels {

/// What normals are seen from: omega_o, above the horizon of the mesosurface.
struct SeenFrom {
  double x, y, z;          ///< omega_o
  double visible_area;     ///< sigma(o) = c (1 + Lambda) (Heitz 2014, Eq. 41)
  double c, s;             ///< of omega_o in the space of unit roughness: cosine and sine, c^2 + s^2 = 1
  double along_x, along_y; ///< and its azimuth, a unit vector
};

/// Arrays that are written: directions, and the density D(m) / (4 sigma) of each (1/sr).
struct MirroredAtNormals {
  double *x, *y, *z, *pdf;
};

/// omega_o mirrored at the visible normal of the unit square's point (u1, u2):
///
/// - ggx: u1 is the azimuth, u2 the height in a spherical cap (Dupuy and Benyoub 2023), as GgxShape::visible_slope.
/// - beckmann: u1 is the share of what is seen whose slopes towards the viewer are smaller, u2 that of those at right
///   angles (after Heitz and d'Eon 2014), as BeckmannShape::visible_slope. A fixed number of steps: the share below the
///   slope is u1 within 2e-15, and so for u2; u = 0 counts as 2^-54.
///
/// No rejection, and no branch.
void mirror_at_visible_normals(Distribution, const Stretch&, const SeenFrom&, const double* u1, const double* u2,
                               const MirroredAtNormals&, std::size_t n);

} // namespace brdfplot::kernels
