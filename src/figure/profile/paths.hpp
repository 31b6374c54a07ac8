/// \file
/// Light that facets of a profile reflect as mirrors, from one to the next. A ray in the plane of the cut does not
/// leave it where the surface is the same across the cut, so that these paths are those of ridges, not of a surface in
/// three dimensions.
#pragma once

#include "figure/profile/profile.hpp"

#include <vector>

namespace brdfplot::plot {

/// Where a path is reflected, and where it goes at last.
struct MirrorPath {
  std::vector<Meeting> points; ///< on the facets
  double theta = 0;            ///< signed angle from the vertical of the last ray
  bool ended = false;          ///< by `most` reflections: the last ray meets a facet again
};

/// The path that begins on facet `k` of a joined surface, at a fraction of it, when light comes to it from the
/// direction `theta`. What is beyond the given facets is not there.
MirrorPath mirror_path(const std::vector<Segment>& facets, std::size_t k, double fraction, double theta, int most);

} // namespace brdfplot::plot
