/// \file
/// Errors over two inputs of a problem, or over its only one, as data of a figure.
#pragma once

#include "choice/stress/stress.hpp"

namespace brdfplot::choice {

/// A drawn input. Cosines are drawn as their angles, near 0 as well as near the horizon.
struct MapAxis {
  std::string name;
  bool logarithmic = false;
  bool angle_of_cosine = false;
  std::vector<double> at; ///< what is drawn

  /// The input at a drawn number.
  double input(double drawn) const;
};

/// log10 of relative errors; NaN where the value is no number.
struct ErrorMap {
  std::string method;
  bool single = false;
  std::vector<double> seen; ///< of what is seen; x fastest
  std::vector<double> own;  ///< of the value itself, where that is not what is seen
};

struct ProblemMap {
  std::string problem;
  std::string doc;
  std::string seen_as; ///< what is seen, where it is not the value
  MapAxis x, y;        ///< y without numbers: of one input
  std::string fixed;   ///< the other inputs, "cos_theta = 1"
  std::vector<ErrorMap> maps;
};

/// Of the formulas and kernels that every machine has, not of fits and tables; the inputs that are not drawn are those
/// of the largest error that was found. \pre the problem has exact values
ProblemMap error_map(const Problem& problem, const std::vector<MethodReport>& reports);

} // namespace brdfplot::choice
