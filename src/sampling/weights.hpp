/// \file
/// Directions as a renderer draws and weighs them.
#pragma once

#include "sampling/sampler.hpp"

#include <vector>

namespace brdfplot {

/// Directions of the light, their density (1/sr), and f cos / pdf, channel c of sample k at c n + k: the estimate of
/// the albedo that each sample is. 0 where the BRDF or the density is.
struct WeightedSamples {
  DirectionArrays lights;
  std::vector<double> pdf, weights;
};

/// Draws a sample for each point from one viewer. `samples` keeps its memory from call to call. \throws AccuracyError
/// where the BRDF misses its accuracy
void draw(const Material& material, const Sampler& sampler, const Direction& omega_o,
          const std::vector<SamplePoint>& points, WeightedSamples& samples);

} // namespace brdfplot
