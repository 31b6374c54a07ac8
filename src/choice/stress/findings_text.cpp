#include "choice/stress/findings_text.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace brdfplot::choice {

namespace {

/// The shortest text that reads back to the same number of its type.
std::string input_text(double x, bool single) {
  if (!single) return format_number(x);
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, static_cast<float>(x)).ptr;
  return {text, end};
}

std::string short_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

std::string padded_to(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 2), ' ');
  return text;
}

/// A field of a CSV file (RFC 4180).
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

/// A cell of a table, in which `|` would end it.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

std::string block_of(const MethodReport& report) {
  std::string out = report.problem + "/" + report.method + "\n";
  for (const Finding& finding : report.findings) {
    out += "  " + padded_to(std::string(finding.kind->name), 19) + padded_to(short_text(finding.worst), 10) + "at " +
           row_text(finding.inputs, finding.worst_at, finding.single) + ": " + short_text(finding.value) +
           (finding.has_exact ? " for " + short_text(finding.exact) : "") + "\n";
    out += std::string(21, ' ') + "simplest " + row_text(finding.inputs, finding.simplest, finding.single) + "; at " +
           region_text(finding) + "\n";
  }
  return out + "  mend: " + report.findings.front().mend + "\n";
}

} // namespace

std::string row_text(const std::vector<std::string>& names, const Row& row, bool single) {
  std::string out;
  for (std::size_t k = 0; k < row.size(); ++k)
    out += (k > 0 ? ", " : "") + names[k] + " = " + input_text(row[k], single);
  return out;
}

std::string region_text(const Finding& finding) {
  std::string out;
  for (std::size_t k = 0; k < finding.inputs.size(); ++k)
    out += (k > 0 ? ", " : "") + finding.inputs[k] + " " + short_text(finding.from[k]) + " .. " +
           short_text(finding.to[k]);
  return out;
}

std::string findings_table(const std::vector<MethodReport>& reports) {
  std::string out;
  for (const MethodReport& report : reports)
    if (!report.findings.empty()) out += (out.empty() ? "" : "\n") + block_of(report);
  return out;
}

std::string findings_csv(const std::vector<MethodReport>& reports) {
  std::string out = "problem,method,kind,worst,worst_at,value,exact,simplest,region,rows,of_rows,mend\n";
  for (const MethodReport& report : reports)
    for (const Finding& f : report.findings)
      out += f.problem + "," + f.method + "," + std::string(f.kind->name) + "," + format_number(f.worst) + "," +
             csv_field(row_text(f.inputs, f.worst_at, f.single)) + "," + format_number(f.value) + "," +
             (f.has_exact ? format_number(f.exact) : "") + "," + csv_field(row_text(f.inputs, f.simplest, f.single)) +
             "," + csv_field(region_text(f)) + "," + std::to_string(f.rows) + "," + std::to_string(report.rows) + "," +
             csv_field(f.mend) + "\n";
  return out;
}

std::string findings_markdown(const std::vector<MethodReport>& reports) {
  std::string out = "| method | failure | worst | simplest input | found for | what mends it |\n"
                    "| -- | -- | -- | -- | -- | -- |\n";
  for (const MethodReport& report : reports)
    for (const Finding& f : report.findings)
      out += "| " + f.problem + "/" + f.method + " | " + std::string(f.kind->name) + " | " + short_text(f.worst) +
             " | " + row_text(f.inputs, f.simplest, f.single) + " | " + region_text(f) + " | " + cell(f.mend) + " |\n";
  return out;
}

} // namespace brdfplot::choice
