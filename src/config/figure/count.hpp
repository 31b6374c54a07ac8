/// \file
/// How much a figure is, told before any of it is made.
#pragma once

#include "config/json_file.hpp"

#include <cstddef>

namespace brdfplot::config {

/// In one figure. A reader tells some ten series apart; these are a hundred times what the largest shipped figure has.
inline constexpr std::size_t most_panels = 1000;
inline constexpr std::size_t most_series = 1000;

/// Counts what the `for_each`, samples and cells of a figure, whose shape has been checked, make of it. Fails where
/// that is more panels, series or points than can be drawn or, of simulated ones, than can be kept.
void check_count(const JsonFile& file);

} // namespace brdfplot::config
