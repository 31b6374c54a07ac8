/// \file
/// What a strategy is worth: how its weights f cos / pdf vary about their mean, the albedo.
#pragma once

#include "math/quadrature.hpp"
#include "sampling/sampler.hpp"

#include <functional>
#include <string>
#include <vector>

namespace brdfplot {

/// The density of each pair (1/sr), as Sampler::densities() writes it.
using PairDensity = std::function<void(std::size_t n, const Columns& omega_o, const Columns& omega_i, double* out)>;
PairDensity density_of(const Sampler& sampler);

/// Where the BRDF is below this, a density may be 0 by underflow: its factors are others.
inline constexpr double underflow_of_densities = 1e-280;

/// The mean of a power of the weights of one channel, int pdf (rho c_i / pdf)^power di over the lights above the
/// horizon; infinite where a density is 0 and the BRDF is not. By quadrature about what the material's terms are narrow
/// about, whatever the density. \pre omega_o above the horizon of the mesosurface; power >= 1
Estimate weight_moment(int power, const Material& material, const PairDensity& density, const Direction& omega_o,
                       double tolerance, int channel = 0);

/// The variance of the weights of one channel: weight_moment() of power 2 less the square of the albedo. `tolerance` is
/// relative to the mean square, or absolute below 1. \throws AccuracyError where it is missed
double weight_variance(const Material& material, const Sampler& sampler, const Direction& omega_o, double tolerance,
                       int channel = 0);

/// The largest weight of one channel among 4096 evenly spread samples of the strategy, and as many of the default one,
/// which is where the BRDF is large. At most the true one.
double largest_weight(const Material& material, const Sampler& sampler, const Direction& omega_o, int channel = 0);

/// Of a strategy: what figures draw. The costs are those of choice/advise/shader/sampling_cost.hpp.
enum class SampledQuantity { pdf, weight_variance, largest_weight, sampling_cost, variance_times_cost };

struct SampledQuantityInfo {
  SampledQuantity quantity;
  std::string name;
  std::string doc;
};

const std::vector<SampledQuantityInfo>& sampled_quantities();

} // namespace brdfplot
