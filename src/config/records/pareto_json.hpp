/// \file
/// What `brdfplot pareto --json` prints.
#pragma once

#include "choice/pareto/pareto.hpp"

#include <string>

namespace brdfplot::config {

/// Problems with their methods: operations, cost, errors with the inputs where they are largest, times, fronts. Numbers
/// that are not finite are null. `machine`: where times were measured, if they were.
std::string pareto_record(const std::vector<choice::ProblemResult>& results,
                          const std::optional<choice::MachineRecord>& machine, const std::string& version);

} // namespace brdfplot::config
