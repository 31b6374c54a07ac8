/// \file
/// The albedo of a term as a table that another term is made of.
#pragma once

#include "brdf/albedo_table.hpp"
#include "brdf/material.hpp"

#include <memory>

namespace brdfplot {

/// The table of a term with its weight, to about 1e-8, or 3e-7 where it is anisotropic. Remembered: a material is built
/// several times on its way. \throws MaterialError where it has not the planes y = 0 and x = 0 for mirrors, or its
/// albedo is above 1 by more than its error; AccuracyError where the integrals do not reach 1e-6
std::shared_ptr<const AlbedoTable> tabulated_albedo(const TermDescription& description);

} // namespace brdfplot
