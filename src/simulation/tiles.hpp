/// \file
/// Pieces of a surface, and random points spread over them.
#pragma once

#include "base/random.hpp"
#include "base/threads/interrupt.hpp"
#include "simulation/heightfield.hpp"
#include "simulation/tracer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace brdfplot::simulation {

/// A rectangle of cells of a mesh. `weight` is its area over the mean area of the tiles.
struct Tile {
  const HeightField* field = nullptr;
  const Tracer* tracer = nullptr;
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  double weight = 1;
};

/// Calls body(points) for random places (x, y) of the tile, one in each of k by k equal rectangles, k^2 about `count`;
/// `make(x, y)` makes the points. They come in bunches of neighbours. Returns how many there were, as
/// if Ctrl-C had not ended it.
template <class Make, class Body>
std::uint64_t for_random_places(const Tile& tile, double count, Random& random, const Make& make, const Body& body) {
  // Blocks of 4 by 2 go through Embree together.
  const std::size_t k = 4 * static_cast<std::size_t>(std::max(1.0, std::round(std::sqrt(count) / 4)));
  const double width = (tile.x1 - tile.x0) / static_cast<double>(k);
  const double height = (tile.y1 - tile.y0) / static_cast<double>(k);
  std::vector<SurfacePoint> points;
  points.reserve(2 * k);
  for (std::size_t row = 0; row < k && !interrupted(); row += 2) {
    points.clear();
    for (std::size_t column = 0; column < k; column += 4)
      for (std::size_t lane = 0; lane < 8; ++lane) {
        const std::size_t stratum_x = column + lane % 4;
        const std::size_t stratum_y = row + lane / 4;
        const double x = static_cast<double>(stratum_x) + random.uniform();
        const double y = static_cast<double>(stratum_y) + random.uniform();
        points.push_back(make(tile.x0 + x * width, tile.y0 + y * height));
      }
    body(std::span<SurfacePoint>(points));
  }
  return static_cast<std::uint64_t>(k * k);
}

/// Random points of the surface, uniform in the area seen from above.
template <class Body>
std::uint64_t for_random_points(const Tile& tile, double count, Random& random, const Body& body) {
  const auto make = [&](double x, double y) { return tile.field->at(x, y); };
  return for_random_places(tile, count, random, make, body);
}

} // namespace brdfplot::simulation
