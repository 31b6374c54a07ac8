/// \file
/// Fewer digits.
#pragma once

#include "choice/advise/draft.hpp"

namespace brdfplot::choice {

/// Double -> single precision. None where a part of the material has no form whose rounding is known (single.hpp).
struct SingleNumbers {
  static Option of();
};

} // namespace brdfplot::choice
