/// \file
/// Tables of the report's page.
#pragma once

#include <string>

#include "draw/html/page.hpp"

namespace brdfplot::plot {

/// Appends a table; columns of numbers are set flush right.
void append_table(std::string& out, const Cells& table);

} // namespace brdfplot::plot
