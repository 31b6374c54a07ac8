/// \file
/// What a page's script needs to read values off a drawing.
#pragma once

#include <string>

#include "draw/svg/plan.hpp"

namespace brdfplot::plot {

/// Attributes of a panel's group: its kind, where its plot is, and what its axes are.
///
/// `data-plot` is x, y, width and height; an axis is `from to unit scale`, its values those of the CSV (radians), and
/// its label is HTML. Of a polar plot x is the signed angle from the normal and y the radius. A heat map's cells have
/// no more than a colour: `data-panel` and `data-columns` name their rows and columns in the CSV.
/// Of a profile x and y are places in its own unit, of a sphere in its radii from the middle.
std::string reading_attributes(Kind kind, const PanelPlan& plan);

} // namespace brdfplot::plot
