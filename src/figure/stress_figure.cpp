#include "figure/stress_figure.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::plot {

namespace {

/// The name that a method in float shares with the same in double.
std::string stem(const choice::ErrorMap& map) {
  return map.single && map.method.ends_with("_float") ? map.method.substr(0, map.method.size() - 6) : map.method;
}

Axis drawn_axis(const choice::MapAxis& axis) {
  return {.label = axis.name,
          .column = axis.name,
          .scale = axis.logarithmic ? Scale::logarithmic : Scale::linear,
          .from = axis.at.front(),
          .to = axis.at.back()};
}

/// Whose errors, of methods in double or in float.
Panel curves(const choice::ProblemMap& map, bool single, bool own) {
  Panel panel;
  panel.title = std::string(single ? "float" : "double") + (map.seen_as.empty() ? ""
                                                            : own               ? ", the value"
                                                                                : ", " + map.seen_as);
  panel.x = drawn_axis(map.x);
  panel.y = {.label = "relative error, log_{10}", .column = "log10_error", .from = -17, .to = 2};
  int style = 0;
  for (const auto& one : map.maps)
    if (one.single == single)
      panel.series.push_back(
          {.label = stem(one), .x = map.x.at, .y = own ? one.own : one.seen, .style = style++, .ramp = {}});
  return panel;
}

void add_curves(const choice::ProblemMap& map, Figure& figure) {
  figure.columns = 2;
  for (const bool own : {true, false})
    for (const bool single : {false, true})
      if ((!own || !map.seen_as.empty()) && std::ranges::count(map.maps, single, &choice::ErrorMap::single) > 0)
        figure.panels.push_back(curves(map, single, own));
}

Panel heat_map(const choice::ProblemMap& map, const choice::ErrorMap& one) {
  Panel panel;
  panel.title = one.method;
  panel.x = drawn_axis(map.x);
  panel.y = drawn_axis(map.y);
  panel.value = {.label = "relative error, log_{10}", .column = "log10_error", .from = -17, .to = 0};
  panel.grid = {map.x.at, map.y.at, one.seen};
  for (double& value : panel.grid->value) value = std::min(value, 0.0); // no digit is left
  return panel;
}

/// Each in double before the same in float, where there are both.
std::vector<choice::ErrorMap> side_by_side(std::vector<choice::ErrorMap> maps) {
  std::vector<std::string> order;
  for (const auto& map : maps)
    if (std::ranges::find(order, stem(map)) == order.end()) order.push_back(stem(map));
  std::ranges::stable_sort(maps, {}, [&](const choice::ErrorMap& map) {
    return 2 * (std::ranges::find(order, stem(map)) - order.begin()) + (map.single ? 1 : 0);
  });
  return maps;
}

} // namespace

Figure stress_figure(const choice::ProblemMap& map) {
  Figure figure;
  figure.id = map.problem;
  figure.title = "Errors: " + map.doc;
  figure.description = "The relative error, 1 and more as 1 in maps; nothing where the value is no number." +
                       (map.fixed.empty() ? "" : " The other inputs: " + map.fixed + ".");
  if (map.y.at.empty()) {
    add_curves(map, figure);
    return figure;
  }
  figure.kind = Kind::heatmap;
  figure.columns = map.maps.size() > 1 ? 2 : 1;
  for (const auto& one : side_by_side(map.maps)) figure.panels.push_back(heat_map(map, one));
  return figure;
}

} // namespace brdfplot::plot
