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

/// Integral over the normals that face each of `directions` (any number of them, all above the mesosurface) of a
/// function per solid angle of omega_m, `f(normals, values)`.
///
/// In slopes m~ = mean + L u with L L^T = Q^-1 (Heitz 2014, Eq. 88) and u = cot w (cos psi, sin psi): there the
/// distribution has unit width whatever its roughness is, tails that fall like a power are powers of w, and
/// omega.m / z_m = c - v.u, so that the horizon of each direction is a line. Rays end at the first of them, and of
/// slopes that are seen from below, c < 0, begin at the last one. psi is cut where one line takes over from another or
/// is parallel to the ray. With `kinked` the rays are cut where V-cavities may start to mask too, omega.m / z_m = 2 c~
/// (Heitz 2014, Eq. 49), c~ the direction's c on the mesosurface, whose slope is `mesosurface`; and where a masking of
/// o.m / c~ is the same for two directions, so that the smaller one of them changes.
/// Where a ray has no finite integral (power_tail()) the estimate is infinite.
Estimate integrate_over_facing(const SlopeMap& map, const Vec2& mesosurface, std::span<const Direction> directions,
                               bool kinked,
                               const std::function<void(const std::vector<Direction>&, std::vector<double>&)>& f,
                               const Tolerance& tolerance);

} // namespace brdfplot
