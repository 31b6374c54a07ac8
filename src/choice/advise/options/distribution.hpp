/// \file
/// One GGX lobe in the place of a distribution that is dearer.
#pragma once

#include "choice/advise/draft.hpp"

namespace brdfplot::choice {

/// mixture, student_t, gtr, exponential_power, custom -> GGX with the mean slope and the (geometric mean) alpha,
/// wider where parts of a mixture have mean slopes of their own, then fitted anew.
struct SingleLobe {
  static std::vector<Option> of(const MaterialDescription& material);
};

} // namespace brdfplot::choice
