/// \file
/// The list of surfaces. A new one is one file in surfaces/ and one line here.
///
/// Each has spec() and from(values); `problem()`, what is wrong with values that are each within bounds;
/// `realise(seed, realisation)`, the mesh; `asked()`, the map of slopes asked (none: nothing is); `target()`, the
/// distribution of slopes that is meant, and `unit_slopes()`, what these are at unit roughness. One that is the same for
/// every seed declares `is_given`.
#pragma once

#include "simulation/surfaces/gaussian.hpp"
#include "simulation/surfaces/ggx.hpp"
#include "simulation/surfaces/height_map.hpp"
#include "simulation/surfaces/v_cavity.hpp"

#include <variant>

namespace brdfplot::simulation {

using Surface = std::variant<GaussianSurface, //
                             GgxSurface,      //
                             VCavitySurface,  //
                             HeightMapSurface>;

/// \throws SceneError with a pointer that starts at "/surface".
Surface build_surface(const ModelChoice& choice);

} // namespace brdfplot::simulation
