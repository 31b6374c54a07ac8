/// \file
/// Which batch kernels compute what of a microsurface.
#pragma once

#include "math/kernels/cloth.hpp"
#include "math/kernels/kernels.hpp"
#include "microfacet/microsurface.hpp"

#include <optional>
#include <utility>

namespace brdfplot {

/// The kernel of a distribution of normals, where there is one.
std::optional<kernels::Distribution> density_kernel(const Distribution& distribution);

/// The same where masking is Smith's, with the Lambda of the distribution itself.
std::optional<kernels::Distribution> smith_kernel(const Microsurface& surface);

using WholeKernel = std::pair<kernels::Distribution, kernels::Shadowing>;

/// The kernel that computes the whole BRDF but its Fresnel term, where there is one.
std::optional<WholeKernel> whole_kernel(const Microsurface& surface);

/// A kernel of the same for sheen, where its masking has one: the published fit with correlated heights, or the
/// denominator of Neubelt and Pettineo.
struct SheenKernel {
  kernels::SheenMasking masking;
  kernels::SheenParameters parameters;
};
std::optional<SheenKernel> sheen_kernel(const Microsurface& surface);

} // namespace brdfplot
