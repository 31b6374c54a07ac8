/// \file
/// What a shader computes for a material, counted over the formulas of forms.hpp.
#pragma once

#include "choice/advise/images/scene.hpp"
#include "choice/advise/target.hpp"
#include "choice/methods/operations.hpp"

namespace brdfplot::choice {

/// How discs of lights are lit by.
struct LightModel {
  enum class Kind { points, nearest, punctual } kind = Kind::points;
  std::size_t rings = 4; ///< points: rings x 4 rings directions of each disc (cap_points.hpp)

  friend bool operator==(const LightModel&, const LightModel&) = default;
};

/// Of one shaded point: what depends on the viewer alone, and what each direction of light adds.
struct ShaderOperations {
  Operations view, light;
};

/// Estimated: a straightforward shader in the frame of the surface, constants of the material made before, F5 and half
/// vectors once for all that share them, three channels where any part is coloured.
/// \throws InputError for a term that no shader computes in closed form or by a table (facet_diffuse)
ShaderOperations shader_operations(const MaterialDescription& material);

/// Where a material runs.
struct Machine {
  Target target = Target::shader;
  Precision precision = Precision::full;
};

/// cost() of a shaded point under all lights (target.hpp): view + light for each direction. A nearest point adds
/// its direction, and a second set of directions for diffuse terms, which keep the middle.
double shader_cost(const MaterialDescription& material, const std::vector<AdviceLight>& lights, const LightModel& model,
                   const Machine& machine = {});

} // namespace brdfplot::choice
