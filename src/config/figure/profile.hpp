/// \file
/// The `profile` of a figure and of its panels.
#pragma once

#include "config/shapes.hpp"
#include "figure/description.hpp"

namespace brdfplot::config {

ShapePtr profile_shape();

/// The profile of the panel at `pointer`, with what the figure says of all. Fails where something is wrong with it.
plot::ProfileDescription read_profile(const JsonFile& file, const Json& panel, const std::string& pointer);

/// The `autocorrelation` of a panel, and its reader.
ShapePtr autocorrelation_shape();
plot::AutocorrelationDescription read_autocorrelation(const JsonFile& file, const Json& panel,
                                                      const std::string& pointer);

} // namespace brdfplot::config
