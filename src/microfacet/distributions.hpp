/// \file
/// The list of distributions. A new one is one file in distributions/ and one line here.
#pragma once

#include "microfacet/distributions/beckmann.hpp"
#include "microfacet/distributions/ggx.hpp"
#include "microfacet/distributions/gtr.hpp"
#include "microfacet/distributions/phong.hpp"

#include <variant>

namespace brdfplot {

using Distribution = std::variant<Beckmann, //
                                  Ggx,      //
                                  Phong,    //
                                  Gtr>;

} // namespace brdfplot
