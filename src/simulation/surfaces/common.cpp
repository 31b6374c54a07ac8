#include "simulation/surfaces/common.hpp"

#include "base/number.hpp"

#include <utility>

namespace brdfplot::simulation {

std::vector<ParameterSpec> RandomMesh::parameters() {
  std::vector<ParameterSpec> all = SlopeMap::parameters();
  all.push_back({.key = "samples",
                 .bounds = {.min = 8, .max = 8192},
                 .fallback = 1024.0,
                 .doc = "heights along each side of the period; a whole number"});
  all.push_back(
      {.key = "correlation_length",
       .bounds = {.min = 2},
       .fallback = 16.0,
       .doc = "distance in cells at which the autocorrelation is 1/e, along the axis of the steepest slopes"});
  all.push_back({.key = "autocorrelation",
                 .kind = ParameterKind::choice,
                 .fallback = std::string("gaussian"),
                 .doc = "of the heights: exp(-rho^2), smooth, or exp(-rho), rough down to the cells",
                 .choices = {"gaussian", "exponential"}});
  return all;
}

RandomMesh RandomMesh::from(const Values& values) {
  return {SlopeMap::from(values), values.number("samples"), values.number("correlation_length"),
          values.text("autocorrelation") == "gaussian" ? Autocorrelation::gaussian : Autocorrelation::exponential};
}

std::optional<ParameterError> RandomMesh::problem() const {
  if (auto of_slopes = slopes.problem()) return of_slopes;
  if (samples != std::floor(samples))
    return ParameterError{"samples", "found " + format_number(samples) + ", accepted: a whole number in [8, 8192]"};
  if (correlation_length > samples / 4)
    return ParameterError{"correlation_length", "found " + format_number(correlation_length) +
                                                    ", accepted: a number in [2, samples / 4], here " +
                                                    format_number(samples / 4)};
  return std::nullopt;
}

FieldRequest RandomMesh::request() const {
  const auto n = static_cast<int>(samples);
  return {n, n, autocorrelation, correlation_length, covariance(slopes)};
}

HeightField RandomMesh::mesh(std::vector<float> heights) const {
  const auto n = static_cast<int>(samples);
  return {n, n, std::move(heights), 0, Slope{slopes.mean_x, slopes.mean_y}};
}

} // namespace brdfplot::simulation
