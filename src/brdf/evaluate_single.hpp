/// \file
/// Evaluation in single precision.
#pragma once

#include "brdf/evaluate.hpp"

namespace brdfplot {

/// `evaluate` in single precision: where there are float kernels for it (lambda, g1, d and the BRDF of Beckmann and
/// GGX, Smith, F = 1), the directions and the parameters of the distribution are rounded to float, and the value is
/// within the kernels' bounds of theirs (tests/accuracy/bounds.hpp); on top of Lambda of Beckmann comes the rounding of
/// a = c / s, which e^(-a^2) magnifies 2 a^2 times. The rounding of the directions is no part of that bound: of the
/// BRDF it is up to 2^-22 (1 + 1 / (alpha cos theta)) within two alpha of the lobe's middle, while that is below 0.1,
/// and beyond that there is no bound. Otherwise it is the double one, rounded.
void evaluate(const Material& material, Quantity quantity, const Batch& batch, float* out,
              const std::string& term = "");

} // namespace brdfplot
