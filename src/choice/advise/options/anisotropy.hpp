/// \file
/// A rounder distribution of normals.
#pragma once

#include "choice/advise/draft.hpp"

namespace brdfplot::choice {

/// Correlated slopes -> without correlation -> isotropic with the alpha of equal area, sqrt(alpha_x alpha_y (1 -
/// r^2)^(1/2)), then fitted anew.
struct Rounder {
  static std::vector<Option> of(const MaterialDescription& material);
};

/// The mean slopes of all terms, and of the parts of their mixtures, left out.
struct Level {
  static std::vector<Option> of(const MaterialDescription& material);
};

} // namespace brdfplot::choice
