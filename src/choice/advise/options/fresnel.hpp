/// \file
/// A Fresnel term in the place of a dearer one.
#pragma once

#include "choice/advise/draft.hpp"

namespace brdfplot::choice {

/// conductor -> F82 -> Schlick -> a constant, dielectric -> Schlick -> a constant: f0 is the reflectance at normal
/// incidence and f82 the factor at 82 degrees of the material in full, then f0 is fitted anew.
struct SimplerFresnel {
  static std::vector<Option> of(const MaterialDescription& material);
};

} // namespace brdfplot::choice
