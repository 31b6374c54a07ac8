/// \file
/// A closer look at an answer: what the search does not see.
#pragma once

#include "choice/advise/advise.hpp"

namespace brdfplot::choice {

/// Of the answer, if there is one:
///   single   the answer of a shader in single precision
///   finer    the errors of the answer and the next cheaper model against five times the directions of each disc
///   breaks   where both materials differ most under the brightest light alone, as punctual (a climb in the angles of
///            viewer and light from the worst place, over the whole hemisphere); and the same with half and with twice
///            the roughness, where no table is made of it
///   walk     the material in full against the walk on Smith's surface (simulation/walk.hpp), with its standard error
Examination examine(const AdviceScene& scene, const MaterialAdvice& advice, int threads);

} // namespace brdfplot::choice
