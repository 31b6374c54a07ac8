#include "report_tables.hpp"

#include "math/number.hpp"
#include "plot/text.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace brdfplot::cli {

namespace {

std::string_view word(Verdict verdict) {
  return verdict == Verdict::holds ? "true" : verdict == Verdict::fails ? "false" : "unknown";
}

std::string_view mark(Verdict verdict) {
  return verdict == Verdict::holds ? "✓" : verdict == Verdict::fails ? "×" : "?";
}

Verdict verdict_of(const PropertyRow& row) {
  using enum Verdict;
  for (const Residual* residual : {&row.eq14, &row.eq18, &row.eq36})
    if (residual->verdict == fails) return fails;
  return row.physically_based() ? holds : unknown;
}

/// A number for the eye: two digits, or one and a power of ten when it is tiny.
struct Short {
  std::string digits;
  int exponent = 0; ///< 0: none
};

Short shorten(double value) {
  std::array<char, 32> buffer{};
  if (value == 0 || value >= 1e-3) {
    std::snprintf(buffer.data(), buffer.size(), "%.2g", value);
    return {buffer.data()};
  }
  std::snprintf(buffer.data(), buffer.size(), "%.0e", value);
  const std::string text = buffer.data();
  const auto e = text.find('e');
  return {text.substr(0, e), std::stoi(text.substr(e + 1))};
}

std::string plain(const Residual& residual) {
  const Short number = shorten(residual.max_residual);
  return std::string(mark(residual.verdict)) + " " + number.digits +
         (number.exponent == 0 ? "" : "e" + std::to_string(number.exponent));
}

std::string with_markup(const Residual& residual) {
  const Short number = shorten(residual.max_residual);
  return std::string(mark(residual.verdict)) + " " + number.digits +
         (number.exponent == 0 ? "" : "·10^{" + std::to_string(number.exponent) + "}");
}

template <class Format>
std::vector<std::vector<std::string>> cells(const std::vector<PropertyRow>& rows, const Format& format) {
  std::vector<std::vector<std::string>> table = {
      {"masking", "distribution", "Eq. 14", "Eq. 18", "Eq. 36", "physically based"}};
  for (const auto& row : rows)
    table.push_back({row.masking, row.distribution, format(row.eq14), format(row.eq18), format(row.eq36),
                     std::string(mark(verdict_of(row)))});
  return table;
}

} // namespace

std::string table_csv(const std::vector<PropertyRow>& rows) {
  constexpr std::array<std::string_view, 3> equations = {"eq14", "eq18", "eq36"};
  std::string out = "distribution,masking";
  for (const auto equation : equations)
    (out += ',').append(equation).append("_max_residual,").append(equation).append("_holds");
  out += ",physically_based";
  for (const auto equation : equations)
    (out += ',').append(equation).append("_alpha,").append(equation).append("_theta_o");
  out += '\n';
  for (const auto& row : rows) {
    const std::array<const Residual*, 3> residuals = {&row.eq14, &row.eq18, &row.eq36};
    out += row.distribution + "," + row.masking;
    for (const Residual* residual : residuals)
      (out += "," + format_number(residual->max_residual) + ",").append(word(residual->verdict));
    (out += ',').append(word(verdict_of(row)));
    // Where the largest of residuals that are rounding stands is chance, and would change from machine to machine.
    for (const Residual* residual : residuals)
      out += residual->verdict == Verdict::holds
                 ? ",,"
                 : "," + format_number(residual->alpha) + "," + format_number(residual->theta_o);
    out += '\n';
  }
  return out;
}

std::string table_markdown(const PropertyTableDescription& table, const std::vector<PropertyRow>& rows) {
  std::string out = "# " + plot::strip_markup(table.title) + "\n\n" + plot::strip_markup(table.caption) + "\n\n";
  bool header = true;
  for (const auto& line : cells(rows, plain)) {
    for (const auto& cell : line) out += "| " + cell + " ";
    out += "|\n";
    if (header)
      for (std::size_t k = 0; k < line.size(); ++k) out += "| --- ";
    if (header) out += "|\n";
    header = false;
  }
  return out;
}

std::vector<std::vector<std::string>> table_cells(const std::vector<PropertyRow>& rows) {
  return cells(rows, with_markup);
}

} // namespace brdfplot::cli
