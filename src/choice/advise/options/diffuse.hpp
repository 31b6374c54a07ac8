/// \file
/// A flatter diffuse term.
#pragma once

#include "choice/advise/draft.hpp"

namespace brdfplot::choice {

/// eon -> fujii_oren_nayar -> lambert; oren_nayar in full -> its qualitative fit -> lambert; every other diffuse term,
/// that which reflects what a mirror leaves too, -> lambert. The albedo is fitted anew.
struct FlatterDiffuse {
  static std::vector<Option> of(const MaterialDescription& material);
};

} // namespace brdfplot::choice
