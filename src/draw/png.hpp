/// \file
/// A picture as a PNG.
#pragma once

#include "draw/model.hpp"

#include <string>

namespace brdfplot::plot {

/// The bytes of a PNG file of 8 bits a channel that says it is sRGB. The same for the same picture and version of zlib.
/// \throws std::bad_alloc
std::string to_png(const Picture& picture);

} // namespace brdfplot::plot
