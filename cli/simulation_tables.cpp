#include "simulation_tables.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace brdfplot::cli {

namespace {

bool is_error(const std::string& column) { return column.ends_with("_stderr"); }

bool is_angle(const std::string& column) {
  return column.starts_with("theta_") || column.starts_with("phi_") || column == "delta_phi";
}

std::string fixed(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", std::clamp(decimals, 0, 12), value);
  return text.data();
}

std::string short_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

std::string measured(double value, double error) {
  if (!std::isfinite(value)) return "";
  if (!std::isfinite(error)) return short_number(value);
  if (!(error > 0)) return short_number(value) + " ± 0";
  const int decimals = 1 - static_cast<int>(std::floor(std::log10(error)));
  return fixed(value, decimals) + " ± " + fixed(error, decimals);
}

std::string cell(const simulation::Table& table, const std::vector<double>& row, std::size_t k) {
  const bool has_error = k + 1 < row.size() && is_error(table.columns[k + 1]);
  if (has_error) return measured(row[k], row[k + 1]);
  if (!std::isfinite(row[k])) return "";
  if (is_angle(table.columns[k])) return short_number(row[k] * 180 / std::numbers::pi) + "°";
  return short_number(row[k]);
}

} // namespace

std::vector<simulation::Table> all_tables(const simulation::SimulationResult& result) {
  std::vector<simulation::Table> all = {result.surface};
  all.insert(all.end(), result.tables.begin(), result.tables.end());
  return all;
}

std::string table_csv(const simulation::Table& table) {
  std::string out;
  for (const auto& column : table.columns) out += (out.empty() ? "" : ",") + column;
  out += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k > 0) out += ',';
      if (std::isfinite(row[k])) append_number(out, row[k]);
    }
    out += '\n';
  }
  return out;
}

std::string table_markdown(const simulation::Table& table, double traced) {
  std::string out = "# " + table.id + "\n\n";
  if (traced < 1) out += "Partial: stopped after " + fixed(100 * traced, 1) + " % of the rays.\n\n";
  std::string rule;
  for (const auto& column : table.columns) {
    if (is_error(column)) continue;
    out += "| " + column + " ";
    rule += "| --- ";
  }
  out += "|\n" + rule + "|\n";
  for (const auto& row : table.rows) {
    for (std::size_t k = 0; k < row.size(); ++k)
      if (!is_error(table.columns[k])) out += "| " + cell(table, row, k) + " ";
    out += "|\n";
  }
  return out;
}

} // namespace brdfplot::cli
