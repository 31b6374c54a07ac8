#include "report_tables.hpp"

#include "base/number.hpp"
#include "draw/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace brdfplot::cli {

namespace {

std::string_view word(Verdict verdict) {
  switch (verdict) {
  case Verdict::holds: return "true";
  case Verdict::fails: return "false";
  case Verdict::unknown: return "unknown";
  case Verdict::not_applicable: break;
  }
  return "does not apply";
}

/// A number for the eye: two digits, or one and a power of ten when it is tiny; nothing where there is none.
struct Short {
  std::string digits;
  int exponent = 0; ///< 0: none
};

Short shorten(double value) {
  if (!std::isfinite(value)) return {};
  std::array<char, 32> buffer{};
  if (!(value < 1e-3) || value == 0) {
    std::snprintf(buffer.data(), buffer.size(), "%.2g", value);
    return {buffer.data()};
  }
  std::snprintf(buffer.data(), buffer.size(), "%.0e", value);
  const std::string text = buffer.data();
  const auto e = text.find('e');
  return {text.substr(0, e), std::stoi(text.substr(e + 1))};
}

std::string plain(const Residual& residual) {
  const std::string sign(mark(residual.verdict));
  return std::isfinite(residual.max_residual) && residual.verdict != Verdict::not_applicable
             ? sign + " " + short_number(residual.max_residual)
             : sign;
}

std::string with_markup(const Residual& residual) {
  const Short number = shorten(residual.max_residual);
  std::string sign(mark(residual.verdict));
  if (residual.verdict == Verdict::not_applicable || number.digits.empty()) return sign;
  if (number.exponent == 0) return sign + " " + number.digits;
  const std::string exponent = (number.exponent < 0 ? "−" : "") + std::to_string(std::abs(number.exponent));
  return sign + " " + number.digits + "·10^{" + exponent + "}";
}

/// A name in a cell with label markup: its underscores are its own.
std::string literal(const std::string& name) {
  std::string out;
  for (const char c : name) out += c == '_' ? "\\_" : std::string(1, c);
  return out;
}

/// The properties that any row has, in their order.
std::vector<PropertyInfo> measured(const std::vector<PropertyRow>& rows) {
  std::vector<PropertyInfo> out;
  for (const auto& info : properties())
    if (std::ranges::any_of(rows, [&](const auto& row) { return row.residuals.contains(info.property); }))
      out.push_back(info);
  return out;
}

bool has_materials(const std::vector<PropertyRow>& rows) {
  return std::ranges::any_of(rows, [](const auto& row) { return !row.material.empty(); });
}

template <class Format>
std::vector<std::vector<std::string>> cells(const std::vector<PropertyRow>& rows, const Format& format) {
  const auto columns = measured(rows);
  const bool materials = has_materials(rows);
  std::vector<std::vector<std::string>> table(1);
  auto& header = table[0];
  if (materials) header.emplace_back("material");
  const bool distributions = std::ranges::any_of(rows, [](const auto& row) { return !row.label.empty(); });
  header.emplace_back("masking");
  if (distributions) header.emplace_back("distribution");
  for (const auto& info : columns) header.push_back(info.title);
  header.emplace_back("physically based");
  for (const auto& row : rows) {
    std::vector<std::string> line;
    if (materials) line.push_back(row.material);
    line.push_back(row.masking);
    if (distributions) line.push_back(row.label);
    for (const auto& info : columns) line.push_back(format(row.residuals.at(info.property)));
    line.emplace_back(mark(row.physically_based()));
    table.push_back(std::move(line));
  }
  return table;
}

/// A field of a CSV, quoted where it has to be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out.append(c == '"' ? 2 : 1, c);
  return out + "\"";
}

/// Two columns of every property: its largest residual and what follows.
void append_verdicts(std::string& out, const PropertyRow& row, const std::vector<PropertyInfo>& columns) {
  for (const auto& info : columns) {
    const Residual& residual = row.residuals.at(info.property);
    out += ',';
    if (residual.verdict != Verdict::not_applicable && std::isfinite(residual.max_residual))
      append_number(out, residual.max_residual);
    (out += ',').append(word(residual.verdict));
  }
  (out += ',').append(word(row.physically_based()));
}

/// Where the largest of residuals that are rounding stands is chance, and would change from machine to machine.
void append_places(std::string& out, const PropertyRow& row, const std::vector<PropertyInfo>& columns) {
  for (const auto& info : columns) {
    const Residual& residual = row.residuals.at(info.property);
    const bool told = residual.verdict == Verdict::fails || residual.verdict == Verdict::unknown;
    for (const double value : {residual.alpha, residual.theta_o, residual.phi_o}) {
      out += ',';
      if (told) append_number(out, value);
    }
  }
}

/// Whether `a` says more against a masking function than `b`: it fails where that does not, or misses by more.
bool is_worse(const Residual& a, const Residual& b) {
  const auto rank = [](const Residual& residual) {
    switch (residual.verdict) {
    case Verdict::fails: return 3;
    case Verdict::unknown: return 2;
    case Verdict::holds: return 1;
    case Verdict::not_applicable: break;
    }
    return 0;
  };
  return rank(a) != rank(b) ? rank(a) > rank(b) : a.max_residual > b.max_residual;
}

std::string markdown_rows(const std::vector<std::vector<std::string>>& cells) {
  std::string out;
  bool header = true;
  for (const auto& line : cells) {
    for (const auto& cell : line) out += "| " + cell + " ";
    out += "|\n";
    if (header)
      for (std::size_t k = 0; k < line.size(); ++k) out += "| --- ";
    if (header) out += "|\n";
    header = false;
  }
  return out;
}

} // namespace

std::string_view mark(Verdict verdict) {
  switch (verdict) {
  case Verdict::holds: return "✓";
  case Verdict::fails: return "✗";
  case Verdict::unknown: return "?";
  case Verdict::not_applicable: break;
  }
  return "-";
}

std::string short_number(double value) {
  const Short number = shorten(value);
  return number.digits + (number.exponent == 0 ? "" : "e" + std::to_string(number.exponent));
}

std::vector<std::string> untold(const PropertyRow& row) {
  std::vector<std::string> out;
  for (const auto& info : properties()) {
    const auto found = row.residuals.find(info.property);
    if (found == row.residuals.end() || std::isfinite(found->second.max_residual)) continue;
    out.push_back("\"" + info.name + "\": found " + format_number(found->second.max_residual) +
                  ", accepted: a finite residual");
  }
  return out;
}

std::string table_csv(const std::vector<PropertyRow>& rows) {
  const auto columns = measured(rows);
  const bool materials = has_materials(rows);
  std::string out = materials ? "material,distribution,masking" : "distribution,masking";
  for (const auto& info : columns) out += "," + info.name + "_max_residual," + info.name + "_holds";
  out += ",physically_based";
  for (const auto& info : columns) out += "," + info.name + "_alpha," + info.name + "_theta_o," + info.name + "_phi_o";
  out += '\n';
  for (const auto& row : rows) {
    out += (materials ? field(row.material) + "," : "") + field(row.label) + "," + row.masking;
    append_verdicts(out, row, columns);
    append_places(out, row, columns);
    out += '\n';
  }
  return out;
}

std::vector<PropertyRow> by_masking(const std::vector<PropertyRow>& rows) {
  std::vector<PropertyRow> out;
  for (const auto& row : rows) {
    const auto same = [&](const PropertyRow& other) { return other.masking == row.masking; };
    const auto found = std::ranges::find_if(out, same);
    if (found == out.end()) {
      out.push_back(row);
      out.back().label = out.back().distribution = "";
      continue;
    }
    for (const auto& [property, residual] : row.residuals) {
      Residual& worst = found->residuals[property];
      if (is_worse(residual, worst)) worst = residual;
    }
  }
  if (out.size() == rows.size() || has_materials(rows)) return {};
  return out;
}

std::string table_markdown(const std::string& title, const std::string& caption,
                           const std::vector<std::vector<std::string>>& cells) {
  return "# " + plot::strip_markup(title) + "\n\n" + plot::strip_markup(caption) + "\n\n" + markdown_rows(cells);
}
std::string table_markdown(const std::string& title, const std::string& caption, const std::vector<PropertyRow>& rows) {
  const auto summary = by_masking(rows);
  if (summary.empty()) return table_markdown(title, caption, cells(rows, plain));
  return table_markdown(title, caption, cells(summary, plain)) + "\n" + markdown_rows(cells(rows, plain));
}

std::vector<std::vector<std::string>> plain_cells(const std::vector<PropertyRow>& rows) { return cells(rows, plain); }

std::vector<std::vector<std::string>> table_cells(const std::vector<PropertyRow>& rows) {
  std::vector<PropertyRow> named = rows;
  for (auto& row : named)
    for (std::string* name : {&row.material, &row.masking, &row.label}) *name = literal(*name);
  return cells(named, with_markup);
}

} // namespace brdfplot::cli
