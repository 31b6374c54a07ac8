#include "draw/svg/plan.hpp"

#include "base/threads/interrupt.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>

namespace brdfplot::plot {

namespace {

constexpr double row_gap = 14;

/// An id that is valid in XML, CSS and URLs.
std::string clean_id(const std::string& id) {
  std::string out;
  for (const char c : id) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (out.empty() && !letter) out = "f-";
    out += letter || (c >= '0' && c <= '9') || c == '-' || c == '_' ? c : '-';
  }
  return out.empty() ? "figure" : out;
}

/// The width of a page in user units, of which font::tick are as many points as the layout says.
double page_width(const Layout& layout, int columns) {
  constexpr double millimetres_per_point = 25.4 / 72;
  if (layout.width_mm > 0) return layout.width_mm / (layout.font_pt * millimetres_per_point / font::tick);
  return columns == 1 ? 640 : 720;
}

/// How many of the columns find room side by side: all, or so many that a row of the figure fills several whole rows.
int columns_in(Kind kind, double width, int columns) {
  const int row = columns;
  constexpr std::array<double, panel_kinds.size()> least = {165, 150, 190, 150, 90}; // in the order of Kind
  const double each = least[static_cast<std::size_t>(kind)] + column_gap;
  const int room = static_cast<int>((width - 2 * page_margin + column_gap) / each);
  while (columns > 1 && (columns > room || row % columns != 0)) --columns;
  return columns;
}

/// The data on the axis that panels may share.
Extent value_extent(const Panel& panel, Kind kind) {
  Extent extent;
  if (kind == Kind::heatmap) {
    if (panel.grid) extent.add(panel.grid->value, panel.value ? panel.value->scale : Scale::linear);
    return extent;
  }
  for (const auto& series : panel.series) {
    extent.add(series.y, panel.y.scale);
    if (series.error.empty() || kind != Kind::lines) continue;
    extent.add(upper_bounds(series), panel.y.scale);
    extent.add(lower_bounds(series), panel.y.scale);
  }
  return extent;
}

void plan_swept(PanelPlan& plan) {
  const Panel& panel = *plan.panel;
  const Kind kind = plan.kind;
  Extent x;
  for (const auto& series : panel.series) x.add(series.x, panel.x.scale);
  if (kind == Kind::heatmap && panel.grid) {
    Extent y;
    x.add(panel.grid->x, panel.x.scale);
    y.add(panel.grid->y, panel.y.scale);
    plan.y = swept_range(panel.y, y);
  } else if (kind == Kind::heatmap) {
    plan.y = swept_range(panel.y, {});
  }
  plan.x = swept_range(panel.x, x);
}

double title_height(const PanelPlan& panel) {
  const double title = panel.title.lines.empty() ? 0 : panel.title.height() + 4;
  return title + (panel.note.lines.empty() ? 0 : panel.note.height() + 2);
}

/// "distance 3 %, mean +1°"
std::string notes_line(const Panel& panel) {
  std::string line;
  for (const Note& note : panel.notes) line += (line.empty() ? "" : ", ") + note.text;
  return line;
}

/// The width for all panels of a row, without the gaps between them.
double row_width(const FigurePlan& plan) { return plan.width - 2 * page_margin - (plan.columns - 1) * column_gap; }

double cell_width(const FigurePlan& plan) { return row_width(plan) / plan.columns; }

/// The room that the panels of each column take.
struct Columns {
  struct Column {
    double left = 0, width = 0, right = 0;
  };
  std::vector<Column> all;
  double cell = 0; ///< the same for all
};

/// Aligns the titles, legends and plots of a row that begins at `y`; gives its height.
double place_row(std::span<PanelPlan> row, double y) {
  double title = 0;
  double legend = 0;
  double top = 0;
  double body = 0;
  for (const auto& panel : row) {
    title = std::max(title, title_height(panel));
    legend = std::max(legend, panel.legend.height);
    top = std::max(top, panel.insets.top);
    body = std::max(body, panel.plot.h + panel.insets.bottom);
  }
  for (auto& panel : row) {
    panel.title_top = y + title - title_height(panel);
    panel.legend_top = y + title;
    panel.plot.y = y + title + legend + top;
  }
  return title + legend + top + body;
}

/// Sets where the plots of a row begin. Those of all rows stand below each other; panels of several kinds each stand
/// in the middle of a cell.
void place_across(const FigurePlan& plan, std::span<PanelPlan> row, const Columns& columns) {
  double x = page_margin;
  for (std::size_t column = 0; column < row.size(); ++column) {
    PanelPlan& panel = row[column];
    const Columns::Column& room = columns.all[column];
    const double used = panel.insets.left + panel.plot.w + panel.insets.right;
    panel.plot.x = x + (plan.mixed ? (columns.cell - used) / 2 + panel.insets.left : room.left);
    x += (plan.mixed ? columns.cell : room.left + room.width + room.right) + column_gap;
  }
}

/// Moves the panels to their places in the grid; gives the y below the last row.
double place_panels(FigurePlan& plan, double top) {
  const auto columns = static_cast<std::size_t>(plan.columns);
  const auto& panels = plan.panels;
  Columns room{std::vector<Columns::Column>(columns), cell_width(plan)};
  for (std::size_t i = 0; i < panels.size(); ++i) {
    Columns::Column& column = room.all[i % columns];
    column.left = std::max(column.left, panels[i].insets.left);
    column.right = std::max(column.right, panels[i].insets.right);
    column.width = std::max(column.width, panels[i].plot.w);
  }
  double y = top;
  for (std::size_t row = 0; row < panels.size(); row += columns) {
    const auto in_row = std::span(plan.panels).subspan(row, std::min(columns, panels.size() - row));
    const double body = place_row(in_row, y);
    place_across(plan, in_row, room);
    y += body + row_gap;
  }
  return panels.empty() ? top : y - row_gap;
}

} // namespace

void set_lines_range(PanelPlan& panel, const Extent& data, int) { panel.y = value_range(panel.panel->y, data); }

void set_polar_range(PanelPlan& panel, const Extent& data, int columns) {
  panel.y = radius_range(panel.panel->y, data, columns > 3 ? 5 : 8);
}

void set_heatmap_range(PanelPlan& panel, const Extent& data, int) {
  panel.value = colour_range(panel.panel->value.value_or(Axis{}), data);
}

void set_no_range(PanelPlan&, const Extent&, int) {}

void plan_ranges(const Figure& figure, FigurePlan& plan) {
  std::map<std::pair<std::size_t, Kind>, Extent> groups;
  const auto group = [&](std::size_t i) -> Extent& { return groups[{share_group(figure, i), plan.panels[i].kind}]; };
  for (std::size_t i = 0; i < plan.panels.size(); ++i)
    group(i).add(value_extent(figure.panels[i], plan.panels[i].kind));
  for (std::size_t i = 0; i < plan.panels.size(); ++i) {
    plan_swept(plan.panels[i]);
    kind_of(plan.panels[i].kind).set_range(plan.panels[i], group(i), plan.columns);
  }
}

bool repeated_below(const FigurePlan& plan, std::size_t index, Axis Panel::*axis) {
  const std::size_t below = index + static_cast<std::size_t>(plan.columns);
  if (below >= plan.panels.size()) return false;
  const PanelPlan &panel = plan.panels[index], &other = plan.panels[below];
  return panel.kind == other.kind && (panel.panel->*axis).label == (other.panel->*axis).label;
}

namespace {

/// Measures the panels, those that are measured alike together.
void measure_panels(const Figure& figure, FigurePlan& plan) {
  const auto measure_of = [](const PanelPlan& panel) { return kind_of(panel.kind).measure; };
  std::vector<decltype(PanelKind::measure)> ways;
  for (const PanelPlan& panel : plan.panels)
    if (std::ranges::find(ways, measure_of(panel)) == ways.end()) ways.push_back(measure_of(panel));
  plan.mixed = ways.size() > 1;
  for (const auto measure : ways) measure(figure, plan, row_width(plan));
}

/// As many as the kind that needs most room has.
int columns_of(const Figure& figure, double width, int columns) {
  int fewest = columns;
  for (const Panel& panel : figure.panels)
    fewest = std::min(fewest, columns_in(kind_in(figure, panel), width, columns));
  return fewest;
}

} // namespace

std::size_t share_group(const Figure& figure, std::size_t panel) {
  if (figure.share == Share::all) return 0;
  return figure.share == Share::rows ? panel / static_cast<std::size_t>(std::max(1, figure.columns)) : panel;
}

FigurePlan plan_figure(const Figure& figure, const Layout& layout) {
  FigurePlan plan;
  plan.id = clean_id(figure.id);
  plan.columns = std::clamp(figure.columns, 1, std::max(1, static_cast<int>(figure.panels.size())));
  plan.width = page_width(layout, plan.columns);
  if (layout.width_mm > 0) plan.columns = columns_of(figure, plan.width, plan.columns);
  plan.shrink = std::min(1.0, plan.width / page_width({}, plan.columns));
  const double width = plan.width - 2 * page_margin;
  if (layout.title) plan.title = fit_text(figure.title, font::title, width, 2, true);
  const auto legend = plan_legend(figure);
  plan.legend = lay_out_legend(legend.shared, width);

  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    auto& panel = plan.panels.emplace_back();
    panel.panel = &figure.panels[i];
    panel.kind = kind_in(figure, figure.panels[i]);
    panel.id = plan.id + "-p" + std::to_string(i + 1);
    panel.looks = legend.looks[i];
  }
  plan_ranges(figure, plan);
  measure_panels(figure, plan);
  for (std::size_t i = 0; i < plan.panels.size(); ++i) {
    throw_if_interrupted();
    auto& panel = plan.panels[i];
    const double room = panel.plot.w + panel.insets.left + panel.insets.right - 8;
    panel.title = fit_text(panel.panel->title, font::panel_title, room, 2, true);
    panel.note = fit_text(notes_line(*panel.panel), font::tick, room, 2);
    panel.legend = lay_out_legend(legend.own[i], room);
  }
  double y = page_margin + (plan.title.lines.empty() ? 0 : plan.title.height() + 6);
  plan.legend_top = y;
  y += plan.legend.placed.empty() ? 0 : plan.legend.height + 8;
  plan.height = std::ceil(place_panels(plan, y) + page_margin);
  return plan;
}

} // namespace brdfplot::plot
