#include "figure/stress_figure.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::plot {

namespace {

Axis drawn_axis(const choice::MapAxis& axis) {
  return {.label = axis.name,
          .column = axis.name,
          .scale = axis.logarithmic ? Scale::logarithmic : Scale::linear,
          .from = axis.at.front(),
          .to = axis.at.back()};
}

Panel curves(const choice::ProblemMap& map) {
  Panel panel;
  panel.x = drawn_axis(map.x);
  panel.y = {.label = "relative error, log_{10}", .column = "log10_error", .from = -17, .to = 2};
  int style = 0;
  for (const auto& one : map.maps)
    panel.series.push_back({.label = one.method, .x = map.x.at, .y = one.value, .style = style++, .ramp = {}});
  return panel;
}

Panel heat_map(const choice::ProblemMap& map, const choice::ErrorMap& one) {
  Panel panel;
  panel.title = one.method;
  panel.x = drawn_axis(map.x);
  panel.y = drawn_axis(map.y);
  panel.value = {.label = "relative error, log_{10}", .column = "log10_error", .from = -17, .to = 1};
  panel.grid = {map.x.at, map.y.at, one.value};
  for (double& value : panel.grid->value) value = std::min(value, 1.0); // above ten it is as wrong as can be
  return panel;
}

/// Each in double before the same in float, where there are both.
std::vector<choice::ErrorMap> side_by_side(std::vector<choice::ErrorMap> maps) {
  const auto stem = [](const choice::ErrorMap& map) {
    return map.single && map.method.ends_with("_float") ? map.method.substr(0, map.method.size() - 6) : map.method;
  };
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
  figure.description = "The relative error of what is seen of the value, against 50 digits or an own quadrature; a gap "
                       "where the value is no number." +
                       (map.fixed.empty() ? "" : " The other inputs: " + map.fixed + ".");
  if (map.y.at.empty()) {
    figure.panels.push_back(curves(map));
    return figure;
  }
  figure.kind = Kind::heatmap;
  figure.columns = map.maps.size() > 1 ? 2 : 1;
  for (const auto& one : side_by_side(map.maps)) figure.panels.push_back(heat_map(map, one));
  return figure;
}

} // namespace brdfplot::plot
