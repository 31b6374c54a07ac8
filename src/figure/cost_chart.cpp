#include "figure/cost_chart.hpp"

#include "draw/text.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::plot {

namespace {

constexpr int front_style = 6; // ink

bool is_shown(const CostPoint& point) {
  return std::isfinite(point.cost) && std::isfinite(point.error) && point.cost > 0 && point.error > 0;
}

/// Ends of a logarithmic axis a little beyond the data.
void set_range(Axis& axis, const std::vector<CostPoint>& points, double CostPoint::*coordinate, double least_factor) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const auto& point : points) {
    if (!is_shown(point)) continue;
    low = std::min(low, point.*coordinate);
    high = std::max(high, point.*coordinate);
  }
  if (!(high > 0)) return;
  const double margin = std::max(std::pow(high / low, 0.07), least_factor);
  axis.from = low / margin;
  axis.to = high * margin;
}

/// Down and to the right: at each cost the least error so far.
Series staircase(const std::vector<CostPoint>& points, const Axis& cost) {
  std::vector<CostPoint> front;
  for (const auto& point : points)
    if (point.on_front && is_shown(point)) front.push_back(point);
  std::ranges::sort(front, {}, &CostPoint::cost);
  Series series{.label = "front", .x = {}, .y = {}, .style = front_style, .ramp = {}};
  for (std::size_t k = 0; k < front.size(); ++k) {
    if (k > 0) {
      series.x.push_back(front[k].cost);
      series.y.push_back(front[k - 1].error);
    }
    series.x.push_back(front[k].cost);
    series.y.push_back(front[k].error);
  }
  if (!front.empty()) {
    series.x.push_back(cost.to);
    series.y.push_back(front.back().error);
  }
  return series;
}

/// "not shown: a, b (error 0); c (no cost)"
std::string words_of_hidden(const std::vector<CostPoint>& points) {
  std::string exact, infinite, costless;
  const auto append = [](std::string& list, const std::string& name) {
    list += (list.empty() ? "" : ", ") + literal_label(name);
  };
  for (const auto& point : points) {
    if (is_shown(point)) continue;
    if (!(std::isfinite(point.cost) && point.cost > 0))
      append(costless, point.name);
    else
      append(point.error <= 0 ? exact : infinite, point.name);
  }
  std::string words;
  const auto add = [&](const std::string& list, const char* why) {
    if (!list.empty()) words += (words.empty() ? "not shown: " : "; ") + list + " (" + why + ")";
  };
  add(exact, "no error");
  add(infinite, "no number somewhere");
  add(costless, "cost not counted");
  return words;
}

/// The groups of all charts, in the order they come in.
std::vector<std::string> groups_of(const std::vector<CostChart>& charts) {
  std::vector<std::string> groups;
  for (const auto& chart : charts)
    for (const auto& point : chart.points)
      if (std::ranges::find(groups, point.group) == groups.end()) groups.push_back(point.group);
  return groups;
}

/// Points that lie on each other are one, with the names of all: of more than two, of the first and the last.
std::vector<CostPoint> distinct(const std::vector<CostPoint>& points) {
  constexpr double as_one = 1.03; // within the width of a dot
  struct Heap {
    CostPoint point;
    std::size_t count = 1;
    std::string last{};
  };
  std::vector<Heap> heaps;
  for (const auto& point : points) {
    if (!is_shown(point)) continue;
    const auto here = std::ranges::find_if(heaps, [&](const Heap& heap) {
      const CostPoint& p = heap.point;
      return p.group == point.group && std::max(p.cost, point.cost) <= as_one * std::min(p.cost, point.cost) &&
             std::max(p.error, point.error) <= as_one * std::min(p.error, point.error);
    });
    if (here == heaps.end()) {
      heaps.push_back({point});
      continue;
    }
    ++here->count;
    here->last = point.name;
    here->point.on_front = here->point.on_front || point.on_front;
  }
  std::vector<CostPoint> out;
  for (Heap& heap : heaps) {
    if (heap.count > 1) heap.point.name += (heap.count > 2 ? " … " : ", ") + heap.last;
    out.push_back(std::move(heap.point));
  }
  return out;
}

Series dots_of(const std::vector<CostPoint>& points, const std::string& group, bool on_front, std::size_t style) {
  Series series{.label = group, .x = {}, .y = {}, .style = static_cast<int>(style % front_style), .ramp = {}};
  for (const auto& point : points) {
    if (point.group != group || point.on_front != on_front) continue;
    series.x.push_back(point.cost);
    series.y.push_back(point.error);
    series.names.push_back(literal_label(point.name));
  }
  return series;
}

/// From the least of a cost to where it spreads to.
Series spread_of(const CostPoint& point, std::size_t style) {
  return {.label = "",
          .x = {point.cost, point.cost_to},
          .y = {point.error, point.error},
          .style = static_cast<int>(style % front_style),
          .ramp = {}};
}

Panel panel_of(const CostChart& chart, const std::vector<std::string>& groups) {
  Panel panel;
  const std::vector<CostPoint> points = distinct(chart.points);
  panel.title = chart.title;
  panel.x = chart.cost;
  panel.y = chart.error;
  panel.x.scale = panel.y.scale = Scale::logarithmic;
  set_range(panel.x, chart.points, &CostPoint::cost, 1.1);
  set_range(panel.y, chart.points, &CostPoint::error, 3);
  panel.series.push_back(staircase(chart.points, panel.x));
  for (const auto& point : points)
    if (point.cost_to > point.cost)
      panel.series.push_back(
          spread_of(point, static_cast<std::size_t>(std::ranges::find(groups, point.group) - groups.begin())));
  // Those on the front are named first: they get the places nearest to their dots.
  for (const bool on_front : {true, false})
    for (std::size_t g = 0; g < groups.size(); ++g) {
      Series series = dots_of(points, groups[g], on_front, g);
      if (!series.names.empty()) panel.series.push_back(std::move(series));
    }
  if (chart.tolerance)
    panel.series.push_back({.label = "tolerance",
                            .x = {panel.x.from, panel.x.to},
                            .y = {*chart.tolerance, *chart.tolerance},
                            .style = front_style + 1,
                            .ramp = {}});
  const std::string hidden = words_of_hidden(chart.points);
  if (!hidden.empty()) panel.notes.push_back({.text = hidden, .label = hidden});
  return panel;
}

} // namespace

Figure cost_figure(const std::vector<CostChart>& charts, const std::string& id, const std::string& title,
                   const std::string& description) {
  Figure figure;
  figure.id = id;
  figure.title = title;
  figure.description = description;
  const auto groups = groups_of(charts);
  for (const auto& chart : charts) figure.panels.push_back(panel_of(chart, groups));
  return figure;
}

} // namespace brdfplot::plot
