/// \file
/// Which batch kernels compute a material.
#pragma once

#include "brdf/material.hpp"
#include "math/kernels/kernels.hpp"

#include <optional>
#include <utility>

namespace brdfplot {

/// The kernel of the distribution of normals, where there is one.
std::optional<kernels::Distribution> density_kernel(const Material& material);

/// The same where masking is Smith's, with the Lambda of the distribution itself.
std::optional<kernels::Distribution> smith_kernel(const Material& material);

using WholeKernel = std::pair<kernels::Distribution, kernels::Shadowing>;

/// The kernel that computes the whole BRDF but its Fresnel term, where there is one.
std::optional<WholeKernel> whole_kernel(const Material& material);

} // namespace brdfplot
