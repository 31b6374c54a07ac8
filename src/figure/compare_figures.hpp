/// \file
/// What a comparison of materials shows.
#pragma once

#include "figure/description.hpp"

namespace brdfplot::plot {

/// Lobes over one another, the difference of rho cos theta_i from the first in the plane of incidence, and lit spheres
/// side by side. Of coloured materials lobes and differences are of the luminance.
std::vector<FigureDescription> compare_figures(const std::vector<MaterialDescription>& materials);

} // namespace brdfplot::plot
