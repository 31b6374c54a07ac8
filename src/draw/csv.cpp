#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/number.hpp"
#include "base/threads/interrupt.hpp"
#include "draw/model.hpp"
#include "draw/text.hpp"

namespace brdfplot::plot {

namespace {

/// Appends a text field, quoted when a reader would otherwise split it (RFC 4180).
void append_field(std::string& out, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

std::string field(std::string_view label) {
  std::string out;
  append_field(out, strip_markup(label));
  return out;
}

/// Whether all panels are heat maps, which have no series.
bool is_heatmap(const Figure& figure) {
  const auto one = [&](const Panel& panel) { return kind_in(figure, panel) == Kind::heatmap; };
  return figure.panels.empty() ? figure.kind == Kind::heatmap : std::ranges::all_of(figure.panels, one);
}

bool has_errors(const Figure& figure) {
  const auto simulated = [](const Series& series) { return !series.error.empty(); };
  return std::ranges::any_of(figure.panels, [&](const Panel& panel) {
    const Kind kind = kind_in(figure, panel);
    if (kind == Kind::profile || kind == Kind::spheres) return false;
    return !panel.notes.empty() || std::ranges::any_of(panel.series, simulated);
  });
}

bool has_names(const Figure& figure) {
  return std::ranges::any_of(figure.panels, [](const Panel& panel) {
    return std::ranges::any_of(panel.series, [](const Series& series) { return !series.names.empty(); });
  });
}

std::string column_of(const Axis& axis, const char* fallback) { return axis.column.empty() ? fallback : axis.column; }

/// The columns of what is swept: panels may sweep different variables, and a row has those of its own.
std::vector<std::string> swept_columns(const Figure& figure) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const Panel& panel : figure.panels) {
    add(column_of(panel.x, "x"));
    if (kind_in(figure, panel) == Kind::heatmap) add(column_of(panel.y, "y"));
  }
  if (names.empty()) names = is_heatmap(figure) ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"x"};
  return names;
}

/// The name of the values: that of all panels, or where they differ "value".
std::string value_column(const Figure& figure) {
  std::string name;
  for (const Panel& panel : figure.panels) {
    const bool heatmap = kind_in(figure, panel) == Kind::heatmap;
    const std::string own =
        heatmap ? (panel.value ? column_of(*panel.value, "value") : "value") : column_of(panel.y, "y");
    if (!name.empty() && name != own) return "value";
    name = own;
  }
  return name.empty() ? (is_heatmap(figure) ? "value" : "y") : name;
}

void append_header(std::string& out, const Figure& figure, const std::vector<std::string>& swept) {
  out += is_heatmap(figure) ? "panel" : "panel,series";
  const auto column = [&](const std::string& name) {
    out += ',';
    append_field(out, name);
  };
  for (const std::string& name : swept) column(name);
  column(value_column(figure));
  if (has_errors(figure)) column(value_column(figure) + "_stderr");
  if (has_names(figure)) column("name");
  out += '\n';
}

/// The cells of what is swept, each followed by a comma.
void append_swept(std::string& out, const std::vector<std::string>& swept, const std::string& name, double value) {
  for (const std::string& column : swept) {
    if (column == name) append_number(out, value);
    out += ',';
  }
}

void append_series(std::string& out, const Panel& panel, const std::vector<std::string>& swept, bool errors,
                   bool names) {
  const std::string x = column_of(panel.x, "x");
  const bool profile = panel.sketch.has_value();
  const auto title = field(panel.title);
  for (const auto& series : panel.series) {
    throw_if_interrupted();
    const auto start = title + "," + field(series.label) + ",";
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      out += start;
      append_swept(out, swept, x, series.x[i]);
      if (!profile || !std::isnan(series.y[i])) append_number(out, series.y[i]);
      if (errors) out += ',';
      if (i < series.error.size()) append_number(out, series.error[i]);
      if (names) out += ',';
      if (i < series.names.size()) append_field(out, strip_markup(series.names[i]));
      out += '\n';
    }
  }
}

void append_notes(std::string& out, const Panel& panel, const std::vector<std::string>& swept, bool errors,
                  bool names) {
  for (const Note& note : panel.notes) {
    out += field(panel.title) + "," + field(note.label) + "," + std::string(swept.size(), ',');
    append_number(out, note.value);
    if (errors) out += ',';
    if (errors) append_number(out, note.error);
    if (names) out += ',';
    out += '\n';
  }
}

/// `series`, `errors`, `names`: which columns of other kinds there are, which a heat map leaves empty.
void append_grid(std::string& out, const Panel& panel, const std::vector<std::string>& swept, bool series, bool errors,
                 bool names) {
  throw_if_interrupted();
  const Grid& grid = *panel.grid;
  const std::string title = field(panel.title), x = column_of(panel.x, "x"), y = column_of(panel.y, "y");
  const std::size_t width = grid.x.size();
  for (std::size_t i = 0; i < std::min(grid.value.size(), width * grid.y.size()); ++i) {
    out += title;
    out += series ? ",," : ",";
    for (const std::string& column : swept) {
      if (column == x) append_number(out, grid.x[i % width]);
      if (column == y) append_number(out, grid.y[i / width]);
      out += ',';
    }
    append_number(out, grid.value[i]);
    if (errors) out += ',';
    if (names) out += ',';
    out += '\n';
  }
}

/// About how long the text will be, so that it is built without copies.
std::size_t estimate(const Figure& figure) {
  std::size_t rows = 1;
  for (const auto& panel : figure.panels) {
    for (const auto& series : panel.series) rows += series.x.size();
    if (panel.grid) rows += panel.grid->value.size();
  }
  return 64 * rows;
}

} // namespace

std::string to_csv(const Figure& figure) {
  std::string out;
  out.reserve(estimate(figure));
  const std::vector<std::string> swept = swept_columns(figure);
  append_header(out, figure, swept);
  const bool errors = has_errors(figure), names = has_names(figure);
  for (const auto& panel : figure.panels) {
    if (kind_in(figure, panel) != Kind::heatmap) {
      append_series(out, panel, swept, errors, names);
      append_notes(out, panel, swept, errors, names);
    } else if (panel.grid) {
      append_grid(out, panel, swept, !is_heatmap(figure), errors, names);
    }
  }
  return out;
}

} // namespace brdfplot::plot
