/// \file
/// Masking functions that are Smith's at another roughness.
#pragma once

#include "brdf/material.hpp"

#include <string>

namespace brdfplot {

/// "G1 is Smith's with alpha^2 in the place of alpha" or "... with sqrt(alpha) ...", where the masking function of a
/// material's only microsurface is that to 1e-6 at every direction tried, and Smith's at its own roughness is not: a
/// convention of roughness that was mixed up. Empty where it is neither, and where the distribution is not
/// shape-invariant. \throws MaterialError
std::string masking_mistake(const MaterialDescription& description);

} // namespace brdfplot
