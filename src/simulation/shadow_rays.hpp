/// \file
/// Shadow rays of one direction on a periodic heightfield.
#pragma once

#include "simulation/heightfield.hpp"

#include <span>
#include <vector>

namespace brdfplot::simulation {

/// Follows rays from cell to cell, many at once in the lanes of the processor. A pyramid of the highest points of 2^k
/// by 2^k cells says over which of them a ray passes without a look at their facets; within a cell, surface and ray are
/// linear from the entry to the diagonal and to the exit, so that comparing heights there is exact. The rays wrap
/// around at the sides of the period. On instruction sets with gathers (AVX2, AVX-512) it takes less than half the
/// time of Embree's packets, which must not know that the surface is a heightfield; without, twice that time. The same
/// result on all.
class ShadowRays {
public:
  /// The field must outlive this.
  explicit ShadowRays(const HeightField& field);

  /// visible[k] = 1 where the ray from `lift` above points[k] towards `direction` (in the axes of the mesh, z > 0)
  /// meets nothing, else 0. Places are rounded to 2^-24 of the way. A ray that after 2^20 cells is still below the
  /// highest point counts as seen.
  void trace(std::span<const SurfacePoint> points, const Direction& direction, float lift,
             unsigned char* visible) const;

private:
  const HeightField* field_;
  std::vector<float> highest_; ///< of the cells, then of each level above
  std::vector<int> begin_;     ///< where a level begins
};

} // namespace brdfplot::simulation
