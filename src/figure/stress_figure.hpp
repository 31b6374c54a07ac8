/// \file
/// Maps of the errors of methods.
#pragma once

#include "choice/stress/error_map.hpp"
#include "draw/model.hpp"

namespace brdfplot::plot {

/// Of a problem of several inputs a heat map for each method, what is in double and in float side by side; of one
/// input a curve for each.
Figure stress_figure(const choice::ProblemMap& map);

} // namespace brdfplot::plot
