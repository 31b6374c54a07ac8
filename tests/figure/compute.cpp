#include "analysis/integrals.hpp"
#include "base/errors.hpp"
#include "brdf/evaluate.hpp"
#include "figure/description.hpp"
#include "figure/sampling.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace brdfplot;
using namespace brdfplot::plot;

constexpr double pi = std::numbers::pi;

TermDescription material_of(const std::string& type, double alpha, const std::string& masking = "smith") {
  TermDescription out;
  out.name = "m";
  out.distribution.type = type;
  out.masking.type = masking;
  out.distribution.values.set("alpha", alpha);
  return out;
}

Expression term(const std::string& quantity, const TermDescription& material, std::vector<Setting> at = {}) {
  Expression out;
  out.term = {quantity, material, std::move(at)};
  return out;
}

Expression combined(Expression::Operation operation, std::vector<Expression> operands) {
  Expression out;
  out.operation = operation;
  out.operands = std::move(operands);
  return out;
}

Axis swept(const std::string& variable, double from, double to) {
  Axis axis;
  axis.column = axis.label = variable;
  axis.from = from;
  axis.to = to;
  return axis;
}

PanelDescription panel_of(const std::string& title, const Axis& x, std::vector<SeriesDescription> series) {
  PanelDescription panel;
  panel.title = title;
  panel.x = x;
  panel.series = std::move(series);
  return panel;
}

FigureDescription figure_of(std::vector<PanelDescription> panels, Kind kind = Kind::lines) {
  FigureDescription figure;
  figure.id = "fig";
  figure.title = "T";
  figure.caption = "C";
  figure.kind = kind;
  figure.panels = std::move(panels);
  return figure;
}

double interpolated(const Series& series, double x) {
  const auto right = std::ranges::upper_bound(series.x, x) - series.x.begin();
  const auto k = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(right, 1, std::ssize(series.x) - 1));
  const double t = (x - series.x[k - 1]) / (series.x[k] - series.x[k - 1]);
  return series.y[k - 1] + t * (series.y[k] - series.y[k - 1]);
}

const TermDescription rough = material_of("ggx", 0.5);

} // namespace

TEST_CASE("figures: the same description gives the same data") {
  auto lobes = panel_of("p", swept("theta_i", -pi / 2, pi / 2),
                        {{"a", term("brdf_cos", rough, {{"theta_o", 1.0}}), {}},
                         {"b", term("brdf_cos", material_of("beckmann", 0.05), {{"theta_o", 1.0}}), 0.5}});
  lobes.arrows = {{"ω_o", 1.0, false}};
  auto energy = panel_of("q", swept("theta_o", 0, 1.5), {{"a", term("furnace", rough), {}}});
  const auto description = figure_of({lobes, energy}, Kind::polar);
  const Figure first = compute(description), second = compute(description);
  CHECK(to_csv(first) == to_csv(second));
  CHECK(to_svg(first) == to_svg(second));
  CHECK(first.id == "fig");
  CHECK(first.title == "T");
  CHECK(first.description == "C");
  CHECK(first.kind == Kind::polar);
  REQUIRE(first.panels.size() == 2);
  CHECK(first.panels[0].title == "p");
  CHECK(first.panels[0].arrows.size() == 1);
  CHECK(first.panels[0].series.at(1).ramp == 0.5);
  for (const auto& panel : first.panels)
    for (const auto& series : panel.series) CHECK(std::ranges::is_sorted(series.x));
}

TEST_CASE("figures: series of one label look alike in every panel") {
  const auto x = swept("theta_m", 0, 1);
  const auto one = term("d", rough);
  const auto figure = compute(figure_of({panel_of("p", x, {{"a", one, {}}, {"b", one, {}}}),
                                         panel_of("q", x, {{"c", one, {}}, {"b", one, {}}, {"a", one, {}}})}));
  const auto styles = [](const Panel& panel) {
    std::vector<int> out;
    for (const auto& series : panel.series) out.push_back(series.style);
    return out;
  };
  CHECK(styles(figure.panels.at(0)) == std::vector<int>{0, 1});
  CHECK(styles(figure.panels.at(1)) == std::vector<int>{2, 1, 0});
}

TEST_CASE("figures: differences, ratios and absolute values") {
  const auto g1 = term("g1", material_of("ggx", 0.5)), other = term("g1", material_of("beckmann", 0.8));
  auto panel =
      panel_of("p", swept("theta_o", 0, 1.5),
               {{"difference", combined(Expression::Operation::difference, {g1, other}), {}},
                {"ratio", combined(Expression::Operation::ratio, {g1, other}), {}},
                {"absolute",
                 combined(Expression::Operation::absolute, {combined(Expression::Operation::difference, {other, g1})}),
                 {}}});
  panel.samples = 11;
  const auto series = compute(figure_of({panel})).panels.at(0).series;
  const auto value = [](const MaterialDescription& material, double theta) {
    return evaluate(build(material), Quantity::g1, from_angles(theta, 0), {}, {});
  };
  for (std::size_t k = 0; k < 11; ++k) {
    const double theta = series.at(0).x.at(k);
    CHECK(theta == doctest::Approx(0.15 * static_cast<double>(k)));
    const double a = value(g1.term.material, theta), b = value(other.term.material, theta);
    CHECK(series.at(0).y.at(k) == a - b);
    CHECK(series.at(1).y.at(k) == a / b);
    CHECK(series.at(2).y.at(k) == std::fabs(b - a));
  }
}

TEST_CASE("figures: narrow lobes are found wherever they are") {
  struct Case {
    std::string quantity, variable;
    double from, to;
    std::vector<Setting> at;
    double peak;
  };
  const auto smooth = material_of("ggx", 0.002);
  auto tilted = smooth;
  tilted.distribution.values.set("mean_slope", Vec2{0.37, -0.21});
  const double normal = std::atan(-0.37), azimuth = std::atan2(0.21, -0.37);
  const double both = std::atan(std::hypot(0.37, 0.21));
  const std::vector<std::pair<TermDescription, Case>> cases = {
      {smooth, {"d", "theta_m", -1.5, 1.4, {}, 0}},
      {smooth, {"p22", "slope", -1, 2.1, {}, 0}},
      {smooth, {"brdf", "theta_i", -1.5, 1.4, {{"theta_o", 0.7}}, -0.7}},
      {smooth, {"brdf", "theta_i", -1.5, 1.4, {{"theta_o", 0.7}, {"phi_o", pi}}, 0.7}},
      {smooth, {"brdf", "theta_o", -1.5, 1.4, {{"theta_i", 0.31}}, -0.31}},
      {smooth, {"brdf", "phi_i", -1, 5, {{"theta_o", 0.7}, {"theta_i", 0.7}, {"phi_o", 0.4}}, 0.4 + pi}},
      {smooth, {"brdf", "phi_o", -3.1, 3, {{"theta_o", 0.7}, {"theta_i", 0.7}, {"phi_i", 1.0}}, 1 - pi}},
      {tilted, {"d", "theta_m", -1.5, 1.4, {{"phi_m", azimuth}}, both}},
      {tilted, {"p22", "slope", -1, 2.1, {{"phi_m", azimuth}}, std::tan(both)}},
      {tilted, {"d", "phi_m", -3, 3.1, {{"theta_m", both}}, azimuth}},
  };
  for (const auto& [material, of] : cases) {
    const auto& one = of; // Clang 14 has no structured binding in the lambda of CAPTURE
    CAPTURE(one.quantity);
    CAPTURE(one.variable);
    CAPTURE(one.peak);
    const auto figure = compute(figure_of(
        {panel_of("p", swept(one.variable, one.from, one.to), {{"s", term(one.quantity, material, one.at), {}}})}));
    const auto& series = figure.panels.at(0).series.at(0);
    const auto top = std::ranges::max_element(series.y) - series.y.begin();
    CHECK(series.x.at(static_cast<std::size_t>(top)) == doctest::Approx(one.peak).epsilon(1e-3));
    CHECK(series.x.size() < 400);
  }
  // Within the plane of incidence the mirror direction turns by twice the tilt.
  auto in_plane = smooth;
  in_plane.distribution.values.set("mean_slope", Vec2{0.37, 0});
  const auto figure = compute(figure_of(
      {panel_of("p", swept("theta_i", -1.5, 1.5), {{"s", term("brdf", in_plane, {{"theta_o", -0.2}}), {}}})}));
  const auto& series = figure.panels.at(0).series.at(0);
  const auto top = std::ranges::max_element(series.y) - series.y.begin();
  CHECK(series.x.at(static_cast<std::size_t>(top)) == doctest::Approx(2 * normal + 0.2).epsilon(1e-2));
}

TEST_CASE("figures: each series is as fine as the range of its panel asks for") {
  const auto x = swept("theta_m", 0, 1.5);
  const auto small = term("d", material_of("ggx", 0.9)), large = term("d", material_of("ggx", 0.02));
  const auto alone = compute(figure_of({panel_of("p", x, {{"s", small, {}}})}));
  const auto beside = compute(figure_of({panel_of("p", x, {{"s", small, {}}, {"l", large, {}}})}));
  CHECK(alone.panels.at(0).series.at(0).x.size() > 20);
  CHECK(beside.panels.at(0).series.at(0).x.size() < 10);
}

TEST_CASE("figures: integrals that are constant are drawn with two points, others truly") {
  const auto figure =
      compute(figure_of({panel_of("p", swept("theta_o", 0, 1.5), {{"w", term("weak_furnace", rough), {}}}),
                         panel_of("q", swept("theta_o", 0, 1.5), {{"f", term("furnace", rough), {}}})}));
  CHECK(figure.panels.at(0).series.at(0).x.size() == 2);
  const auto& furnace = figure.panels.at(1).series.at(0);
  CHECK(furnace.x.size() > 5);
  CHECK(furnace.x.size() < 100);
  for (const double theta : {0.21, 0.77, 1.33})
    CHECK(
        interpolated(furnace, theta) ==
        doctest::Approx(compute_or_throw(Integral::furnace, build(rough), from_angles(theta, 0), 1e-9)).epsilon(1e-3));
}

TEST_CASE("figures: grids of heat maps, x fastest, at the centres of cells") {
  auto panel = panel_of("p", swept("theta_o", 0, 1), {{"", term("g1", material_of("beckmann", 1, "v_cavity")), {}}});
  panel.y = swept("theta_m", -1, 1);
  panel.value = Axis{};
  panel.contours = {{"edge", 0.999999999}};
  auto description = figure_of({panel}, Kind::heatmap);
  description.cells = 8;
  const auto figure = compute(description);
  const auto& grid = figure.panels.at(0).grid.value();
  REQUIRE(grid.x.size() == 8);
  REQUIRE(grid.y.size() == 8);
  REQUIRE(grid.value.size() == 64);
  CHECK(grid.x[0] == doctest::Approx(1.0 / 16));
  CHECK(grid.y[0] == doctest::Approx(-1 + 1.0 / 8));
  CHECK(grid.y[7] == doctest::Approx(1 - 1.0 / 8));
  const auto material = build(material_of("beckmann", 1, "v_cavity"));
  for (std::size_t iy = 0; iy < 8; ++iy)
    for (std::size_t ix = 0; ix < 8; ++ix)
      CHECK(grid.value[iy * 8 + ix] ==
            evaluate(material, Quantity::g1, from_angles(grid.x[ix], 0), {}, from_angles(grid.y[iy], 0)));
  // Eq. 49: tan o |tan m| = 1 on the edge.
  const auto& lines = figure.panels[0].contours.at(0).lines;
  CHECK(!lines.empty());
  for (const auto& line : lines)
    for (std::size_t k = 0; k < line.x.size(); ++k)
      CHECK(std::fabs(std::tan(line.x[k]) * std::tan(line.y[k])) == doctest::Approx(1).epsilon(1e-6));

  description.panels[0].x.scale = Scale::logarithmic;
  description.panels[0].x.from = 1e-4;
  const auto columns = compute(description).panels.at(0).grid.value().x;
  CHECK(columns[1] / columns[0] == doctest::Approx(std::pow(10, 0.5)));
}

TEST_CASE("figures: errors name figure, panel and series") {
  const auto x = swept("theta_m", 0, 1);
  const SeriesDescription good{"good", term("d", rough), {}};
  const auto message = [](const FigureDescription& figure) -> std::string {
    try {
      compute(figure);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message(figure_of({panel_of("p", x, {good})})).empty());
  CHECK(message(figure_of({panel_of("p", x, {good, {"bad", term("dd", rough), {}}})}))
            .starts_with("fig, panel \"p\", series \"bad\": unknown quantity \"dd\""));
  CHECK(message(
            figure_of({panel_of("", x, {good}), panel_of("", x, {good, {"", term("g1", material_of("ggx", -1)), {}}})}))
            .starts_with("fig, panel 2, series 2: /distribution/alpha: found -1"));
  CHECK(message(figure_of({panel_of("two\nlines", x, {{"a\nb", term("g1", rough, {{"alhpa", 1.0}}), {}}})}))
            .starts_with("fig, panel \"two lines\", series \"a b\": unknown variable \"alhpa\""));
  CHECK(message(figure_of({panel_of("p", x, {{"bad", term("brdf", rough), {}}})})).find("needs omega_o") !=
        std::string::npos);
  CHECK(message(figure_of({panel_of("p", swept("alpha", -1, 1), {{"bad", term("g1", rough, {{"theta_o", 1.0}}), {}}})}))
            .starts_with("fig, panel \"p\", series \"bad\": /distribution/alpha: found -1"));
  auto map = panel_of("map", x, {{"v", term("g1", rough), {}}});
  map.x = swept("theta_o", 0, 1);
  map.y = swept("alpha", -1, 1);
  map.value = Axis{};
  auto heatmap = figure_of({map}, Kind::heatmap);
  heatmap.cells = 2;
  CHECK(message(heatmap).starts_with("fig, panel \"map\", series \"v\": "));

  auto strict = figure_of({panel_of("p", swept("theta_o", 0.5, 1), {{"s", term("furnace", rough), {}}})});
  strict.panels[0].samples = 2;
  strict.tolerance = 1e-30;
  CHECK_THROWS_WITH_AS(compute(strict), doctest::Contains("fig, panel \"p\", series \"s\": "), AccuracyError);
}
