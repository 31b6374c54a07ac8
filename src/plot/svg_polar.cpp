#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "plot/svg_plan.hpp"

namespace brdfplot::plot {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double tip = 4; ///< how far arrows end beyond the outer ring

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

/// Whether an angle beyond ±90° occurs.
bool is_full_disc(const Panel& panel) {
  constexpr double limit = pi / 2 + 1e-6;
  const auto beyond = [](double angle) { return std::abs(angle) > limit; };
  return std::any_of(panel.series.begin(), panel.series.end(),
                     [&](const Series& s) { return std::any_of(s.x.begin(), s.x.end(), beyond); }) ||
         std::any_of(panel.arrows.begin(), panel.arrows.end(), [&](const Arrow& a) { return beyond(a.theta); });
}

Disc disc_of(const PanelPlan& plan) {
  const bool full = is_full_disc(*plan.panel);
  const double radius = plan.plot.w / 2;
  return {{plan.plot.x + radius, plan.plot.y + radius}, radius, full};
}

/// The labelled spokes.
Ticks spokes(const Axis& axis, bool full) {
  Axis angle;
  angle.unit = axis.unit == Unit::radians ? Unit::radians : Unit::degrees;
  auto ticks = make_ticks(angle, full ? Range{-pi, pi} : Range{-pi / 2, pi / 2}, full ? 13 : 7);
  if (full) std::erase_if(ticks.major, [](const Tick& tick) { return tick.value < -pi + 1e-6; });
  return ticks;
}

/// A text box that touches the circle of radius `r` from outside in the direction `theta`.
Box outside_box(const std::string& text, double size, double theta, double r) {
  const double w = text_width(text, size);
  const double h = size;
  const double out = r + std::abs(std::sin(theta)) * w / 2 + std::abs(std::cos(theta)) * h / 2;
  return {out * std::sin(theta) - w / 2, -out * std::cos(theta) - h / 2, w, h};
}

/// Places a label in its direction, far enough out to keep clear of those before it.
void place_outside(std::vector<PolarLabel>& labels, const std::string& text, double size, double theta, double r) {
  if (text.empty()) return;
  Box box = outside_box(text, size, theta, r);
  const auto covered = [&] {
    return std::any_of(labels.begin(), labels.end(),
                       [&](const PolarLabel& other) { return box.touches(other.box, 3); });
  };
  for (int tries = 0; tries < 60 && covered(); ++tries) box = outside_box(text, size, theta, r += 2);
  labels.push_back({text, size, box});
}

/// The direction for the ring labels of a full disc: between two spokes, where the lobes are smallest.
double quiet_direction(const PanelPlan& plan) {
  double best = 3 * pi / 4;
  double least = std::numeric_limits<double>::infinity();
  for (const double degrees : {135.0, 105.0, 165.0, -135.0, -105.0, -165.0, 75.0, -75.0, 45.0, -45.0}) {
    const double direction = degrees * pi / 180;
    double most = 0;
    for (const auto& series : plan.panel->series) {
      for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
        const bool near = std::abs(std::remainder(series.x[i] - direction, 2 * pi)) < pi / 15;
        if (near && std::isfinite(series.y[i])) most = std::max(most, series.y[i]);
      }
    }
    if (most < least) {
      least = most;
      best = direction;
    }
  }
  return best;
}

/// Ring labels: under the surface of a half disc, which no lobe reaches; else where the lobes are smallest.
void place_ring_labels(PanelPlan& plan, double radius, bool full) {
  const double direction = full ? quiet_direction(plan) : pi / 2;
  for (const auto& tick : plan.y_ticks.major) {
    const double r = radius * place_in(plan.y, plan.panel->y.scale, tick.value);
    if (tick.label.empty() || (full && (r < 1 || r > radius - 1))) continue;
    const double w = text_width(tick.label, font::tick);
    const double y = full ? -r * std::cos(direction) - font::tick / 2 : 9;
    plan.labels.push_back({tick.label, font::tick, {r * std::sin(direction) - w / 2, y, w, font::tick}});
  }
}

/// Whether the labels of each `every`-th ring, counted from the outermost, keep clear of each other.
bool every_clear(const Ticks& ticks, const std::vector<double>& radii, std::size_t every) {
  for (std::size_t i = ticks.major.size() - 1; !ticks.major.empty() && i >= every; i -= every) {
    const double width =
        text_width(ticks.major[i].label, font::tick) + text_width(ticks.major[i - every].label, font::tick);
    if (radii[i] - radii[i - every] < width / 2 + 5) return false;
  }
  return true;
}

/// Each how many rings have a label: so many that the labels are clear, and rather such that the centre has one too.
std::size_t label_every(const Ticks& ticks, const std::vector<double>& radii) {
  const std::size_t rings = ticks.major.empty() ? 0 : ticks.major.size() - 1;
  for (std::size_t every = 1; 2 * every <= rings; ++every) {
    if (rings % every == 0 && every_clear(ticks, radii, every)) return every;
  }
  std::size_t every = 1;
  while (every <= rings && !every_clear(ticks, radii, every)) ++every;
  return every;
}

/// The rings, the outermost among them where the range ends round; those whose labels have no room stay without.
Ticks ring_ticks(const PanelPlan& plan, double radius) {
  constexpr double closest = 16;
  const auto& axis = plan.panel->y;
  const auto rings = [&](const Ticks& t) { return t.major.empty() ? 0.0 : static_cast<double>(t.major.size() - 1); };
  const auto ends_round = [&](const Ticks& t) {
    return !t.major.empty() && place_in(plan.y, axis.scale, t.major.back().value) > 1 - 1e-6;
  };
  int most = 9;
  auto ticks = make_ticks(axis, plan.y, most);
  while (most > 3 && (!ends_round(ticks) || rings(ticks) * closest > radius)) ticks = make_ticks(axis, plan.y, --most);
  if (!ends_round(ticks)) ticks = make_ticks(axis, plan.y, std::clamp(static_cast<int>(radius / 24), 3, 9));

  std::vector<double> radii;
  for (const auto& tick : ticks.major) radii.push_back(radius * place_in(plan.y, axis.scale, tick.value));
  const std::size_t every = label_every(ticks, radii);
  for (std::size_t i = 0; i < ticks.major.size(); ++i) {
    if ((ticks.major.size() - 1 - i) % every != 0) ticks.major[i].label.clear();
  }
  return ticks;
}

void place_labels(PanelPlan& plan, double radius) {
  const bool full = is_full_disc(*plan.panel);
  plan.labels.clear();
  plan.y_ticks = ring_ticks(plan, radius);
  place_ring_labels(plan, radius, full);
  for (const auto& spoke : spokes(plan.panel->x, full).major) {
    plan.labels.push_back(
        {spoke.label, font::tick, outside_box(spoke.label, font::tick, spoke.value, radius + tip + 4)});
  }
  for (const auto& arrow : plan.panel->arrows) {
    place_outside(plan.labels, arrow.label, font::axis, arrow.theta, radius + tip + 5);
  }
}

/// How far the labels reach beyond a cell of the given width, at either side.
double overflow(const PanelPlan& plan, double cell) {
  double most = -cell / 2;
  for (const auto& label : plan.labels) most = std::max({most, -label.box.x - cell / 2, label.box.right() - cell / 2});
  return most;
}

void set_insets(PanelPlan& plan, double radius, double cell) {
  const bool full = is_full_disc(*plan.panel);
  const double below = full ? radius : 0;
  plan.plot.w = 2 * radius;
  plan.plot.h = radius + below;
  plan.insets = {cell / 2 - radius, cell / 2 - radius, 0, 0};
  for (const auto& label : plan.labels) {
    plan.insets.top = std::max(plan.insets.top, -label.box.y - radius + 4);
    plan.insets.bottom = std::max(plan.insets.bottom, label.box.bottom() - below);
  }
  plan.insets.bottom += plan.x_title.lines.empty() ? 0 : plan.x_title.height() + 6;
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
  const int last = disc.full ? 11 : 5;
  const int parts = disc.radius >= 100 ? 2 : 1; // spokes at each 15 degrees where they do not crowd
  for (int k = -last * parts; k <= last * parts; ++k) {
    const double theta = k * pi / 6 / parts;
    const bool labelled = k % parts == 0;
    if (std::abs(theta) > (disc.full ? pi + 0.1 : pi / 2 - 0.1)) continue;
    grid.move(disc.at(theta, labelled ? 0 : disc.radius * 0.25));
    grid.line(disc.at(theta, disc.radius));
  }
  svg.path(grid, {"bp-no bp-grid", 1, {}, {}});
  PathData outer;
  ring(outer, disc.radius);
  svg.path(outer, {"bp-no bp-frame", 1, {}, {}});
}

void draw_lobes(SvgWriter& svg, const PanelPlan& plan, const Disc& disc) {
  const auto& panel = *plan.panel;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
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
    svg.path(path,
             {"bp-line bp-" + look.colour + " bp-f-" + look.colour, 2, dash(look.dash), " fill-opacity=\"0.07\""});
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

void measure_polar(const Figure& figure, FigurePlan& plan, double width) {
  const double cell = width / plan.columns;
  double radius = std::min(cell / 2 - 20, 250.0);
  for (const auto& panel : figure.panels) {
    if (is_full_disc(panel)) radius = std::min(radius, 190.0);
  }
  for (int round = 0; round < 4; ++round) {
    double most = 0;
    for (auto& panel : plan.panels) {
      place_labels(panel, radius);
      most = std::max(most, overflow(panel, cell));
    }
    if (most <= 0) break;
    radius = std::max(radius - most, 30.0);
  }
  for (std::size_t i = 0; i < plan.panels.size(); ++i) {
    auto& panel = plan.panels[i];
    place_labels(panel, radius);
    const std::size_t below = i + static_cast<std::size_t>(plan.columns);
    const auto& label = figure.panels[i].y.label;
    if (below >= figure.panels.size() || figure.panels[below].y.label != label) {
      panel.x_title = fit_text(label, font::axis, cell, 1);
    }
    set_insets(panel, radius, cell);
  }
}

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
    svg.text(at, label.text, label.size, Anchor::middle, disc.full ? "bp-ink bp-veil" : "bp-ink");
  }
  const double bottom = plan.plot.bottom() + plan.insets.bottom - plan.x_title.height();
  svg.lines({disc.centre.x, bottom}, plan.x_title, Anchor::middle);
}

} // namespace brdfplot::plot
