/// \file
/// Tables as JSON.
#pragma once

#include "bake/table.hpp"

#include <string>

namespace brdfplot::config {

/// What `bake --json` prints: axes, values with the first axis fastest, and the error. `rounding`: of the numbers as
/// they are stored.
std::string bake_record(const bake::BakedTable& baked, double rounding);

} // namespace brdfplot::config
