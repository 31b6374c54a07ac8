/// \file
/// What is said of a table.
#pragma once

#include "bake/table.hpp"

#include <string>

namespace brdfplot::bake {

/// Size, axes and error of a table, a few lines. `rounding`: of the numbers as they are stored.
std::string summary(const BakedTable& baked, double rounding);

} // namespace brdfplot::bake
