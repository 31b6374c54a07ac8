/// \file
/// The results of `brdfplot pareto` as CSV and as cells of a table.
#pragma once

#include "choice/pareto/pareto.hpp"

#include <string>

namespace brdfplot::choice {

/// A row for each method: operations, cost, errors and where they are largest, front by counted cost. The same bytes
/// on every run.
std::string pareto_csv(const std::vector<ProblemResult>& results);

/// A row for each method: nanoseconds, and the machine that they were measured on.
std::string times_csv(const std::vector<ProblemResult>& results, const MachineRecord& machine);

/// A problem as a table: header first, methods from the cheapest by counted cost on, then those without one.
std::vector<std::vector<std::string>> pareto_cells(const ProblemResult& result);

/// "front by cost, G1: karis_2013_float 4 (0.163), rewritten_float 11 (3.4e-08), ...": from the cheapest on.
std::string front_line(const ProblemResult& result, CostKind cost, ErrorKind error);

/// What the columns of pareto_cells() mean, in lines.
std::string pareto_legend(bool times);

} // namespace brdfplot::choice
