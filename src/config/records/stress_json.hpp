/// \file
/// What `brdfplot stress --json` prints.
#pragma once

#include "choice/stress/stress.hpp"

#include <string>

namespace brdfplot::config {

/// Every method with its largest error and its failures. Numbers that are not finite are null.
std::string stress_record(const std::vector<choice::MethodReport>& reports, const std::string& version);

} // namespace brdfplot::config
