/// \file
/// The charts of `brdfplot pareto`.
#pragma once

#include "choice/pareto/pareto.hpp"
#include "draw/model.hpp"

namespace brdfplot::plot {

/// Cost against both errors of all methods of a problem, in two panels. By counted cost it is the same on every
/// machine; by measured cost it names the machine.
Figure pareto_figure(const choice::ProblemResult& result, choice::CostKind cost, const choice::MachineRecord& machine);

/// "kernel", "published approximation", ...: how charts and tables call a kind.
std::string_view kind_word(choice::Kind kind);

} // namespace brdfplot::plot
