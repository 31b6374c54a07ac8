#include "simulation/measures/measure.hpp"

#include "simulation/clock.hpp"

namespace brdfplot::simulation {

std::vector<View> views(const MeasureDescription& description) {
  std::vector<View> all;
  for (const double theta : description.theta_o)
    for (const double phi : description.phi_o) all.push_back({theta, phi, from_angles(theta, phi)});
  return all;
}

void Facing::take(std::span<const SurfacePoint> from, const Direction& direction) {
  points.clear();
  for (const SurfacePoint& point : from)
    if (projected_area(point.slope, direction) > 0) points.push_back(point);
}

void Facing::take(std::span<const SurfacePoint> from, const Direction& one, const Direction& other) {
  points.clear();
  for (const SurfacePoint& point : from)
    if (projected_area(point.slope, one) > 0 && projected_area(point.slope, other) > 0) points.push_back(point);
}

void Facing::trace(const Tracer& tracer, const Direction& direction, TraceCounts& counts) {
  visible.resize(points.size());
  const Stopwatch watch(counts.coherent_seconds);
  tracer.visible(points, direction, visible.data());
  counts.coherent += points.size();
}

} // namespace brdfplot::simulation
