/// \file
/// The problems that a material makes: how its own numbers can be computed.
#pragma once

#include "brdf/material.hpp"
#include "choice/methods/method.hpp"

namespace brdfplot::choice {

/// Of a material: `lambda` (of its only microsurface, towards azimuth 0: fits and quadratures at several tolerances),
/// `brdf` (on each instruction set), `albedo` and `furnace` (quadratures at several tolerances, and whether their own
/// estimates of their errors hold). What it has not, is left out. The exact values are what the program has at its
/// finest. \throws MaterialError
std::vector<Problem> problems_of(const MaterialDescription& description);

} // namespace brdfplot::choice
