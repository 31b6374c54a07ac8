/// \file
/// What a sample costs by a strategy, counted over the formulas of sampling_forms.hpp and forms.hpp.
#pragma once

#include "brdf/material.hpp"
#include "choice/methods/operations.hpp"

#include <string>

namespace brdfplot::choice {

/// Of one sample, each from a viewer of its own: the direction, its density, and the BRDF (shader_operations()) over
/// that. Visible normals of Beckmann's are found by three steps of Newton's rule, as renderers do (Jakob 2014).
/// \throws InputError for other materials than one mirror of ggx or beckmann, and for other strategies than cosine,
/// half_vector, visible_normals and heitz_2018
Operations sampling_operations(const MaterialDescription& material, const std::string& strategy);

} // namespace brdfplot::choice
