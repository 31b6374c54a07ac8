/// \file
/// Greyscale images as heights.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace brdfplot::simulation {

/// Values at [iy * width + ix], the row iy = 0 at the bottom.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  float at(int ix, int iy) const {
    return values[static_cast<std::size_t>(iy) * static_cast<std::size_t>(width) + static_cast<std::size_t>(ix)];
  }
};

/// Reads a greyscale PNG of 8 or 16 bits (0 is black, 1 is white; what the file says of gamma is not applied, since
/// heights are no light) or a greyscale PFM (its numbers). The contents tell which.
/// \throws FileError; InputError: another format, colour, a broken file, fewer than 2 by 2 pixels, a height that is not
/// finite.
Image read_image(const std::string& path);

} // namespace brdfplot::simulation
