/// \file
/// The style sheet of the report's page.
#pragma once

#include <string>

namespace brdfplot::plot {

/// Appends the rules of the page: light and dark, wide and narrow, and print. The figures take their dark colours from
/// the variables set here; on paper they stay light.
void append_page_style(std::string& css);

} // namespace brdfplot::plot
