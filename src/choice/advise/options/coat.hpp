/// \file
/// A coat that takes less account of what lies beneath it, or none.
#pragma once

#include "choice/advise/draft.hpp"

namespace brdfplot::choice {

/// Attenuation both ways -> the viewer's way (half) -> none -> the coat left out, whose base is
/// fitted anew; and the tint left out.
struct LighterCoat {
  static std::vector<Option> of(const MaterialDescription& material);
};

} // namespace brdfplot::choice
