#include "simulation/heightfield.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brdfplot::simulation {

HeightField::HeightField(int nx, int ny, std::vector<float> heights, double azimuth, Slope mean)
    : nx_(nx), ny_(ny), heights_(std::move(heights)), cos_azimuth_(std::cos(azimuth)), sin_azimuth_(std::sin(azimuth)),
      mean_(mean) {
  const auto [lowest, highest] = std::ranges::minmax_element(heights_);
  lowest_ = *lowest;
  highest_ = *highest;
}

HeightField::Corners HeightField::corners(int ix, int iy) const {
  const int jx = ix + 1 < nx_ ? ix + 1 : 0;
  const int jy = iy + 1 < ny_ ? iy + 1 : 0;
  return {height(ix, iy), height(jx, iy), height(ix, jy), height(jx, jy)};
}

Slope HeightField::facet_slope(int ix, int iy, bool far) const {
  const Corners h = corners(ix, iy);
  return far ? Slope{h.h11 - h.h01, h.h11 - h.h10} : Slope{h.h10 - h.h00, h.h01 - h.h00};
}

SurfacePoint HeightField::on_facet(int ix, int iy, bool far, double u, double v) const {
  const Corners h = corners(ix, iy);
  // The height belongs to the rounded place: on a steep facet a rounding of x would lift the point off the mesh.
  const auto x = static_cast<float>(ix + u);
  const auto y = static_cast<float>(iy + v);
  const double du = x - static_cast<double>(ix);
  const double dv = y - static_cast<double>(iy);
  if (far) {
    const Slope slope{h.h11 - h.h01, h.h11 - h.h10};
    return {x, y, static_cast<float>(h.h11 - (1 - du) * slope.x - (1 - dv) * slope.y), slope};
  }
  const Slope slope{h.h10 - h.h00, h.h01 - h.h00};
  return {x, y, static_cast<float>(h.h00 + du * slope.x + dv * slope.y), slope};
}

SurfacePoint HeightField::at(double x, double y) const {
  const int ix = std::clamp(static_cast<int>(x), 0, nx_ - 1);
  const int iy = std::clamp(static_cast<int>(y), 0, ny_ - 1);
  const double u = x - ix;
  const double v = y - iy;
  return on_facet(ix, iy, u + v > 1, u, v);
}

Direction HeightField::to_mesh(const Direction& omega) const {
  return normalized({cos_azimuth_ * omega.x + sin_azimuth_ * omega.y, cos_azimuth_ * omega.y - sin_azimuth_ * omega.x,
                     omega.z - mean_.x * omega.x - mean_.y * omega.y});
}

Slope HeightField::to_world(const Slope& slope) const {
  return {cos_azimuth_ * slope.x - sin_azimuth_ * slope.y + mean_.x,
          sin_azimuth_ * slope.x + cos_azimuth_ * slope.y + mean_.y};
}

} // namespace brdfplot::simulation
