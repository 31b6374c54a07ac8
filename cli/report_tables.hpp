/// \file
/// A table of properties as its files and as the page shows it.
#pragma once

#include "analysis/properties.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace brdfplot::cli {

/// ✓, ✗, ? where it cannot be told, - where it does not apply.
std::string_view mark(Verdict verdict);

/// "2e-11", two digits from 1e-3 on; nothing of what is not finite.
std::string short_number(double value);

/// The last guard: what is wrong with each residual that is not finite. Tables have an empty cell for it.
std::vector<std::string> untold(const PropertyRow& row);

/// One line a row, in full: where the residuals are largest as well.
std::string table_csv(const std::vector<PropertyRow>& rows);

/// The rows of one masking function as one, as Table 3 of Heitz 2014 has them: a property holds where it does for every
/// distribution, and the residual is the largest. Empty where that is the table itself.
std::vector<PropertyRow> by_masking(const std::vector<PropertyRow>& rows);

/// The table under its title; before it that by masking function.
std::string table_markdown(const std::string& title, const std::string& caption, const std::vector<PropertyRow>& rows);

/// The same as cells of plain text; the first row is the header.
std::vector<std::vector<std::string>> plain_cells(const std::vector<PropertyRow>& rows);

/// A table under its title; the first row is the header.
std::string table_markdown(const std::string& title, const std::string& caption,
                           const std::vector<std::vector<std::string>>& cells);

/// The same as cells with label markup; the first row is the header.
std::vector<std::vector<std::string>> table_cells(const std::vector<PropertyRow>& rows);

} // namespace brdfplot::cli
