#include "draw/html/table.hpp"

#include <cstddef>
#include <vector>

#include "base/number.hpp"
#include "draw/text.hpp"

namespace brdfplot::plot {

namespace {

/// A cell that may be broken within names_of_several_words, as a narrow page has to.
void append_breakable(std::string& out, const std::string& text) {
  std::string cell;
  append_html(cell, text);
  for (const char c : cell) {
    out += c;
    if (c == '_') out += "<wbr>";
  }
}

void append_row(std::string& out, const std::vector<std::string>& row, const std::vector<bool>& numeric, bool header) {
  out += "<tr>";
  for (std::size_t i = 0; i < row.size(); ++i) {
    out += header ? "<th scope=\"col\"" : "<td";
    if (i < numeric.size() && numeric[i]) out += " class=\"num\"";
    out += '>';
    append_breakable(out, row[i]);
    out += header ? "</th>" : "</td>";
  }
  out += "</tr>\n";
}

/// The columns that hold numbers only.
std::vector<bool> numeric_columns(const Cells& table) {
  std::vector<bool> numeric(table.front().size(), table.size() > 1);
  for (std::size_t r = 1; r < table.size(); ++r) {
    for (std::size_t c = 0; c < numeric.size(); ++c) {
      const bool number = c < table[r].size() && parse_number(table[r][c]).has_value();
      if (!number) numeric[c] = false;
    }
  }
  return numeric;
}

} // namespace

void append_table(std::string& out, const Cells& table) {
  const auto numeric = numeric_columns(table);
  out += "<div class=\"scroll\" tabindex=\"0\"><table>\n<thead>";
  append_row(out, table.front(), numeric, true);
  out += "</thead>\n<tbody>\n";
  for (std::size_t r = 1; r < table.size(); ++r) append_row(out, table[r], numeric, false);
  out += "</tbody></table></div>\n";
}

} // namespace brdfplot::plot
