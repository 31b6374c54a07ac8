/// \file
/// What the light of further bounces is worth, by a walk on the surface.
#pragma once

#include "choice/advise/advise.hpp"

namespace brdfplot::choice {

/// A term `multiple_bounce` or `turquin` with the term that it is of, against all bounces of the walk on Smith's
/// surface at eight places that each stand for an eighth of what is lit; discs as punctual lights. None where there is
/// no such term, or no walk on its surface.
std::optional<AgainstWalk> against_walk(const AdviceScene& scene, const MaterialDescription& full,
                                        const Reference& reference, int threads);

} // namespace brdfplot::choice
