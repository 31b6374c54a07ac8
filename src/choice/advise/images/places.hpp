/// \file
/// Where the picture of a lit sphere is compared: places with the share of it that each stands for.
#pragma once

#include "choice/advise/images/scene.hpp"
#include "sampling/sphere/frames.hpp"

#include <vector>

namespace brdfplot::choice {

struct Places {
  std::vector<sphere::Place> at;
  std::vector<double> share; ///< sum 1
};

/// How fine: 1 is what the search looks at, 2 has about four times as many places. `alpha` are the least and the
/// largest roughness, which say how wide highlights are.
struct Fineness {
  double scale = 1;
  double least_alpha = 1, largest_alpha = 1;
};

/// The middles of cells in radius and azimuth of the part of a sphere whose normals are within the range of view, finer
/// about the normals that mirror the lights, where highlights are.
Places places_on_sphere(const ViewRange& view, const std::vector<AdviceLight>& lights, const Fineness& fineness);

} // namespace brdfplot::choice
