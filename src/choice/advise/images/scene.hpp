/// \file
/// A scene for which the least model is looked for, as data.
#pragma once

#include "brdf/material.hpp"
#include "choice/advise/target.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace brdfplot::choice {

/// A light far away. Directions go from the surface: theta from the direction of the viewer, phi from the right of the
/// picture, counterclockwise (radians).
struct AdviceLight {
  double theta = 0, phi = 0;
  double radius = 0;   ///< the angle under which the radius of its disc is seen; 0: punctual
  Colour irradiance{}; ///< across its direction
};

/// Angles between normal and viewer that are seen, as a histogram.
struct ViewRange {
  std::vector<double> edges;  ///< ascending, in [0, pi/2]
  std::vector<double> shares; ///< of what is seen, one for each bin; none: as a sphere has them
};

enum class Metric {
  delta_e, ///< Delta E_ITP (ITU-R BT.2124)
  relative ///< relative difference of radiance
};

struct Tolerance {
  Metric metric = Metric::delta_e;
  double value = 1;
};

/// A material in full, and over which values of its parameters the simpler one has to stand for it.
struct AdvisedMaterial {
  MaterialDescription material;
  std::vector<std::pair<std::string, std::vector<double>>> ranges{}; ///< parameter and its other values
  std::string place{};                                               ///< where it stands in the file
};

struct AdviceScene {
  std::string name;
  std::vector<AdvisedMaterial> materials;
  std::vector<AdviceLight> lights;
  ViewRange view;
  double exposure = 1; ///< radiance times it is shown, 1 as white of 203 cd/m^2
  Tolerance tolerance;
  Target target = Target::shader;
  std::optional<double> budget; ///< of cost_unit(), for each shaded point
};

/// The material as it is given, then with each other value of each range in turn. \throws MaterialError
std::vector<MaterialDescription> variants_of(const AdvisedMaterial& material);

} // namespace brdfplot::choice
