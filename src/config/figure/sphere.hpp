/// \file
/// The `sphere` of a figure and of its panels.
#pragma once

#include "config/figure/scope.hpp"

namespace brdfplot::config {

ShapePtr sphere_shape();

/// The sphere of the panel at `pointer`, with what the figure says of all. Fails where something is wrong with it.
plot::SphereDescription read_sphere(const JsonFile& file, const Json& panel, const std::string& pointer,
                                    const Scope& scope, double tolerance);

} // namespace brdfplot::config
