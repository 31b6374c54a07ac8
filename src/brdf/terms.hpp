/// \file
/// The list of terms that a BRDF may be a sum of. A new one is one file in terms/ and one line here.
#pragma once

#include "brdf/terms/facet_diffuse.hpp"
#include "brdf/terms/lambert.hpp"
#include "brdf/terms/mirror.hpp"
#include "brdf/terms/oren_nayar.hpp"

#include <variant>

namespace brdfplot {

template <TermModel... T>
using TermList = std::variant<T...>;

using BrdfTerm = TermList<Mirror,        //
                          FacetDiffuse,  //
                          OrenNayarFits, //
                          Lambert>;

} // namespace brdfplot
