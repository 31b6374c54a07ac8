/// \file
/// A table of properties as its files and as the page shows it.
#pragma once

#include "analysis/properties.hpp"

#include <string>
#include <vector>

namespace brdfplot::cli {

/// One line a row, in full: where the residuals are largest as well.
std::string table_csv(const std::vector<PropertyRow>& rows);

/// The table as Table 3 of Heitz 2014 shows it, under its title.
std::string table_markdown(const PropertyTableDescription& table, const std::vector<PropertyRow>& rows);

/// The same as cells with label markup; the first row is the header.
std::vector<std::vector<std::string>> table_cells(const std::vector<PropertyRow>& rows);

} // namespace brdfplot::cli
