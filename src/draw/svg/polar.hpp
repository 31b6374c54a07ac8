/// \file
/// What the layout and the drawing of polar plots have in common.
#pragma once

#include <numbers>

#include "draw/svg/plan.hpp"

namespace brdfplot::plot::polar {

inline constexpr double pi = std::numbers::pi;
inline constexpr double tip = 4; ///< how far arrows end beyond the outer ring, in user units

/// Whether an angle beyond ±90° occurs, so that the plot is a full disc.
bool is_full_disc(const Panel& panel);

} // namespace brdfplot::plot::polar
