/// \file
/// The area that the facets of a distribution project towards the viewer, as one-dimensional integrals.
#pragma once

#include "integrate/slope_domain.hpp"
#include "microfacet/distributions.hpp"

namespace brdfplot {

/// int <o,m> D(m) dm over the facing normals, for a distribution that depends on |u| alone in its frame. With P(r) its
/// density in the frame, the azimuth is integrated in closed form:
///   2 pi c int_0^inf P(r) r dr + 2 s int_0^inf P(sqrt(a^2 + t^2)) t (t - a atan(t / a)) dt,
/// what all facets project, plus what is counted negative in it. Seen from below, c < 0, the visible area is the second
/// integral alone, with |a|: what all project is as much less. One Gauss-Kronrod rule each, 15-31 and 30-61, with
/// nodes and weights that are constants; adaptive ones, cut at the frame's radii, where it has some or where these do
/// not reach `tolerance` (absolute).
Estimate visible_area(const Distribution& distribution, const SlopeFrame& frame, double tolerance);

} // namespace brdfplot
