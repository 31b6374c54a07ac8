/// \file
/// Rays on a periodic heightfield (Embree; those of one direction towards the sky by ShadowRays).
#pragma once

#include "simulation/heightfield.hpp"
#include "simulation/shadow_rays.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace brdfplot::simulation {

/// Rays traced and the processor time that it took, by kind. Shadow rays of one direction are coherent.
struct TraceCounts {
  std::uint64_t coherent = 0;
  std::uint64_t incoherent = 0;
  std::uint64_t lost = 0; ///< paths that rounding took below the surface; they are left out
  double coherent_seconds = 0;
  double incoherent_seconds = 0;

  TraceCounts& operator+=(const TraceCounts& other);
};

/// Embree's threads are started with the first surface; this does it before.
void start_embree();

/// One period of a heightfield, which must outlive this, ready to be traced. A ray that leaves the period at a side
/// enters it again at the opposite one, as often as it takes to get above the highest point: the surface has no border,
/// at any angle. Any number of threads may trace at once; the result of a ray depends on it alone.
class Tracer {
public:
  explicit Tracer(const HeightField& field);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  /// visible[k] = 1 where nothing of the surface lies between points[k] and infinity towards `direction` (in the axes
  /// of the mesh, z > 0), else 0. The facets of the points face the direction. Neighbours in the array should be
  /// neighbours on the surface: they are traced together (ShadowRays).
  void visible(std::span<const SurfacePoint> points, const Direction& direction, unsigned char* visible) const;

  /// What is seen from infinity against `direction` (z > 0), through the places (x, y) of the plane above the mesh: the
  /// points are replaced by what is hit. hit[k] = 0: the ray was lost by rounding.
  void first_hits(std::span<SurfacePoint> points, const Direction& direction, unsigned char* hit) const;

  enum class Fate { hit, escaped, lost };

  /// Follows a ray from `point` on, whose facet faces `direction` (any z): to the next point, or away from the surface.
  Fate next_hit(SurfacePoint& point, const Direction& direction) const;

private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
  ShadowRays shadow_rays_;
  const HeightField* field_;
};

} // namespace brdfplot::simulation
