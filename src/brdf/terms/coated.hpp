/// \file
/// Terms under a clear coat, or under a sheen.
#pragma once

#include "brdf/coat.hpp"

namespace brdfplot {

/// coat + base times what the coat lets through (coat.hpp). It is no term itself: in a material stand its coat and the
/// terms of its base, each with a name, parameters and quantities of its own, and the base knows what lies over it. A
/// base may be coated again.
struct Coated {
  static ModelSpec spec() {
    return {.type = "coated",
            .doc = "a coat and, beneath it, what it lets through of the base",
            .source = "Akenine-Moller et al. 2018, section 9.12",
            .parameters = Coat::parameters()};
  }
};

} // namespace brdfplot
