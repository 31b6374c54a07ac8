#include <algorithm>
#include <cmath>
#include <cstddef>

#include "draw/svg/plan.hpp"

namespace brdfplot::plot {

namespace {

constexpr double normal_length = 17;

/// What a sketch covers in its own units, with a body below the surface.
struct Bounds {
  double left = 0, right = 1, bottom = 0, top = 1;

  void add(const std::vector<Sketch::Line>& lines) {
    for (const auto& line : lines) {
      left = std::min({left, line.x0, line.x1});
      right = std::max({right, line.x0, line.x1});
      bottom = std::min({bottom, line.y0, line.y1});
      top = std::max({top, line.y0, line.y1});
    }
  }
  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double middle() const { return (left + right) / 2; }
};

Bounds bounds_of(const Sketch& sketch) {
  const auto& window = sketch.window;
  const double depth = sketch.surface.empty() ? 0.01 : 0.035;
  Bounds out{window.x0, window.x1, window.y0 - depth * (window.x1 - window.x0),
             window.y1 + 0.01 * (window.x1 - window.x0)};
  for (const auto* lines :
       {&sketch.rays, &sketch.once, &sketch.more_often, &sketch.sight_lines, &sketch.projection, &sketch.mesosurface})
    out.add(*lines);
  return out;
}

double arrow_length(double cell) { return std::clamp(0.12 * cell, 42.0, 64.0); }

/// The tip of an arrow of a length on the page.
Point tip_of(Point from, double theta, double length) {
  return {from.x + length * std::sin(theta), from.y - length * std::cos(theta)};
}

/// The box of a label beyond a tip.
Box label_box(const std::string& text, Point tip, double theta, double gap) {
  const double w = text_width(text, font::axis), h = font::axis;
  const double out = gap + std::abs(std::sin(theta)) * w / 2 + std::abs(std::cos(theta)) * h / 2;
  const Point middle = tip_of(tip, theta, out);
  return {middle.x - w / 2, middle.y - h / 2, w, h};
}

/// Where an arrow begins, relative to the lower left corner of the plot.
Point place_of(const PanelPlan& plan, const Sketch::Pointer& arrow) {
  return {place_in(plan.x, Scale::linear, arrow.x) * plan.plot.w,
          -place_in(plan.y, Scale::linear, arrow.y) * plan.plot.h};
}

/// Places the labels of arrows at their tips, farther out where they would meet.
void place_labels(PanelPlan& plan, double length) {
  const auto& arrows = plan.panel->sketch->arrows;
  plan.labels.clear();
  for (const auto& arrow : arrows) {
    const Point tip = tip_of(place_of(plan, arrow), arrow.theta, length);
    Box box;
    for (int tries = 0; tries < 30; ++tries) {
      box = label_box(arrow.label, tip, arrow.theta, 3 + 2 * tries);
      const auto on_label = [&](const PolarLabel& other) { return box.touches(other.box, 2); };
      const auto on_arrow = [&](const Sketch::Pointer& other) {
        const Point end = tip_of(place_of(plan, other), other.theta, length);
        return other.theta != arrow.theta && box.touches({end.x, end.y, 0, 0}, 6);
      };
      if (std::ranges::none_of(plan.labels, on_label) && std::ranges::none_of(arrows, on_arrow)) break;
    }
    plan.labels.push_back({arrow.label, font::axis, box});
  }
}

/// The same scale along both axes, in a plot of the given width, with the sketch in its middle.
void set_scale(PanelPlan& plan, double width, double unit) {
  const Bounds bounds = bounds_of(*plan.panel->sketch);
  plan.plot.w = width;
  plan.plot.h = unit * (bounds.top - bounds.bottom);
  plan.x = {bounds.middle() - width / unit / 2, bounds.middle() + width / unit / 2};
  plan.y = {bounds.bottom, bounds.top};
}

/// How far labels and arrows reach beyond the plot.
Insets overhang(const PanelPlan& plan, double length) {
  Insets out;
  const auto add = [&](const Box& box) {
    out.left = std::max(out.left, -box.x);
    out.right = std::max(out.right, box.right() - plan.plot.w);
    out.top = std::max(out.top, -box.y - plan.plot.h);
    out.bottom = std::max(out.bottom, box.bottom());
  };
  const auto add_tips = [&](const std::vector<Sketch::Pointer>& arrows, double reach) {
    for (const auto& arrow : arrows) {
      const Point tip = tip_of(place_of(plan, arrow), arrow.theta, reach);
      add({tip.x - 2, tip.y - 2, 4, 4});
    }
  };
  for (const auto& label : plan.labels) add(label.box);
  for (const auto& line : plan.panel->sketch->projection) {
    const Point end = place_of(plan, {"", line.x0, line.y0, 0});
    add({end.x - 4, end.y - 6, 8, 12});
  }
  add_tips(plan.panel->sketch->arrows, length);
  add_tips(plan.panel->sketch->normals, normal_length);
  return out;
}

Point at(const PanelPlan& plan, double x, double y) { return to_point(plan, x, y); }

PathData path_of(const PanelPlan& plan, const std::vector<Sketch::Line>& lines) {
  PathData path;
  for (const auto& line : lines) {
    path.move(at(plan, line.x0, line.y0));
    path.line(at(plan, line.x1, line.y1));
  }
  return path;
}

void draw_body(SvgWriter& svg, const PanelPlan& plan) {
  const auto& surface = plan.panel->sketch->surface;
  if (surface.empty()) return;
  std::vector<Point> points = {at(plan, surface.front().x0, surface.front().y0)};
  for (const auto& line : surface) points.push_back(at(plan, line.x1, line.y1));
  PathData body;
  append_polyline(body, points);
  body.line({points.back().x, plan.plot.bottom()});
  body.line({points.front().x, plan.plot.bottom()});
  body.close();
  svg.path(body, {"bp-nan", 0, {}, " fill-opacity=\"0.35\""});
}

void draw_rays(SvgWriter& svg, const PanelPlan& plan) {
  constexpr double radius = 1.8;
  const auto& sketch = *plan.panel->sketch;
  const auto draw = [&](const std::vector<Sketch::Line>& rays, const Look& look, std::string_view dashes) {
    PathData begin;
    for (const auto& ray : rays) begin.dot(at(plan, ray.x0, ray.y0), radius);
    svg.path(path_of(plan, rays), {"bp-no bp-" + look.colour, 1, dashes, key_attribute(look)});
    svg.path(begin, {"bp-f-" + look.colour, 0, {}, key_attribute(look)});
  };
  for (std::size_t k = 0; k < plan.looks.size(); ++k) {
    const auto& label = plan.panel->series[k].label;
    if (label == "masked") draw(sketch.stopped_rays, plan.looks[k], "4 2.5");
    if (label.starts_with("visible") && label != "visible, shadowed") draw(sketch.rays, plan.looks[k], {});
  }
}

/// An arrow head that ends where a path leaves.
void draw_exit(SvgWriter& svg, const PanelPlan& plan, const Sketch::Pointer& exit) {
  constexpr double length = 6, half = 2.2;
  const Point to = at(plan, exit.x, exit.y), base = tip_of(to, exit.theta, -length);
  const Point side{half * std::cos(exit.theta), half * std::sin(exit.theta)};
  PathData triangle;
  triangle.move(to);
  triangle.line({base.x + side.x, base.y + side.y});
  triangle.line({base.x - side.x, base.y - side.y});
  triangle.close();
  svg.path(triangle, {"bp-ink", 0, {}, {}});
}

/// Paths of light: thin where they are reflected once, bold where more often.
void draw_paths(SvgWriter& svg, const PanelPlan& plan) {
  const auto& sketch = *plan.panel->sketch;
  if (!sketch.once.empty()) svg.path(path_of(plan, sketch.once), {"bp-no bp-frame", 0.8, {}, {}});
  if (!sketch.more_often.empty()) svg.path(path_of(plan, sketch.more_often), {"bp-no bp-arrow", 1.5, {}, {}});
  for (const auto& exit : sketch.exits) draw_exit(svg, plan, exit);
}

void draw_parts(SvgWriter& svg, const PanelPlan& plan) {
  for (std::size_t k = 0; k < plan.panel->series.size(); ++k) {
    const auto& series = plan.panel->series[k];
    PathData path;
    append_curve(path, plan, series.x, series.y);
    const double width = series.label.starts_with("visible") ? 2.6 : 1.7;
    svg.path(path, {"bp-no bp-line bp-" + plan.looks[k].colour, width, {}, key_attribute(plan.looks[k])});
  }
}

/// The parts side by side, told apart by their tints.
void draw_projection(SvgWriter& svg, const PanelPlan& plan) {
  const auto& lines = plan.panel->sketch->projection;
  for (std::size_t first = 0; first < std::min<std::size_t>(lines.size(), 2); ++first) {
    std::vector<Sketch::Line> every_other;
    for (std::size_t k = first; k < lines.size(); k += 2) every_other.push_back(lines[k]);
    const Look& look = plan.looks.front();
    svg.path(path_of(plan, every_other),
             {"bp-no bp-" + look.colour, 6, {}, (first == 0 ? "" : " stroke-opacity=\"0.5\"") + key_attribute(look)});
  }
}

void draw_pointer(SvgWriter& svg, const PanelPlan& plan, const Sketch::Pointer& pointer, double length, double head) {
  const Point from = at(plan, pointer.x, pointer.y);
  const Point base = tip_of(from, pointer.theta, length - head);
  const double half = 0.36 * head;
  const Point side{half * std::cos(pointer.theta), half * std::sin(pointer.theta)};
  svg.line(from, base, {"bp-no bp-arrow", head > 6 ? 1.3 : 0.9, {}, {}});
  PathData triangle;
  triangle.move(tip_of(from, pointer.theta, length));
  triangle.line({base.x + side.x, base.y + side.y});
  triangle.line({base.x - side.x, base.y - side.y});
  triangle.close();
  svg.path(triangle, {"bp-ink", 0, {}, {}});
}

} // namespace

void measure_profile(const Figure& figure, FigurePlan& plan, double width) {
  const double cell = width / plan.columns;
  constexpr double margin = 2;
  Insets insets{margin, margin, 4, 2};
  for (int round = 0; round < 5; ++round) {
    const double w = std::max(cell - insets.left - insets.right, 40.0);
    double widest = 0;
    for (const auto& panel : plan.panels)
      if (panel.kind == Kind::profile) widest = std::max(widest, bounds_of(*panel.panel->sketch).width());
    Insets most{margin, margin, 4, 2};
    for (auto& panel : plan.panels) {
      if (panel.kind != Kind::profile) continue;
      const double own = bounds_of(*panel.panel->sketch).width();
      set_scale(panel, w, w / (figure.share == Share::none ? own : widest));
      place_labels(panel, arrow_length(cell));
      const Insets over = overhang(panel, arrow_length(cell));
      most.left = std::max(most.left, over.left + margin);
      most.right = std::max(most.right, over.right + margin);
      panel.insets = {insets.left, insets.right, over.top + 6, over.bottom + 2};
    }
    if (most.left <= insets.left && most.right <= insets.right) break;
    insets.left = std::max(insets.left, most.left);
    insets.right = std::max(insets.right, most.right);
  }
}

void draw_profile(SvgWriter& svg, const PanelPlan& plan) {
  const auto& sketch = *plan.panel->sketch;
  const double length = arrow_length(plan.plot.w + plan.insets.left + plan.insets.right);
  draw_body(svg, plan);
  svg.path(path_of(plan, sketch.mesosurface), {"bp-no bp-frame", 1.2, "7 4", {}});
  svg.path(path_of(plan, sketch.sight_lines), {"bp-no bp-frame", 0.7, "2 2.5", {}});
  draw_rays(svg, plan);
  draw_paths(svg, plan);
  draw_parts(svg, plan);
  draw_projection(svg, plan);
  for (const auto& normal : sketch.normals) draw_pointer(svg, plan, normal, normal_length, 5);
  for (const auto& arrow : sketch.arrows) draw_pointer(svg, plan, arrow, length, 10);
  for (const auto& label : plan.labels) {
    const Point middle{plan.plot.x + label.box.x + label.box.w / 2,
                       plan.plot.bottom() + label.box.y + 0.85 * label.size};
    svg.veil({plan.plot.x + label.box.x, plan.plot.bottom() + label.box.y, label.box.w, label.box.h});
    svg.text(middle, label.text, label.size, Anchor::middle);
  }
}

} // namespace brdfplot::plot
