#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/threads/interrupt.hpp"
#include "draw/svg/polar.hpp"

namespace brdfplot::plot {

using polar::pi;
using polar::tip;

namespace {

/// The disc of a polar plot on the page.
struct Disc {
  Point centre;
  double radius = 0;
  bool full = false;

  /// The point at a signed angle from the normal: up is 0, positive angles are to the right.
  [[nodiscard]] Point at(double theta, double r) const {
    return {centre.x + r * std::sin(theta), centre.y - r * std::cos(theta)};
  }
};

Disc disc_of(const PanelPlan& plan) {
  const bool full = polar::is_full_disc(*plan.panel);
  const double radius = plan.plot.w / 2;
  return {{plan.plot.x + radius, plan.plot.y + radius}, radius, full};
}

void draw_rings(SvgWriter& svg, const PanelPlan& plan, const Disc& disc) {
  PathData grid;
  const auto ring = [&](PathData& path, double r) {
    const double end = disc.full ? pi : pi / 2;
    path.move(disc.at(-end, r));
    path.arc(r, false, true, disc.at(0, r));
    path.arc(r, false, true, disc.at(end, r));
  };
  for (const auto& tick : plan.y_ticks.major) {
    const double r = disc.radius * place_in(plan.y, plan.panel->y.scale, tick.value);
    if (r > 0.5 && r < disc.radius - 0.5) ring(grid, r);
  }
  // The labelled spokes are 30 degrees apart, 45 where the plot is narrow; others lie between where they do not crowd.
  const int between = disc.radius >= 100 ? 2 : 1;
  const double step = (plan.narrow ? pi / 4 : pi / 6) / between;
  const int last = static_cast<int>(std::floor((disc.full ? pi : pi / 2 - 0.01) / step + 1e-9));
  for (int k = -last; k <= last; ++k) {
    grid.move(disc.at(k * step, k % between == 0 ? 0 : disc.radius * 0.25));
    grid.line(disc.at(k * step, disc.radius));
  }
  svg.path(grid, {"bp-no bp-grid", 1, {}, {}});
  PathData outer;
  ring(outer, disc.radius);
  svg.path(outer, {"bp-no bp-frame", 1, {}, {}});
}

/// The band of two standard errors about a simulated lobe.
void draw_band(SvgWriter& svg, const PanelPlan& plan, const Disc& disc, const Series& series, const Look& look) {
  PathData band;
  std::vector<Point> points;
  const auto radius = [&](double value) {
    const double place = place_in(plan.y, plan.panel->y.scale, value);
    return disc.radius * (std::isnan(place) ? 0 : std::clamp(place, 0.0, 2.0));
  };
  const auto upper = upper_bounds(series), lower = lower_bounds(series);
  for (std::size_t k = 0; k < series.x.size(); ++k) points.push_back(disc.at(series.x[k], radius(upper[k])));
  for (std::size_t k = series.x.size(); k-- > 0;)
    points.push_back(disc.at(series.x[k], radius(std::max(lower[k], 0.0))));
  append_polyline(band, points);
  band.close();
  svg.path(band, {"bp-f-" + look.colour, 0, {}, " fill-opacity=\"0.35\"" + key_attribute(look)});
}

void draw_lobes(SvgWriter& svg, const PanelPlan& plan, const Disc& disc) {
  const auto& panel = *plan.panel;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    throw_if_interrupted();
    const auto& series = panel.series[i];
    PathData path;
    std::vector<Point> points;
    const auto flush = [&] {
      append_polyline(path, points);
      points.clear();
    };
    for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k) {
      const bool nothing = panel.y.scale == Scale::logarithmic && series.y[k] <= 0;
      const double place = nothing ? 0 : place_in(plan.y, panel.y.scale, series.y[k]);
      if (std::isnan(place) || !std::isfinite(series.x[k])) {
        flush();
      } else {
        points.push_back(disc.at(series.x[k], disc.radius * std::clamp(place, 0.0, 2.0)));
      }
    }
    flush();
    const auto& look = plan.looks[i];
    if (!series.error.empty()) draw_band(svg, plan, disc, series, look);
    svg.path(path, {"bp-line bp-" + look.colour + " bp-f-" + look.colour, 2, dash(look.dash),
                    " fill-opacity=\"0.07\"" + key_attribute(look)});
  }
}

/// An arrow along a direction. Its head is at the outer end, or, when the light comes in, halfway: at the surface point
/// the heads of several arrows would cover each other and the lobes.
void draw_arrow(SvgWriter& svg, const Disc& disc, const Arrow& arrow) {
  constexpr double head = 10;
  constexpr double half = 3.6;
  const double outer = disc.radius + tip;
  const double point = arrow.incoming ? outer / 2 : outer;
  const double base = arrow.incoming ? point + head : point - head;
  svg.line(disc.centre, disc.at(arrow.theta, arrow.incoming ? outer : base), {"bp-no bp-arrow", 1.3, {}, {}});
  const Point side{half * std::cos(arrow.theta), half * std::sin(arrow.theta)};
  const Point middle = disc.at(arrow.theta, base);
  PathData triangle;
  triangle.move(disc.at(arrow.theta, point));
  triangle.line({middle.x + side.x, middle.y + side.y});
  triangle.line({middle.x - side.x, middle.y - side.y});
  triangle.close();
  svg.path(triangle, {"bp-ink", 0, {}, {}});
}

void draw_surface(SvgWriter& svg, const Disc& disc) {
  const Point left{disc.centre.x - disc.radius - tip, disc.centre.y};
  svg.line(left, {disc.centre.x + disc.radius + tip, disc.centre.y}, {"bp-no bp-arrow", 1.5, {}, {}});
}

} // namespace

void draw_polar(SvgWriter& svg, const PanelPlan& plan) {
  const auto disc = disc_of(plan);
  draw_rings(svg, plan, disc);
  const double lowest = disc.full ? pi : pi / 2;
  const double edge = disc.radius + 1;
  PathData region;
  region.move(disc.at(-lowest, edge));
  region.arc(edge, false, true, disc.at(0, edge));
  region.arc(edge, false, true, disc.at(lowest, edge));
  region.close();
  svg.open_clip(plan.id + "-clip", region);
  draw_lobes(svg, plan, disc);
  svg.close_group();
  draw_surface(svg, disc);
  for (const auto& arrow : plan.panel->arrows) draw_arrow(svg, disc, arrow);
  for (const auto& label : plan.labels) {
    const Point at{disc.centre.x + label.box.x + label.box.w / 2, disc.centre.y + label.box.y + 0.85 * label.size};
    if (disc.full) svg.veil({at.x - label.box.w / 2, disc.centre.y + label.box.y, label.box.w, label.box.h});
    svg.text(at, label.text, label.size, Anchor::middle);
  }
  const double bottom = plan.plot.bottom() + plan.insets.bottom - plan.x_title.height();
  svg.lines({disc.centre.x, bottom}, plan.x_title, Anchor::middle);
}

} // namespace brdfplot::plot
