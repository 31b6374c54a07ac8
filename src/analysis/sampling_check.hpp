/// \file
/// Whether a sampler draws what its density says, and what that is worth for a material.
#pragma once

#include "analysis/weight_moments.hpp"

#include <cstdint>
#include <vector>

namespace brdfplot {

struct SamplingTest {
  std::size_t samples = 20000;
  std::uint64_t seed = 1;
  double significance = 0.01; ///< of the chi-square test of each viewer
  double integral_tolerance = 1e-6;
  double most_errors = 4; ///< standard errors between the mean weight and the albedo
};

/// Of one viewer.
struct SamplingFindings {
  Estimate integral;         ///< of the density over the sphere
  double chi_squared = 0;    ///< Pearson's, of samples in cells against the density's integrals over these
  std::size_t cells = 0;     ///< with at least 10 expected each
  double p_value = 1;        ///< the chance of a larger one, if samples follow the density
  double mean_weight = 0;    ///< of the channel that is furthest from its albedo
  double standard_error = 0; ///< of it, from the samples; at least one sample of the mean weight
  double albedo = 0;
  double errors_apart = 0;   ///< |mean_weight - albedo| in standard errors
  double mean_square = 0;    ///< of the weights of the first channel
  double square_error = 0;   ///< of it, the larger of the samples' and quadrature's; at least one sample of the largest
  Estimate expected_square;  ///< int f^2 cos^2 / pdf by quadrature
  double squares_apart = 0;  ///< |mean_square - expected_square| in standard errors
  double largest_weight = 0; ///< of samples, and of directions where the BRDF is large
  std::size_t untold = 0;    ///< densities that are negative or no number
  std::size_t uncovered = 0; ///< directions with a BRDF above 0 and a density of 0

  bool holds(const SamplingTest& test) const;
  /// What does not, in words; empty where all does.
  std::vector<std::string> faults(const SamplingTest& test) const;
};

/// Tests a sampler at a viewer against `density`, its own or another. The sphere is divided among what the sampler
/// draws by, terms and components of distributions, each direction by what each has of the density there; the share of
/// each is looked at where it is as wide as all others: in the unit square of the share of the ground and the azimuth,
/// in the slopes of its frame, or of Lambert's lobe. So a cell holds as much of a peak of alpha = 0.001 as of one of
/// alpha = 1. \pre omega_o above the horizon of the mesosurface \throws AccuracyError where a BRDF or the albedo misses
/// its accuracy
SamplingFindings check_sampling(const Material& material, const Sampler& sampler, const Direction& omega_o,
                                const SamplingTest& test, const PairDensity& density);
SamplingFindings check_sampling(const Material& material, const Sampler& sampler, const Direction& omega_o,
                                const SamplingTest& test);

/// The significance of each of n tests that all hold with a chance of 1 - significance together (Sidak 1967).
double sidak(double significance, std::size_t n);

} // namespace brdfplot
