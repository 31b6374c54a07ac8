#include <doctest/doctest.h>

#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "draw/figures.hpp"
#include "draw/markup.hpp"
#include "figure/description.hpp"

namespace {

using namespace brdfplot;
using namespace brdfplot::plot;
using plot_tests::count;

/// A figure of profiles; `with` changes each panel's.
FigureDescription figure_of(const std::vector<std::function<void(ProfileDescription&)>>& with) {
  FigureDescription figure;
  figure.id = "profiles";
  figure.kind = Kind::profile;
  for (const auto& change : with) {
    ProfileDescription profile;
    profile.surface.type = "gaussian";
    profile.surface.values.set("alpha", 0.8);
    profile.surface.values.set("samples", 64.0);
    profile.surface.values.set("correlation_length", 4.0);
    profile.omega_o = 1.1;
    profile.cells = 40;
    profile.rays = 12;
    profile.normals = 9;
    profile.mesosurface = true;
    profile.arrows = {"omega_o", "omega_g", "omega_m"};
    profile.numbers = {"g1", "projected_area", "autocorrelation"};
    change(profile);
    PanelDescription panel;
    panel.title = std::to_string(figure.panels.size());
    panel.x.column = "x";
    panel.y.column = "height";
    panel.profile = profile;
    figure.panels.push_back(panel);
  }
  return figure;
}

/// The numbers of all matches of a pattern with two groups.
std::vector<std::pair<double, double>> pairs(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::pair<double, double>> out;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it)
    out.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  return out;
}

const std::string number = "(-?[0-9.]+)";

/// Width and rise of the mesosurfaces on the page.
std::vector<std::pair<double, double>> mesosurfaces(const std::string& svg) {
  return pairs(svg, "stroke-dasharray=\"7 4\" d=\"M[-0-9. ]*l" + number + " ?(-?[0-9.]+)\"");
}

} // namespace

TEST_CASE("profiles are drawn to one scale along both axes, and to a common one where they share it") {
  auto description = figure_of({[](auto&) {}, [](auto& p) { p.stretch = 2; }, [](auto& p) { p.shear = 0.25; }});
  description.share = Share::all;
  const auto lines = mesosurfaces(to_svg(compute(description)));
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].second == 0);
  CHECK(lines[1].first == doctest::Approx(2 * lines[0].first).epsilon(1e-4));
  CHECK(lines[2].first == doctest::Approx(lines[0].first).epsilon(1e-4));
  CHECK(-lines[2].second == doctest::Approx(0.25 * lines[2].first).epsilon(1e-3));
  description.share = Share::none;
  const auto own = mesosurfaces(to_svg(compute(description)));
  CHECK(own[1].first == doctest::Approx(own[0].first).epsilon(0.01));
}

TEST_CASE("profiles: nothing stands outside of the page, whatever the directions") {
  for (const double theta : {-1.5, -0.6, 0.0, 0.4, 1.3})
    for (const int columns : {1, 2}) {
      auto description = figure_of({[&](auto& p) { p.omega_o = theta; },
                                    [&](auto& p) {
                                      p.omega_o = theta;
                                      p.projection = std::fabs(theta) < 1.4;
                                      p.point = theta < 0 ? 0 : 1;
                                    },
                                    [&](auto& p) {
                                      p.omega_o = theta;
                                      p.surface.type = "uncorrelated";
                                      p.surface.values = {};
                                      p.surface.values.set("alpha", 1.0);
                                      p.rays = 0;
                                    }});
      description.columns = columns;
      const auto svg = to_svg(compute(description));
      CAPTURE(theta);
      CAPTURE(columns);
      CHECK(plot_tests::fault_of(svg) == "");
      CHECK(count(svg, ">nan") + count(svg, "nan ") + count(svg, "inf") == 0);
      CHECK(count(svg, ">ω<tspan") >= 9);
      const auto page = pairs(svg, "viewBox=\"0 0 " + number + " " + number + "\"").at(0);
      for (const auto& pattern : {"<text[^>]* x=\"" + number + "\" y=\"" + number + "\"", "M" + number + " ?" + number})
        for (const auto& [x, y] : pairs(svg, pattern)) {
          CHECK(x >= 0);
          CHECK(x <= page.first);
          CHECK(y >= 0);
          CHECK(y <= page.second);
        }
    }
}

TEST_CASE("profiles: the CSV has the parts of the surface, each ended by an empty height, and the numbers") {
  const auto figure = compute(figure_of({[](auto&) {}}));
  const auto csv = to_csv(figure);
  CHECK(csv.starts_with("panel,series,x,height\n0,visible,"));
  CHECK(count(csv, "nan") == 0);
  CHECK(count(csv, "0,g1,,0.") == 1);
  CHECK(count(csv, "0,g1_model,,0.") == 1);
  CHECK(count(csv, "0,projected_area,,0.453596\n") == 1); // cos 1.1
  CHECK(count(csv, "0,projected_mesosurface,,0.453596\n") == 1);
  double width = 0;
  for (const auto& series : figure.panels.at(0).series)
    for (std::size_t k = 1; k < series.x.size(); ++k)
      if (!std::isnan(series.y[k]) && !std::isnan(series.y[k - 1])) width += series.x[k] - series.x[k - 1];
  CHECK(width == doctest::Approx(40)); // the parts cover what is drawn, once
  CHECK(to_csv(compute(figure_of({[](auto&) {}}))) == csv);
}

TEST_CASE("profiles: viewer and light make parts of their own") {
  const auto figure = compute(figure_of({[](auto& p) {
    p.omega_i = -1.0;
    p.numbers = {"g2"};
    p.arrows = {"omega_o", "omega_i"};
  }}));
  std::vector<std::string> labels;
  for (const auto& series : figure.panels.at(0).series) labels.push_back(series.label);
  CHECK(labels == std::vector<std::string>{"visible and lit", "visible, shadowed", "masked", "facing away"});
  REQUIRE(figure.panels[0].notes.size() == 3);
  CHECK(figure.panels[0].notes[0].value < figure.panels[0].notes[1].value);
}
