/// \file
/// `numbers` of a figure: what its caption says of its data.
#pragma once

#include "config/shapes.hpp"
#include "figure/description.hpp"

namespace brdfplot::config {

ShapePtr numbers_shape();

/// The numbers of a figure whose panels are read: that they name panels and series of it, and that caption and numbers
/// name each other. \throws InputError with the place in the file
std::vector<plot::NumberDescription> read_numbers(const JsonFile& file, const plot::FigureDescription& figure);

} // namespace brdfplot::config
