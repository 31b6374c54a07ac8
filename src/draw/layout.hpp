/// \file
/// Drawings for paper: laid out for their width, so that text keeps its size.
#pragma once

#include <string>

#include "draw/model.hpp"

namespace brdfplot::plot {

/// How a figure is laid out.
struct Layout {
  double width_mm = 0; ///< on paper; 0: for a screen, 640 units of the SVG wide or, of several columns, 720
  double font_pt = 8;  ///< of the numbers at axes on paper; other text is in proportion
  bool title = true;   ///< whether the figure's title is drawn; a caption may have it
};

/// As to_svg(figure). On paper panels stand in so many columns as have room, and axes have as many ticks as there is
/// room for.
std::string to_svg(const Figure& figure, const Layout& layout);

} // namespace brdfplot::plot
