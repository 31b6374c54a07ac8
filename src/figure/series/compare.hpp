/// \file
/// How far a lobe is from a simulated one.
#pragma once

#include "figure/series/simulated.hpp"

#include <vector>

namespace brdfplot::plot {

/// Two notes on a lobe f beside a simulated lobe g, both over theta_i in the plane of incidence: the distance
/// int |f - g| / int g, and how much further towards the viewer the mean of theta_i lies for f than for g. What is
/// simulated is a mean over bins; f is averaged over the same bins, which are as wide across the plane. Standard errors
/// by leaving out one surface at a time. The distance holds the noise of g: where f is right, it is not 0 but about
/// the relative error of a bin.
std::vector<Note> compare_lobes(const Term& lobe, const SimulatedTerm& simulated, const std::vector<double>& theta_i,
                                simulation::Store& store, int threads);

} // namespace brdfplot::plot
