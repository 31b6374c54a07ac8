/// \file
/// A cheaper G2 / (4 c_o c_i).
#pragma once

#include "choice/advise/draft.hpp"

namespace brdfplot::choice {

/// Smith's masking with any G2 -> height-correlated -> (Beckmann: Walter's rational Lambda) -> separable -> Karis's
/// Lambda, height-correlated (Hammon's form) -> constant (implicit). Of `sheen`: its published fit, and Neubelt and
/// Pettineo's denominator.
struct CheaperVisibility {
  static std::vector<Option> of(const MaterialDescription& material);
};

} // namespace brdfplot::choice
