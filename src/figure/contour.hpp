/// \file
/// Level lines of a function of two variables.
#pragma once

#include "draw/model.hpp"

#include <functional>
#include <vector>

namespace brdfplot::plot {

/// A function at the points (x[k], y[k]), all of which are wanted at once.
using PlaneFunction = std::function<std::vector<double>(const std::vector<double>& x, const std::vector<double>& y)>;

/// The lines value = level over the lattice x, y (ascending), by marching squares. Crossings on the lattice's edges are
/// found by bisection of the function itself, of all edges together, so a jump (the edge of a plateau) is located as
/// well as a slope.
std::vector<Contour::Line> level_lines(const PlaneFunction& value, double level, const std::vector<double>& x,
                                       const std::vector<double>& y);

} // namespace brdfplot::plot
