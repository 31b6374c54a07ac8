#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/threads/interrupt.hpp"
#include "draw/svg/plan.hpp"

namespace brdfplot::plot {

namespace {

constexpr double point_radius = 4;
constexpr double name_size = smallest_font;
constexpr double name_height = 1.15 * name_size;

/// A point with its name, and where that goes.
struct NamedPoint {
  Point at;
  std::string name;
  Look look;
  std::optional<Box> place;
};

Box dot_box(const NamedPoint& point) {
  return {point.at.x - point_radius, point.at.y - point_radius, 2 * point_radius, 2 * point_radius};
}

/// Whether the segment meets the box.
bool crosses(Point a, Point b, const Box& box) {
  constexpr int steps = 24;
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    const Point p{std::lerp(a.x, b.x, t), std::lerp(a.y, b.y, t)};
    if (p.x > box.x && p.x < box.right() && p.y > box.y && p.y < box.bottom()) return true;
  }
  return false;
}

/// Whether two segments have an inner point in common.
bool cross(Point a, Point b, Point c, Point d) {
  const auto side = [](Point p, Point q, Point r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// The point of a box nearest to another.
Point nearest_in(const Box& box, Point p) {
  return {std::clamp(p.x, box.x, box.right()), std::clamp(p.y, box.y, box.bottom())};
}

std::vector<NamedPoint> named_points(const PanelPlan& plan) {
  std::vector<NamedPoint> points;
  for (std::size_t s = 0; s < plan.panel->series.size(); ++s) {
    const Series& series = plan.panel->series[s];
    for (std::size_t k = 0; k < std::min({series.names.size(), series.x.size(), series.y.size()}); ++k) {
      const Point at = to_point(plan, series.x[k], series.y[k]);
      if (std::isnan(at.x) || std::isnan(at.y)) continue;
      points.push_back({at, series.names[k], plan.looks[s], std::nullopt});
    }
  }
  return points;
}

/// The corners of the lines of the panel.
std::vector<std::vector<Point>> line_corners(const PanelPlan& plan) {
  std::vector<std::vector<Point>> lines;
  for (const Series& series : plan.panel->series) {
    if (!series.names.empty()) continue;
    auto& line = lines.emplace_back();
    for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k)
      line.push_back(to_point(plan, series.x[k], series.y[k]));
  }
  return lines;
}

/// Where names can go, nearest places first.
class NamePlacer {
public:
  NamePlacer(const PanelPlan& plan, std::vector<NamedPoint>& points)
      : frame_(plan.plot), points_(points), lines_(line_corners(plan)) {}

  /// Puts the name where it meets no other. The lines to names meet neither names nor each other, or, with `may_cross`,
  /// as few as can be.
  void place(NamedPoint& point, bool may_cross) const {
    constexpr double on_a_line = 60;   // as good as being so much farther off
    constexpr double over_a_dot = 150; // whose name it would seem to be
    constexpr double at_a_crossing = 90;
    double least = std::numeric_limits<double>::infinity();
    for (const double distance : {0.0, 6.0, 14.0, 24.0, 36.0, 50.0, 65.0, 80.0, 95.0, 125.0, 160.0, 200.0}) {
      if (distance > least) return;
      for (int k = 0; k < directions; ++k) {
        const Box box = box_at(point, distance, 2 * std::numbers::pi * k / directions);
        if (!is_free(box)) continue;
        const auto crossings = static_cast<double>(crossings_of(box, point));
        if (crossings > 0 && !may_cross) continue;
        const double cost = distance + 0.05 * k + (meets_line(box) ? on_a_line : 0) +
                            (leads_over(box, point) ? over_a_dot : 0) + at_a_crossing * crossings;
        if (cost >= least) continue;
        least = cost;
        point.place = box;
      }
    }
  }

private:
  static constexpr int directions = 32;

  /// The box of the name whose nearest edge is `distance` beyond the dot; the first direction is to the right.
  static Box box_at(const NamedPoint& point, double distance, double angle) {
    const double width = text_width(point.name, name_size) + 2;
    const double reach = point_radius + 2.5 + distance;
    const double x = point.at.x + reach * std::cos(angle), y = point.at.y - reach * std::sin(angle);
    return {x - width / 2 + width / 2 * std::cos(angle), y - name_height / 2 - name_height / 2 * std::sin(angle), width,
            name_height};
  }

  /// Whether the box lies in the frame, and on no dot and no name.
  bool is_free(const Box& box) const {
    if (box.x < frame_.x + 2 || box.right() > frame_.right() - 2 || box.y < frame_.y + 2 ||
        box.bottom() > frame_.bottom() - 2)
      return false;
    return std::ranges::none_of(points_, [&](const NamedPoint& other) {
      return box.touches(dot_box(other), 1) || (other.place && box.touches(*other.place, 1));
    });
  }

  /// How many names and lines to names the name and the line to it would meet.
  std::ptrdiff_t crossings_of(const Box& box, const NamedPoint& point) const {
    const Point end = nearest_in(box, point.at);
    return std::ranges::count_if(points_, [&](const NamedPoint& other) {
      if (!other.place) return false;
      const Point other_end = nearest_in(*other.place, other.at);
      return crosses(point.at, end, *other.place) || crosses(other.at, other_end, box) ||
             cross(point.at, end, other.at, other_end);
    });
  }

  /// Whether the line to the name runs over another dot.
  bool leads_over(const Box& box, const NamedPoint& point) const {
    const Point end = nearest_in(box, point.at);
    return std::ranges::any_of(points_, [&](const NamedPoint& other) {
      const bool same = std::hypot(other.at.x - point.at.x, other.at.y - point.at.y) < point_radius;
      return !same && crosses(point.at, end, dot_box(other));
    });
  }

  bool meets_line(const Box& box) const {
    return std::ranges::any_of(lines_, [&](const std::vector<Point>& line) {
      for (std::size_t k = 1; k < line.size(); ++k)
        if (crosses(line[k - 1], line[k], box)) return true;
      return false;
    });
  }

  Box frame_;
  std::vector<NamedPoint>& points_;
  std::vector<std::vector<Point>> lines_;
};

/// The dot; a name that has no room beside it is told where a pointer rests on it.
void draw_dot(SvgWriter& svg, const NamedPoint& point) {
  PathData dot;
  dot.dot(point.at, point_radius);
  const bool hidden = !point.place && !point.name.empty();
  if (hidden) {
    std::string title = "<g><title>";
    append_escaped(title, strip_markup(point.name));
    svg.raw(title + "</title>\n");
  }
  svg.path(dot, {"bp-f-" + point.look.colour, 0, {}, key_attribute(point.look)});
  if (hidden) svg.close_group();
}

/// One name after the other; those that find no room go first the next time, and those that never do have lines that
/// cross others.
void place_names(const PanelPlan& plan, std::vector<NamedPoint>& points) {
  constexpr int most_rounds = 6;
  std::vector<NamedPoint> best;
  std::size_t least_left = points.size() + 1;
  for (int round = 0; round < most_rounds && least_left > 0; ++round) {
    throw_if_interrupted();
    for (auto& point : points) point.place.reset();
    const NamePlacer placer(plan, points);
    for (auto& point : points)
      if (!point.name.empty()) placer.place(point, false);
    const auto has_no_room = [](const NamedPoint& point) { return !point.place && !point.name.empty(); };
    const auto left = static_cast<std::size_t>(std::ranges::count_if(points, has_no_room));
    if (left < least_left) {
      least_left = left;
      best = points;
    }
    std::stable_partition(points.begin(), points.end(), has_no_room);
  }
  points = std::move(best);
  const NamePlacer placer(plan, points);
  for (auto& point : points)
    if (!point.place && !point.name.empty()) placer.place(point, true);
}

} // namespace

void draw_named_points(SvgWriter& svg, const PanelPlan& plan) {
  std::vector<NamedPoint> points = named_points(plan);
  place_names(plan, points);
  for (const auto& point : points) {
    if (!point.place) continue;
    const Point end = nearest_in(*point.place, point.at);
    if (std::hypot(end.x - point.at.x, end.y - point.at.y) < point_radius + 5) continue;
    PathData leader;
    leader.move(point.at);
    leader.line(end);
    svg.path(leader, {"bp-no bp-frame", 0.7, {}, key_attribute(point.look)});
  }
  for (const auto& point : points) draw_dot(svg, point);
  for (const auto& point : points) {
    if (!point.place) continue;
    svg.open_group("bp-name", key_attribute(point.look));
    svg.veil(*point.place);
    svg.text({point.place->x + 1, point.place->y + 0.8 * name_height}, point.name, name_size, Anchor::start);
    svg.close_group();
  }
}

} // namespace brdfplot::plot
