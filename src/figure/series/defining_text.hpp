/// \file
/// Texts that are equal where what they define is.
#pragma once

#include "figure/description.hpp"
#include "math/direction.hpp"

#include <string>
#include <vector>

namespace brdfplot::plot {

/// What is simulated on: distribution and Fresnel term with all their numbers.
std::string defining_text(const MaterialDescription& material);
std::string defining_text(const Direction& direction);

/// A computed term as a function of what is swept.
std::string defining_text(const Term& term, const std::vector<std::string>& swept);

} // namespace brdfplot::plot
