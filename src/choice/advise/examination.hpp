/// \file
/// What is looked at once an answer is there, as data.
#pragma once

#include "choice/advise/images/errors.hpp"
#include "simulation/statistics.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace brdfplot::choice {

/// Decisive errors under more directions of each disc.
struct FinerLight {
  std::size_t directions = 0;
  double answer = 0, next_cheaper = 0;
};

/// Where a model is farthest from the material in full, in or out of the scene's angles (radians).
struct Break {
  double alpha_factor = 1; ///< of every roughness of both
  double difference = 0;   ///< by the metric of the scene
  double theta_o = 0, theta_i = 0, azimuth = 0;
};

/// The material in full against all bounces on its microsurface.
struct AgainstWalk {
  std::size_t places = 0;
  simulation::Measured light;   ///< relative difference of the mean radiance
  simulation::Measured largest; ///< of the place that is farthest off, in the channel that is
  sphere::Place where{};
};

struct Examination {
  std::optional<PictureErrors> single; ///< of a shader, where its forms are known in single precision
  std::optional<FinerLight> finer;     ///< where there are discs
  double irradiance = 0;               ///< of the light of `breaks`
  std::vector<Break> breaks;
  std::optional<AgainstWalk> walk; ///< where a term stands for further bounces on a surface that can be walked on
};

} // namespace brdfplot::choice
