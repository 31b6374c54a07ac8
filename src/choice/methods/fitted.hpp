/// \file
/// Rationals made by `brdfplot fit`, as methods.
#pragma once

#include "choice/methods/method.hpp"

namespace brdfplot::choice {

/// Lambda(a) of Beckmann's or GGX's slopes, within a relative error of G1 of each tolerance, a power of ten: fit_1e-3
/// and, with its coefficients as floats, fit_1e-3_float. The fit is made when they are.
void add_lambda_fits(Problem& problem, const std::string& distribution, const std::vector<double>& tolerances);

} // namespace brdfplot::choice
