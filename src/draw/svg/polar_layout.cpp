#include <algorithm>
#include <cmath>
#include <cstddef>

#include "draw/svg/polar.hpp"

namespace brdfplot::plot {

using polar::is_full_disc;
using polar::pi;
using polar::tip;

namespace {

/// The labelled spokes. A narrow plot has few, and leaves out the surface, whose labels would take the width of the
/// disc.
Ticks spokes(const PanelPlan& plan, bool full) {
  Axis angle;
  angle.unit = plan.panel->x.unit == Unit::radians ? Unit::radians : Unit::degrees;
  const int half = plan.narrow ? 5 : 7;
  auto ticks = make_ticks(angle, full ? Range{-pi, pi} : Range{-pi / 2, pi / 2}, full ? 2 * half - 1 : half);
  const double limit = plan.narrow && !full ? pi / 2 - 0.01 : pi + 0.01;
  std::erase_if(ticks.major, [&](const Tick& t) { return t.value < -pi + 0.01 || std::abs(t.value) > limit; });
  return ticks;
}

/// A text box that touches the circle of radius `r` from outside in the direction `theta`.
Box outside_box(const std::string& text, double size, double theta, double r) {
  const double w = text_width(text, size);
  const double h = size;
  const double out = r + std::abs(std::sin(theta)) * w / 2 + std::abs(std::cos(theta)) * h / 2;
  return {out * std::sin(theta) - w / 2, -out * std::cos(theta) - h / 2, w, h};
}

/// Whether no point of a box is closer to the centre than `r`.
bool outside_disc(const Box& box, double r) {
  return std::hypot(std::clamp(0.0, box.x, box.right()), std::clamp(0.0, box.y, box.bottom())) >= r;
}

/// Places a label in its direction, far enough out to keep clear of those before it, and within the cell: at its edge
/// the label moves up instead.
void place_outside(std::vector<PolarLabel>& labels, const PolarLabel& label, double theta, double r, double cell) {
  if (label.text.empty()) return;
  Box box;
  for (int tries = 0; tries < 60; ++tries) {
    box = outside_box(label.text, label.size, theta, r + 2 * tries);
    const double inside = std::clamp(box.x, -cell / 2, std::max(cell / 2 - box.w, -cell / 2));
    if (inside != box.x) box.y = outside_box(label.text, label.size, theta, r).y - 2 * tries;
    box.x = inside;
    const auto covers = [&](const PolarLabel& other) { return box.touches(other.box, 3); };
    if (outside_disc(box, r - 1) && std::none_of(labels.begin(), labels.end(), covers)) break;
  }
  labels.push_back({label.text, label.size, box});
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

/// Ring labels: under the surface of a half disc, which no lobe reaches; else where the lobes are smallest. A wide one
/// at the outermost ring moves inward to stay in its cell.
void place_ring_labels(PanelPlan& plan, double radius, double cell, bool full) {
  const double direction = full ? quiet_direction(plan) : pi / 2;
  for (const auto& tick : plan.y_ticks.major) {
    const double r = radius * place_in(plan.y, plan.panel->y.scale, tick.value);
    if (tick.label.empty() || (full && (r < 1 || r > radius - 1))) continue;
    const double w = text_width(tick.label, font::tick);
    const double x = std::min(r * std::sin(direction) - w / 2, cell / 2 - w);
    const double y = full ? -r * std::cos(direction) - font::tick / 2 : 9;
    plan.labels.push_back({tick.label, font::tick, {x, y, w, font::tick}});
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

/// Each how many rings have a label: so few that the labels are clear, always the outermost and the centre.
std::size_t label_every(const Ticks& ticks, const std::vector<double>& radii) {
  const std::size_t rings = std::max<std::size_t>(ticks.major.size(), 2) - 1;
  for (std::size_t every = 1; every < rings; ++every) {
    if (rings % every == 0 && every_clear(ticks, radii, every)) return every;
  }
  return rings;
}

/// The rings, the outermost among them where the range ends round; those whose labels have no room stay without.
Ticks ring_ticks(const PanelPlan& plan, double radius) {
  constexpr double closest = 9;
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

void place_labels(PanelPlan& plan, double radius, double cell) {
  const bool full = is_full_disc(*plan.panel);
  plan.labels.clear();
  plan.y_ticks = ring_ticks(plan, radius);
  place_ring_labels(plan, radius, cell, full);
  for (const auto& spoke : spokes(plan, full).major) {
    plan.labels.push_back(
        {spoke.label, font::tick, outside_box(spoke.label, font::tick, spoke.value, radius + tip + 4)});
  }
  for (const auto& arrow : plan.panel->arrows) {
    place_outside(plan.labels, {arrow.label, font::axis, {}}, arrow.theta, radius + tip + 5, cell);
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

} // namespace

bool polar::is_full_disc(const Panel& panel) {
  constexpr double limit = pi / 2 + 1e-6;
  const auto beyond = [](double angle) { return std::abs(angle) > limit; };
  return std::any_of(panel.series.begin(), panel.series.end(),
                     [&](const Series& s) { return std::any_of(s.x.begin(), s.x.end(), beyond); }) ||
         std::any_of(panel.arrows.begin(), panel.arrows.end(), [&](const Arrow& a) { return beyond(a.theta); });
}

void measure_polar(const Figure&, FigurePlan& plan, double width) {
  const double cell = width / plan.columns;
  double radius = std::min(cell / 2 - 8, 250.0);
  for (const auto& panel : plan.panels) {
    if (panel.kind == Kind::polar && is_full_disc(*panel.panel)) radius = std::min(radius, 190.0);
  }
  for (int round = 0; round < 4; ++round) {
    double most = 0;
    for (auto& panel : plan.panels) {
      if (panel.kind != Kind::polar) continue;
      panel.narrow = cell < 190;
      place_labels(panel, radius, cell);
      most = std::max(most, overflow(panel, cell));
    }
    if (most <= 0) break;
    radius = std::max(radius - most, 30.0);
  }
  for (std::size_t i = 0; i < plan.panels.size(); ++i) {
    auto& panel = plan.panels[i];
    if (panel.kind != Kind::polar) continue;
    place_labels(panel, radius, cell);
    if (!repeated_below(plan, i, &Panel::y)) panel.x_title = fit_text(panel.panel->y.label, font::axis, cell, 1);
    set_insets(panel, radius, cell);
  }
}

} // namespace brdfplot::plot
