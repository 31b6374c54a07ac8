/// \file
/// The term of a material whose Fresnel term a quantity is of.
#pragma once

#include "brdf/material.hpp"

#include <string>

namespace brdfplot {

/// The term of that name, or the only one, that has facets with a Fresnel term: with a microsurface, or with a
/// distribution alone, as "kelemen". Without a name, one with a microsurface goes before those without.
/// \throws InputError where there is none or several, with the names.
const WeightedTerm& term_with_fresnel(const Material& material, const std::string& name);

} // namespace brdfplot
