/// \file
/// Cost against error, with the Pareto front: of methods, or of models.
#pragma once

#include "draw/model.hpp"

#include <optional>
#include <string>
#include <vector>

namespace brdfplot::plot {

/// What is compared. Cost and error that are not finite or not above 0 have no place on axes of powers of ten: such a
/// point is told of in words under the title.
struct CostPoint {
  std::string name;
  double cost = 0;
  double error = 0;
  bool on_front = false;
  std::string group{}; ///< points of a group share a colour, and an entry of the legend; in the order they come in
  double cost_to = 0;  ///< above `cost`: how far a measured cost spreads, drawn as a line to there
};

/// One panel.
struct CostChart {
  std::string title; ///< of the panel; may be empty
  std::vector<CostPoint> points;
  Axis cost;                         ///< label and column; logarithmic
  Axis error;                        ///< label and column; logarithmic
  std::optional<double> tolerance{}; ///< a line across, named "tolerance"
};

/// A panel for each chart, below each other: the front as a staircase, the points on it and the others as dots with
/// their names. Points of a group that lie on each other are one dot.
Figure cost_figure(const std::vector<CostChart>& charts, const std::string& id, const std::string& title,
                   const std::string& description);

} // namespace brdfplot::plot
