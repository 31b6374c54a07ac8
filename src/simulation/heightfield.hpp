/// \file
/// A periodic heightfield as the triangle mesh that is traced.
#pragma once

#include "math/direction.hpp"

#include <cstddef>
#include <vector>

namespace brdfplot::simulation {

struct Slope {
  double x = 0;
  double y = 0;
};

/// A point of the mesh, in units of a cell. `slope` is that of its facet, in the axes of the mesh.
struct SurfacePoint {
  float x = 0;
  float y = 0;
  float z = 0;
  Slope slope;
};

/// nx by ny heights at the corners of square cells, in units of a cell, continued periodically. A cell is two facets,
/// cut from its corner (1, 0) to its corner (0, 1).
///
/// The mesh has no mean slope: that of the mesosurface is a shear, which moves no ray to another facet (Heitz 2014,
/// section 5.5). It is in the map between the directions of the world and those of the mesh, beside a rotation.
class HeightField {
public:
  /// heights[iy * nx + ix]; `azimuth` (rad) is that of the mesh's x axis, `mean` the slope of the mesosurface.
  HeightField(int nx, int ny, std::vector<float> heights, double azimuth = 0, Slope mean = {});

  int nx() const { return nx_; }
  int ny() const { return ny_; }
  float lowest() const { return lowest_; }
  float highest() const { return highest_; }
  const std::vector<float>& heights() const { return heights_; }

  float height(int ix, int iy) const {
    return heights_[static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(ix)];
  }

  /// The point above (x, y), 0 <= x <= nx, 0 <= y <= ny.
  SurfacePoint at(double x, double y) const;

  /// The facet of cell (ix, iy) at its corner (0, 0), or (`far`) at its corner (1, 1): its slope.
  Slope facet_slope(int ix, int iy, bool far) const;

  /// The point at (ix + u, iy + v) of a facet.
  SurfacePoint on_facet(int ix, int iy, bool far, double u, double v) const;

  /// A direction of the world in the axes of the mesh, normalised. Its z > 0 where the mesosurface faces it.
  Direction to_mesh(const Direction& omega) const;

  /// The slope of a facet in the world.
  Slope to_world(const Slope& slope) const;

private:
  struct Corners {
    double h00, h10, h01, h11;
  };
  Corners corners(int ix, int iy) const;

  int nx_;
  int ny_;
  std::vector<float> heights_;
  double cos_azimuth_;
  double sin_azimuth_;
  Slope mean_;
  float lowest_;
  float highest_;
};

/// omega . m / m_z for the facet normal m of a slope: the area that the facet projects towards omega, per area of the
/// plane below it. Positive where the facet faces omega.
inline double projected_area(const Slope& slope, const Direction& omega) {
  return omega.z - slope.x * omega.x - slope.y * omega.y;
}

/// The normal of a facet.
inline Direction normal_of(const Slope& slope) { return normalized({-slope.x, -slope.y, 1}); }

} // namespace brdfplot::simulation
