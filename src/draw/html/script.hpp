/// \file
/// The script of the report's page.
#pragma once

#include <string_view>

namespace brdfplot::plot {

/// What the page can do with a script, and does without otherwise: a pointer on a figure reads its values, a legend's
/// entry hides its series, a figure opens large, and files are made from what the page holds. It asks for nothing.
std::string_view page_script();

} // namespace brdfplot::plot
