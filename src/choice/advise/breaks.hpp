/// \file
/// From the worst place of a scene to a worse one outside of it.
#pragma once

#include "choice/advise/advise.hpp"

namespace brdfplot::choice {

/// The brightest light.
const AdviceLight& brightest(const AdviceScene& scene);

/// By pattern search from the worst place of the scene and from the worst three of a grid of 360 pairs: one of the
/// angles of both directions moves up or down by a step that starts at 0.4 rad and is halved down to 1e-3 where none is
/// worse. It is a lower bound of the worst. Angles from the normal end at 89.9 degrees.
std::vector<Break> breaks_of(const AdviceScene& scene, const MaterialAdvice& advice);

} // namespace brdfplot::choice
