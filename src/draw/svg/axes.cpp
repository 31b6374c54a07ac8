#include <algorithm>
#include <cmath>
#include <cstddef>

#include "draw/svg/plan.hpp"

namespace brdfplot::plot {

namespace {

constexpr double tick_length = 5;
constexpr double label_gap = 4;
constexpr double bar_width = 14;
constexpr double bar_gap = 10;

double plot_height(Kind kind, int columns, std::size_t panels) {
  const auto column = static_cast<std::size_t>(std::clamp(columns, 1, 4) - 1);
  constexpr std::array<double, 4> lines = {320, 215, 180, 150};
  constexpr std::array<double, 4> heatmap = {400, 225, 165, 140};
  if (kind == Kind::heatmap) return heatmap[column];
  return columns == 1 && panels > 1 ? 230 : lines[column];
}

double widest_label(const Ticks& ticks) {
  double widest = 0;
  for (const auto& tick : ticks.major) widest = std::max(widest, text_width(tick.label, font::tick));
  return widest;
}

/// Whether the labels of a horizontal axis of this width keep clear of each other.
bool labels_clear(const Ticks& ticks, const Range& range, Scale scale, double width) {
  constexpr double space = 9;
  for (std::size_t i = 1; i < ticks.major.size(); ++i) {
    const auto& a = ticks.major[i - 1];
    const auto& b = ticks.major[i];
    const double apart = std::abs(place_in(range, scale, b.value) - place_in(range, scale, a.value)) * width;
    if (apart < (text_width(a.label, font::tick) + text_width(b.label, font::tick)) / 2 + space) return false;
  }
  return true;
}

/// As many ticks as the width has room for.
Ticks horizontal_ticks(const Axis& axis, const Range& range, double width) {
  int most = std::clamp(static_cast<int>(width / 30), 3, 10);
  auto ticks = make_ticks(axis, range, most);
  while (most > 2 && !labels_clear(ticks, range, axis.scale, width)) ticks = make_ticks(axis, range, --most);
  return ticks;
}

Ticks vertical_ticks(const Axis& axis, const Range& range, double height) {
  return make_ticks(axis, range, std::clamp(static_cast<int>(height / 32), 3, 10));
}

/// The bar stands beside each panel, or once beside those of a row that share their range.
bool needs_bar(const Figure& figure, const FigurePlan& plan, std::size_t index) {
  if (plan.panels[index].kind != Kind::heatmap) return false;
  const auto per_row = static_cast<std::size_t>(plan.columns);
  const bool last_in_row = index % per_row == per_row - 1 || index + 1 == plan.panels.size();
  return last_in_row || plan.panels[index + 1].kind != Kind::heatmap ||
         share_group(figure, index) != share_group(figure, index + 1);
}

/// Names of points need room below each other.
bool has_names(const Panel& panel) {
  return std::ranges::any_of(panel.series, [](const Series& series) { return !series.names.empty(); });
}

void measure_heights(const Figure& figure, FigurePlan& all, std::size_t index) {
  constexpr double height_for_names = 440, least_height = 110;
  const int columns = all.columns;
  PanelPlan& plan = all.panels[index];
  const auto& panel = *plan.panel;
  const double usual =
      has_names(panel) && columns == 1 ? height_for_names : plot_height(plan.kind, columns, all.panels.size());
  const double height = std::max(all.shrink * usual, least_height);
  plan.plot.h = height;
  plan.y_ticks = vertical_ticks(panel.y, plan.y, height);
  const bool first = index % static_cast<std::size_t>(columns) == 0;
  if (first || all.panels[index - 1].kind != plan.kind || all.panels[index - 1].panel->y.label != panel.y.label) {
    plan.y_title = fit_text(panel.y.label, font::axis, height + 20, 1);
  }
  plan.insets.left = widest_label(plan.y_ticks) + tick_length + label_gap + 2;
  plan.insets.left += plan.y_title.lines.empty() ? 0 : plan.y_title.height() + 4;
  plan.insets.right = 12;
  plan.insets.top = 8;
  plan.bar = needs_bar(figure, all, index);
  if (!plan.bar) return;
  const Axis value = panel.value.value_or(Axis{});
  plan.value_ticks = vertical_ticks(value, plan.value, height);
  plan.value_title = fit_text(value.label, font::axis, height + 20, 1);
  plan.insets.right = bar_gap + bar_width + tick_length + label_gap + widest_label(plan.value_ticks);
  plan.insets.right += plan.value_title.lines.empty() ? 0 : plan.value_title.height() + 6;
}

void measure_width(FigurePlan& all, std::size_t index, double width) {
  PanelPlan& plan = all.panels[index];
  const auto& panel = *plan.panel;
  plan.plot.w = width;
  plan.x_ticks = horizontal_ticks(panel.x, plan.x, width);
  if (!repeated_below(all, index, &Panel::x)) plan.x_title = fit_text(panel.x.label, font::axis, width + 16, 1);
  plan.insets.bottom = tick_length + label_gap + 1.1 * font::tick;
  plan.insets.bottom += plan.x_title.lines.empty() ? 0 : plan.x_title.height() + 6;
}

void draw_tick_marks(SvgWriter& svg, const PanelPlan& plan) {
  PathData marks;
  const auto vertical = [&](double x, double length) {
    const double at = to_point(plan, x, plan.y.from).x;
    marks.move({at, plan.plot.bottom()});
    marks.line({at, plan.plot.bottom() + length});
  };
  const auto horizontal = [&](double y, double length) {
    const double at = to_point(plan, plan.x.from, y).y;
    marks.move({plan.plot.x - length, at});
    marks.line({plan.plot.x, at});
  };
  for (const auto& tick : plan.x_ticks.major) vertical(tick.value, tick_length);
  for (const double tick : plan.x_ticks.minor) vertical(tick, tick_length / 2);
  for (const auto& tick : plan.y_ticks.major) horizontal(tick.value, tick_length);
  for (const double tick : plan.y_ticks.minor) horizontal(tick, tick_length / 2);
  PathData frame;
  frame.rectangle(plan.plot);
  svg.path(frame, {"bp-no bp-frame", 1, {}, {}});
  svg.path(marks, {"bp-no bp-frame", 1, {}, {}});
}

} // namespace

void measure_cartesian(const Figure& figure, FigurePlan& plan, double width) {
  const auto columns = static_cast<std::size_t>(plan.columns);
  std::vector<double> left(columns, 0);
  std::vector<double> right(columns, 0);
  const auto has_axes = [&](std::size_t i) { return kind_of(plan.panels[i].kind).measure == measure_cartesian; };
  for (std::size_t i = 0; i < plan.panels.size(); ++i) {
    if (!has_axes(i)) continue;
    measure_heights(figure, plan, i);
    left[i % columns] = std::max(left[i % columns], plan.panels[i].insets.left);
    right[i % columns] = std::max(right[i % columns], plan.panels[i].insets.right);
  }
  double around_all = 0, around_most = 0;
  for (std::size_t c = 0; c < columns; ++c) {
    around_all += left[c] + right[c];
    around_most = std::max(around_most, left[c] + right[c]);
  }
  const double rest = plan.mixed ? width / plan.columns - around_most : (width - around_all) / plan.columns;
  const double each = std::max(rest, 40.0);
  for (std::size_t i = 0; i < plan.panels.size(); ++i) {
    if (!has_axes(i)) continue;
    plan.panels[i].insets.left = left[i % columns];
    plan.panels[i].insets.right = right[i % columns];
    measure_width(plan, i, each);
  }
}

Point to_point(const PanelPlan& plan, double x, double y) {
  constexpr double far = 1e6; // keeps the arithmetic of clipping finite
  const double px = std::clamp(place_in(plan.x, plan.panel->x.scale, x), -far, far);
  const double py = std::clamp(place_in(plan.y, plan.panel->y.scale, y), -far, far);
  return {plan.plot.x + px * plan.plot.w, plan.plot.bottom() - py * plan.plot.h};
}

void draw_grid(SvgWriter& svg, const PanelPlan& plan) {
  PathData grid;
  for (const auto& tick : plan.x_ticks.major) {
    const double x = to_point(plan, tick.value, plan.y.from).x;
    grid.move({x, plan.plot.y});
    grid.line({x, plan.plot.bottom()});
  }
  for (const auto& tick : plan.y_ticks.major) {
    const double y = to_point(plan, plan.x.from, tick.value).y;
    grid.move({plan.plot.x, y});
    grid.line({plan.plot.right(), y});
  }
  svg.path(grid, {"bp-no bp-grid", 1, {}, {}});
}

void draw_axes(SvgWriter& svg, const PanelPlan& plan) {
  draw_tick_marks(svg, plan);
  const double below = plan.plot.bottom() + tick_length + label_gap;
  for (const auto& tick : plan.x_ticks.major) {
    const double x = to_point(plan, tick.value, plan.y.from).x;
    svg.text({x, below + 0.85 * font::tick}, tick.label, font::tick, Anchor::middle);
  }
  for (const auto& tick : plan.y_ticks.major) {
    const double y = to_point(plan, plan.x.from, tick.value).y;
    const double x = plan.plot.x - tick_length - label_gap;
    svg.text({x, y + 0.35 * font::tick}, tick.label, font::tick, Anchor::end);
  }
  svg.lines({plan.plot.x + plan.plot.w / 2, below + 1.1 * font::tick + 5}, plan.x_title, Anchor::middle);
  const double left = plan.plot.x - plan.insets.left + plan.y_title.height() / 2;
  svg.upward({left, plan.plot.y + plan.plot.h / 2}, plan.y_title);
}

} // namespace brdfplot::plot
