/// \file
/// Text that names publications.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "draw/html/page.hpp"

namespace brdfplot::plot {

/// Appends text with label markup for HTML; the first mention of each publication is a link to its entry in the list.
void append_cited(std::string& out, std::string_view text, const std::vector<Reference>& references);

/// Appends the list: each an entry of its own, with its link.
void append_references(std::string& out, const std::vector<Reference>& references);

} // namespace brdfplot::plot
