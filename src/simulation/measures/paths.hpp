/// \file
/// Light paths: from the viewer to the surface, and from facet to facet until they leave it.
#pragma once

#include "simulation/clock.hpp"
#include "simulation/tiles.hpp"

namespace brdfplot::simulation {

/// How a path ended.
struct PathEnd {
  int bounces = 0;      ///< facets met
  bool escaped = false; ///< false: after the most bounces it was still between facets
  Direction omega_i{};  ///< where it left to
};

/// One path from `point`, which is visible from omega_o: every facet is a mirror that reflects all (F = 1).
/// False when the path was lost by rounding.
inline bool trace_path(const Tile& tile, SurfacePoint point, const Direction& omega_o, int most_bounces, PathEnd& end,
                       TraceCounts& counts) {
  Direction to_viewer = omega_o;
  for (end.bounces = 1;; ++end.bounces) {
    const Direction normal = normal_of(tile.field->to_world(point.slope));
    end.omega_i = reflected(to_viewer, normal);
    ++counts.incoherent;
    const Tracer::Fate fate = tile.tracer->next_hit(point, tile.field->to_mesh(end.omega_i));
    if (fate == Tracer::Fate::lost) return false;
    end.escaped = fate == Tracer::Fate::escaped;
    if (end.escaped || end.bounces >= most_bounces) return true;
    to_viewer = -1.0 * end.omega_i;
  }
}

/// Calls body(end) for about `count` paths that start at the tile, uniform in the area that omega_o sees. Returns how
/// many there were; those that were lost are left out.
template <class Body>
std::uint64_t for_paths(const Tile& tile, double count, const Direction& omega_o, int most_bounces, Random& random,
                        TraceCounts& counts, const Body& body) {
  const Direction d = tile.field->to_mesh(omega_o);
  const auto make = [&](double x, double y) {
    return SurfacePoint{static_cast<float>(x), static_cast<float>(y), tile.field->highest(), {}};
  };
  std::vector<unsigned char> hit;
  std::uint64_t paths = 0;
  for_random_places(tile, count, random, make, [&](std::span<SurfacePoint> points) {
    hit.resize(points.size());
    {
      const Stopwatch watch(counts.coherent_seconds);
      tile.tracer->first_hits(points, d, hit.data());
      counts.coherent += points.size();
    }
    const Stopwatch watch(counts.incoherent_seconds);
    for (std::size_t k = 0; k < points.size(); ++k) {
      PathEnd end;
      if (hit[k] == 0 || !trace_path(tile, points[k], omega_o, most_bounces, end, counts)) {
        ++counts.lost;
        continue;
      }
      ++paths;
      body(end);
    }
  });
  return paths;
}

} // namespace brdfplot::simulation
