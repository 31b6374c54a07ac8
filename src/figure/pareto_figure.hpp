/// \file
/// The charts of `brdfplot pareto`.
#pragma once

#include "choice/pareto/pareto.hpp"
#include "draw/model.hpp"

namespace brdfplot::plot {

/// Counted cost against both errors of all methods of a problem, in two panels, NAME_cost: those that every machine
/// has.
Figure pareto_figure(const choice::ProblemResult& result);
/// Measured cost, NAME_time.
Figure pareto_figure(const choice::ProblemResult& result, const choice::MachineRecord& machine);

/// "kernel", "published approximation", ...: how charts and tables call a kind.
std::string_view kind_word(choice::Kind kind);

} // namespace brdfplot::plot
