#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "draw/svg/plan.hpp"

namespace brdfplot::plot {

namespace {

constexpr int undefined = -1;

/// Renderers that smooth edges show the page between cells that only touch.
constexpr double overlap = 0.5;

using ColourPaths = std::array<PathData, map_colours>;

/// The edges of cells around their centres, as places in [0, 1] of the axis: midway between neighbours.
std::vector<double> cell_edges(const std::vector<double>& centres, const Range& range, Scale scale) {
  std::vector<double> places;
  places.reserve(centres.size());
  for (const double centre : centres) places.push_back(place_in(range, scale, centre));
  const std::size_t n = places.size();
  std::vector<double> edges(n + 1, 0);
  if (n == 1) return {0, 1};
  for (std::size_t i = 1; i < n; ++i) edges[i] = (places[i - 1] + places[i]) / 2;
  if (n > 1) {
    edges[0] = 2 * places[0] - edges[1];
    edges[n] = 2 * places[n - 1] - edges[n - 1];
  }
  for (auto& edge : edges) edge = std::isnan(edge) ? 0 : std::clamp(edge, 0.0, 1.0);
  return edges;
}

int colour_index(const PanelPlan& plan, double value) {
  if (std::isnan(value)) return undefined;
  const auto scale = plan.panel->value ? plan.panel->value->scale : Scale::linear;
  double place = 0;
  if (is_diverging(plan)) {
    place = 0.5 + 0.5 * value / std::max(-plan.value.from, plan.value.to);
  } else if (std::isinf(value)) {
    place = value > 0 ? 1 : 0;
  } else {
    place = place_in(plan.value, scale, value); // NaN where a logarithmic scale has no colour
  }
  if (std::isnan(place)) return 0;
  return std::clamp(static_cast<int>(std::floor(std::clamp(place, 0.0, 1.0) * map_colours)), 0, map_colours - 1);
}

/// Cells of one colour beside each other in a row, which may go on in the rows that follow.
struct CellRun {
  std::size_t from = 0;
  std::size_t to = 0;
  int colour = 0;
  std::size_t first_row = 0;

  [[nodiscard]] bool continues(const CellRun& below) const {
    return from == below.from && to == below.to && colour == below.colour;
  }
};

std::vector<CellRun> runs_of_row(const PanelPlan& plan, std::size_t row) {
  const auto& grid = *plan.panel->grid;
  std::vector<CellRun> runs;
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    const std::size_t at = row * grid.x.size() + i;
    const int colour = at < grid.value.size() ? colour_index(plan, grid.value[at]) : undefined;
    if (!runs.empty() && runs.back().colour == colour) {
      runs.back().to = i + 1;
    } else {
      runs.push_back({i, i + 1, colour, row});
    }
  }
  return runs;
}

class Cells {
public:
  explicit Cells(const PanelPlan& plan)
      : plan_(plan), x_(cell_edges(plan.panel->grid->x, plan.x, plan.panel->x.scale)),
        y_(cell_edges(plan.panel->grid->y, plan.y, plan.panel->y.scale)) {
    std::vector<CellRun> open;
    const std::size_t rows = plan.panel->grid->y.size();
    for (std::size_t row = 0; row < rows; ++row) {
      auto runs = runs_of_row(plan, row);
      for (const auto& run : open) {
        const auto same = std::find_if(runs.begin(), runs.end(), [&](const CellRun& r) { return r.continues(run); });
        if (same != runs.end()) {
          same->first_row = run.first_row;
        } else {
          add(run, row);
        }
      }
      open = std::move(runs);
    }
    for (const auto& run : open) add(run, rows);
  }

  void draw(SvgWriter& svg) const {
    const std::string prefix = is_diverging(plan_) ? "bp-d" : "bp-q";
    svg.open_group("bp-cells");
    for (std::size_t i = 0; i < colours_.size(); ++i) svg.path(colours_[i], {prefix + std::to_string(i), 0, {}, {}});
    svg.path(undefined_, {"bp-nan", 0, {}, {}});
    svg.close_group();
  }

private:
  void add(const CellRun& run, std::size_t end_row) {
    const auto& plot = plan_.plot;
    const double left = plot.x + x_[run.from] * plot.w;
    const double right = plot.x + x_[run.to] * plot.w;
    const double top = plot.bottom() - y_[end_row] * plot.h;
    const double bottom = plot.bottom() - y_[run.first_row] * plot.h;
    if (right - left < 0.005 || bottom - top < 0.005) return;
    auto& path = run.colour == undefined ? undefined_ : colours_[static_cast<std::size_t>(run.colour)];
    const double to_right = std::min(right + overlap, plot.right()),
                 to_bottom = std::min(bottom + overlap, plot.bottom());
    path.rectangle({left, top, to_right - left, to_bottom - top});
  }

  const PanelPlan& plan_;
  std::vector<double> x_;
  std::vector<double> y_;
  ColourPaths colours_;
  PathData undefined_;
};

void draw_contours(SvgWriter& svg, const PanelPlan& plan) {
  PathData region;
  region.rectangle(plan.plot);
  svg.open_clip(plan.id + "-clip", region);
  for (std::size_t i = 0; i < plan.panel->contours.size(); ++i) {
    PathData path;
    for (const auto& line : plan.panel->contours[i].lines) append_curve(path, plan, line.x, line.y);
    const std::string key = key_attribute(plan.looks[i]);
    svg.path(path, {"bp-no bp-line bp-halo", 4, {}, key});
    svg.path(path, {"bp-no bp-line bp-contour", 1.6, dash(plan.looks[i].dash), key});
  }
  svg.close_group();
}

void draw_bar_colours(SvgWriter& svg, const PanelPlan& plan, const Box& bar) {
  const auto scale = plan.panel->value ? plan.panel->value->scale : Scale::linear;
  const std::string prefix = is_diverging(plan) ? "bp-d" : "bp-q";
  svg.open_group("bp-cells");
  for (int k = 0; k < map_colours; ++k) {
    const double place = (k + 0.5) / map_colours;
    const double value = scale == Scale::logarithmic
                             ? plan.value.from * std::pow(plan.value.to / plan.value.from, place)
                             : std::lerp(plan.value.from, plan.value.to, place);
    PathData strip;
    const double top = std::max(bar.bottom() - bar.h * (k + 1) / map_colours - overlap, bar.y);
    strip.rectangle({bar.x, top, bar.w, bar.bottom() - bar.h * k / map_colours - top});
    svg.path(strip, {prefix + std::to_string(colour_index(plan, value)), 0, {}, {}});
  }
  svg.close_group();
}

void draw_bar(SvgWriter& svg, const PanelPlan& plan) {
  constexpr double gap = 10;
  constexpr double width = 14;
  constexpr double tick = 5;
  const Box bar{plan.plot.right() + gap, plan.plot.y, width, plan.plot.h};
  draw_bar_colours(svg, plan, bar);
  const auto scale = plan.panel->value ? plan.panel->value->scale : Scale::linear;
  const auto height = [&](double value) { return bar.bottom() - bar.h * place_in(plan.value, scale, value); };
  PathData marks;
  marks.rectangle(bar);
  double labels = 0;
  for (const auto& major : plan.value_ticks.major) {
    const double y = height(major.value);
    marks.move({bar.right(), y});
    marks.line({bar.right() + tick, y});
    svg.text({bar.right() + tick + 4, y + 0.35 * font::tick}, major.label, font::tick, Anchor::start);
    labels = std::max(labels, text_width(major.label, font::tick));
  }
  for (const double minor : plan.value_ticks.minor) {
    marks.move({bar.right(), height(minor)});
    marks.line({bar.right() + tick / 2, height(minor)});
  }
  svg.path(marks, {"bp-no bp-frame", 1, {}, {}});
  const double x = bar.right() + tick + 4 + labels + 6 + plan.value_title.height() / 2;
  svg.upward({x, bar.y + bar.h / 2}, plan.value_title);
}

} // namespace

bool is_diverging(const PanelPlan& plan) {
  const bool linear = !plan.panel->value || plan.panel->value->scale == Scale::linear;
  return linear && plan.value.from < 0 && plan.value.to > 0;
}

void draw_heatmap(SvgWriter& svg, const PanelPlan& plan) {
  if (plan.panel->grid && !plan.panel->grid->x.empty() && !plan.panel->grid->y.empty()) Cells(plan).draw(svg);
  draw_contours(svg, plan);
  draw_axes(svg, plan);
  if (plan.bar) draw_bar(svg, plan);
}

} // namespace brdfplot::plot
