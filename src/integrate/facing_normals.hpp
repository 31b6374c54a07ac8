/// \file
/// Integration over the normals that face some directions, in scaled slopes.
#pragma once

#include "math/direction.hpp"
#include "math/quadrature.hpp"
#include "microfacet/slopes.hpp"

#include <functional>
#include <span>
#include <vector>

namespace brdfplot {

/// What is known of where a function of the normals is not smooth.
struct NormalKinks {
  bool lines = false;             ///< where V-cavities start to mask, or one masking becomes the smaller one
  bool anywhere = false;          ///< a formula of a user's is in it
  std::vector<double> radii = {}; ///< |u|
};

/// Integral over the normals that face each of `directions` (any number of them, all above the mesosurface) of a
/// function per solid angle of omega_m, `f(normals, values)`.
///
/// In slopes m~ = mean + L u with L L^T = Q^-1 (Heitz 2014, Eq. 88) and u = cot w (cos psi, sin psi): there the
/// distribution has unit width whatever its roughness is, tails that fall like a power are powers of w, and
/// omega.m / z_m = c - v.u, so that the horizon of each direction is a line. Rays end at the first of them, and of
/// slopes that are seen from below, c < 0, begin at the last one. psi is cut where one line takes over from another or
/// is parallel to the ray. With `lines` the rays are cut where V-cavities may start to mask too, omega.m / z_m = 2 c~
/// (Heitz 2014, Eq. 49), c~ the direction's c on the mesosurface, whose slope is `mesosurface`; and where a masking of
/// o.m / c~ is the same for two directions, so that the smaller one of them changes.
/// With kinks `anywhere` the rules look at the ends of their intervals too (Jumps::possible).
/// Where a ray has no finite integral (power_tail()) the estimate is infinite.
Estimate integrate_over_facing(const SlopeMap& map, const Vec2& mesosurface, std::span<const Direction> directions,
                               const NormalKinks& kinks,
                               const std::function<void(const std::vector<Direction>&, std::vector<double>&)>& f,
                               const Tolerance& tolerance);

} // namespace brdfplot
