/// \file
/// The error curve of a fit of Lambda.
#pragma once

#include "analysis/fit/fit.hpp"
#include "draw/model.hpp"

namespace brdfplot::plot {

/// The relative error of G1, without rounding, against a, with the tolerance; one curve for each of some values of the
/// parameter where there is one.
Figure fit_error_figure(const FitResult& result, double tolerance, const std::string& id);

} // namespace brdfplot::plot
