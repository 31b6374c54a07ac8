/// \file
/// The free parameters of a simpler material, fitted to the picture of the one in full.
#pragma once

#include "choice/advise/draft.hpp"
#include "choice/advise/images/render.hpp"

namespace brdfplot::choice {

/// What a picture is to be like.
struct FitTarget {
  const Picture& picture;
  LightModel model; ///< of the picture of the simpler material
  double exposure = 1;
};

/// The material whose picture, as a screen shows it, is nearest to the target's in the mean square of the logarithm
/// over the lit area, by Levenberg and Marquardt's method from the values that it has: colours within [0, 1], roughness
/// by a factor within [1/8, 8]. At most 4 steps; what does not get nearer is not taken.
MaterialDescription refitted(const Draft& draft, Renderer& renderer, const FitTarget& target);

} // namespace brdfplot::choice
