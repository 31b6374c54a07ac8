/// \file
/// The numbers of a material as problems whose exact values are not known, but of which something is true.
#pragma once

#include "brdf/material.hpp"
#include "choice/methods/method.hpp"

namespace brdfplot::choice {

/// What the material has of lambda, g1, g2, d (of each microsurface), brdf, brdf_cos (of each channel) and albedo (the
/// largest of the channels), over all directions above the horizon: a problem each, named by the material, of one
/// method, named by the quantity. A formula of the user's that throws counts as not a number there. Without exact
/// values, digits are lost where the value is off the smooth curve of its neighbours.
/// \throws MaterialError
std::vector<Problem> material_problems(const MaterialDescription& description);

} // namespace brdfplot::choice
