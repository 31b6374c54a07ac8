#include "figure/fit_figure.hpp"

#include <cmath>
#include <cstdio>

namespace brdfplot::plot {

namespace {

constexpr int points = 601;

Series error_curve(const FitResult& result, double y, double from, double to) {
  Series series;
  const auto lambda = result.target.lambda_at(y);
  for (int k = 0; k < points; ++k) {
    const double a = from * std::pow(to / from, k / (points - 1.0));
    series.x.push_back(a);
    series.y.push_back(result.fit.relative_error(a, y, lambda(a)));
  }
  return series;
}

/// The parameter at y as a label; where its domain has no end, y = 0 is that.
std::string value_text(const FitParameter& parameter, double y) {
  if (y == 0 && parameter.to == infinity) return parameter.key + " = ∞";
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", parameter.value(y));
  return parameter.key + " = " + text;
}

} // namespace

Figure fit_error_figure(const FitResult& result, double tolerance, const std::string& id) {
  const double scale = result.fit.form.scale;
  const double from = scale * 1e-3;
  const double to = scale * (result.fit.form.cut ? 10 : 1e3);
  Panel panel;
  panel.x = {.label = result.target.by_cosine() ? "a = cot θ / α" : "a = c / s",
             .column = "a",
             .scale = Scale::logarithmic,
             .from = from,
             .to = to};
  panel.y = {
      .label = "relative error of G_1", .column = "relative_error", .from = -1.5 * tolerance, .to = 1.5 * tolerance};
  const auto& parameter = result.target.parameter;
  constexpr int curves = 7;
  for (int k = 0; k < (parameter ? curves : 1); ++k) {
    const double y = parameter ? k / (curves - 1.0) : 0;
    Series series = error_curve(result, y, from, to);
    series.label = parameter ? value_text(*parameter, y) : "G_1 of the fit";
    if (parameter) series.ramp = y;
    panel.series.push_back(series);
  }
  for (const double sign : {1.0, -1.0})
    panel.series.push_back(
        {.label = "tolerance", .x = {from, to}, .y = {sign * tolerance, sign * tolerance}, .style = 6, .ramp = {}});
  Figure figure;
  figure.id = id;
  figure.title = "Error of the rational fit of Smith's G_1: " + result.target.name;
  figure.description =
      "Relative error of G1 = 1 / (1 + Lambda), without rounding, against a, over all view directions.";
  figure.panels.push_back(panel);
  return figure;
}

} // namespace brdfplot::plot
