#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/threads/interrupt.hpp"
#include "draw/svg/plan.hpp"

namespace brdfplot::plot {

namespace {

/// The part of a segment that lies in a box (Liang and Barsky), or nothing.
std::optional<std::pair<Point, Point>> clip_segment(Point a, Point b, const Box& box) {
  double enter = 0;
  double leave = 1;
  const auto cut = [&](double start, double delta, double low, double high) {
    if (delta == 0) return start >= low && start <= high;
    const double t0 = (low - start) / delta;
    const double t1 = (high - start) / delta;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
    return enter <= leave;
  };
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  if (!cut(a.x, dx, box.x, box.right()) || !cut(a.y, dy, box.y, box.bottom())) return std::nullopt;
  const Point from = enter > 0 ? Point{a.x + enter * dx, a.y + enter * dy} : a;
  const Point to = leave < 1 ? Point{a.x + leave * dx, a.y + leave * dy} : b;
  return std::pair{from, to};
}

/// Appends what a box shows of a polyline without gaps.
void append_clipped(PathData& path, const std::vector<Point>& points, const Box& box) {
  constexpr double dot_radius = 1.6;
  if (points.size() == 1) {
    const auto p = points.front();
    if (p.x >= box.x && p.x <= box.right() && p.y >= box.y && p.y <= box.bottom()) path.dot(p, dot_radius);
    return;
  }
  std::vector<Point> piece;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto part = clip_segment(points[i - 1], points[i], box);
    if (!part) continue;
    const auto [from, to] = *part;
    const bool joins = !piece.empty() && piece.back().x == from.x && piece.back().y == from.y;
    if (!joins) {
      append_polyline(path, piece);
      piece = {from};
    }
    piece.push_back(to);
  }
  append_polyline(path, piece);
}

} // namespace

void append_curve(PathData& path, const PanelPlan& plan, const std::vector<double>& x, const std::vector<double>& y) {
  // A little wider than the plotting area, so that no line end shows at its edge.
  constexpr double extra = 4;
  const Box box{plan.plot.x - extra, plan.plot.y - extra, plan.plot.w + 2 * extra, plan.plot.h + 2 * extra};
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    const auto point = to_point(plan, x[i], y[i]);
    if (std::isnan(point.x) || std::isnan(point.y)) {
      if (!points.empty()) append_clipped(path, points, box);
      points.clear();
    } else {
      points.push_back(point);
    }
  }
  if (!points.empty()) append_clipped(path, points, box);
}

std::vector<double> upper_bounds(const Series& series) {
  std::vector<double> out = series.y;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] += 2 * series.error[k];
  return out;
}

std::vector<double> lower_bounds(const Series& series) {
  std::vector<double> out = series.y;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] -= 2 * series.error[k];
  return out;
}

namespace {

/// Dots with bars of two standard errors.
void draw_measured(SvgWriter& svg, const PanelPlan& plan, const Series& series, const Look& look) {
  const auto upper = upper_bounds(series), lower = lower_bounds(series);
  PathData bars, dots;
  for (std::size_t k = 0; k < series.y.size(); ++k) {
    const Point middle = to_point(plan, series.x[k], series.y[k]);
    if (std::isnan(middle.x) || std::isnan(middle.y)) continue;
    dots.dot(middle, measured_radius);
    const double top = to_point(plan, series.x[k], upper[k]).y;
    double bottom = to_point(plan, series.x[k], lower[k]).y;
    if (std::isnan(bottom)) bottom = plan.plot.bottom() + 2 * measured_radius; // below zero on a logarithmic axis
    if (std::isnan(top) || bottom - top < 2 * measured_radius) continue;
    append_error_bar(bars, middle.x, top, bottom);
  }
  svg.path(bars, {"bp-no bp-" + look.colour, 1.2, {}, key_attribute(look)});
  svg.path(dots, {"bp-f-" + look.colour, 0, {}, key_attribute(look)});
}

} // namespace

void draw_lines(SvgWriter& svg, const PanelPlan& plan) {
  draw_grid(svg, plan);
  PathData region;
  region.rectangle({plan.plot.x - 1, plan.plot.y - 1, plan.plot.w + 2, plan.plot.h + 2});
  svg.open_clip(plan.id + "-clip", region);
  bool empty = true;
  for (std::size_t i = 0; i < plan.panel->series.size(); ++i) {
    throw_if_interrupted();
    const auto& series = plan.panel->series[i];
    if (!series.names.empty()) {
      empty = false;
      continue;
    }
    PathData path;
    append_curve(path, plan, series.x, series.y);
    empty = empty && path.empty();
    const bool measured = !series.error.empty();
    const Look& look = plan.looks[i];
    svg.path(path,
             {"bp-no bp-line bp-" + look.colour, measured ? measured_line : 2.0, dash(look.dash), key_attribute(look)});
    if (measured) draw_measured(svg, plan, series, look);
  }
  draw_named_points(svg, plan);
  svg.close_group();
  if (empty) {
    const Point middle{plan.plot.x + plan.plot.w / 2, plan.plot.y + plan.plot.h / 2};
    svg.text(middle, "no values to show", font::axis, Anchor::middle, "bp-muted");
  }
  draw_axes(svg, plan);
}

} // namespace brdfplot::plot
