/// \file
/// Level lines of a function of two variables.
#pragma once

#include "plot/model.hpp"

#include <functional>
#include <vector>

namespace brdfplot::plot {

/// The lines value = level over the lattice x, y (ascending), by marching squares. Crossings on the lattice's edges are
/// found by bisection of the function itself, so a jump (the edge of a plateau) is located as well as a slope.
std::vector<Contour::Line> level_lines(const std::function<double(double, double)>& value, double level,
                                       const std::vector<double>& x, const std::vector<double>& y);

} // namespace brdfplot::plot
