/// \file
/// A term of a sum left out.
#pragma once

#include "choice/advise/draft.hpp"

namespace brdfplot::choice {

/// Each term beside others, also the light of further bounces; what is a coat is taken off by LighterCoat. Colours of
/// the terms that stay are fitted anew.
struct FewerTerms {
  static std::vector<Option> of(const MaterialDescription& material);
};

/// The colours of all diffuse terms become free.
void free_colours(Draft& draft);

} // namespace brdfplot::choice
