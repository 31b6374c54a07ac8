/// \file
/// Small figures for the tests of the writers.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "draw/model.hpp"

namespace plot_tests {

inline constexpr double pi = std::numbers::pi;

inline brdfplot::plot::Series curve(const std::string& label, int style, double from, double to,
                                    const std::function<double(double)>& f, int steps = 40) {
  brdfplot::plot::Series series;
  series.label = label;
  series.style = style;
  for (int i = 0; i <= steps; ++i) {
    series.x.push_back(std::lerp(from, to, static_cast<double>(i) / steps));
    series.y.push_back(f(series.x.back()));
  }
  return series;
}

inline brdfplot::plot::Axis axis(const std::string& label, const std::string& column,
                                 brdfplot::plot::Unit unit = brdfplot::plot::Unit::none) {
  brdfplot::plot::Axis result;
  result.label = label;
  result.column = column;
  result.unit = unit;
  return result;
}

/// Two panels that share two labels.
inline brdfplot::plot::Figure lines_figure() {
  brdfplot::plot::Figure figure;
  figure.id = "g1";
  figure.title = "Masking G_1 <of> A & B";
  figure.description = "How much is \"seen\".";
  figure.columns = 2;
  for (const char* title : {"α = 0.1", "α = 0.5"}) {
    brdfplot::plot::Panel panel;
    panel.title = title;
    panel.x = axis("θ_o", "theta_o", brdfplot::plot::Unit::degrees);
    panel.y = axis("G_1", "g1");
    panel.series.push_back(curve("GGX", 0, 0, pi / 2, [](double x) { return std::cos(x); }));
    panel.series.push_back(curve("Beckmann", 1, 0, pi / 2, [](double x) { return 1 - x / 2; }));
    figure.panels.push_back(panel);
  }
  return figure;
}

inline brdfplot::plot::Figure polar_figure() {
  brdfplot::plot::Figure figure;
  figure.id = "lobes";
  figure.title = "Lobes";
  figure.kind = brdfplot::plot::Kind::polar;
  brdfplot::plot::Panel panel;
  panel.x = axis("θ_i", "theta_i", brdfplot::plot::Unit::degrees);
  panel.y = axis("f_r", "f_r");
  panel.series.push_back(curve("diffuse", 0, -pi / 2, pi / 2, [](double x) { return std::cos(x); }));
  panel.arrows.push_back({"ω_o", -pi / 4, true});
  panel.arrows.push_back({"ω_r", pi / 4, false});
  figure.panels.push_back(panel);
  return figure;
}

inline brdfplot::plot::Figure heatmap_figure() {
  brdfplot::plot::Figure figure;
  figure.id = "map";
  figure.title = "Map";
  figure.kind = brdfplot::plot::Kind::heatmap;
  brdfplot::plot::Panel panel;
  panel.x = axis("x", "x");
  panel.y = axis("y", "y");
  panel.value = axis("v", "v");
  panel.grid = brdfplot::plot::Grid{{0, 1, 2}, {0, 1}, {0, 0, 1, 0, 0, std::nan("")}};
  panel.contours.push_back({"boundary", {{{0, 2}, {0, 1}}}});
  figure.panels.push_back(panel);
  return figure;
}

/// How often `part` stands in `text`.
inline int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

} // namespace plot_tests
