#include "config/load.hpp"
#include "temp_files.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace brdfplot;
using plot::Expression;
using test::TempFolder;

constexpr double degree = std::numbers::pi / 180;

/// A figure of one panel; `panel` and `rest` are further keys.
std::string figure_text(const std::string& panel, const std::string& rest = "") {
  return R"({"id": "f", "kind": "lines", "title": "T", "caption": "C",
    "material": {"distribution": {"type": "ggx", "alpha": 0.5}},
    "x": {"variable": "theta_m", "from": 0, "to": "60deg", "unit": "degrees"}, )" +
         rest + R"("panels": [{)" + panel + "}]}";
}

plot::FigureDescription load(const std::string& text) {
  const TempFolder folder;
  return config::load_figure(folder.write("f.json", text)).figure;
}

/// The number that a term has for a variable: what was set last counts.
double setting(const plot::Term& term, const std::string& variable) {
  double value = plot::automatic;
  for (const auto& one : term.at)
    if (one.variable == variable) value = std::get<double>(one.value);
  return value;
}

} // namespace

TEST_CASE("figures: keys and their defaults") {
  const auto figure = load(figure_text(R"("series": [{"quantity": "d"}])"));
  CHECK(figure.id == "f");
  CHECK(figure.title == "T");
  CHECK(figure.caption == "C");
  CHECK(figure.kind == plot::Kind::lines);
  CHECK(figure.columns == 1);
  CHECK(figure.share == plot::Share::none);
  CHECK(figure.tolerance == 1e-7);
  const auto& panel = figure.panels.at(0);
  CHECK(panel.title.empty());
  CHECK(panel.x.column == "theta_m");
  CHECK(panel.x.label == "theta_m");
  CHECK(panel.x.unit == plot::Unit::degrees);
  CHECK(panel.x.scale == plot::Scale::linear);
  CHECK(panel.x.to == doctest::Approx(60 * degree));
  CHECK(panel.y.column == "value");
  CHECK(std::isnan(panel.y.from));
  CHECK(panel.samples == 0);
  CHECK(panel.series.at(0).label.empty());
  CHECK(panel.series[0].value.term.quantity == "d");
  CHECK(panel.series[0].value.term.material.name == "f");
}

TEST_CASE("figures: a channel comes from figure, panel, series and operand, or of for_each") {
  const auto channel = [](const Expression& one) {
    std::string name;
    for (const auto& set : one.term.at)
      if (set.variable == "channel") name = std::get<std::string>(set.value);
    return name;
  };
  const auto figure = load(figure_text(
      R"("channel": "g", "series": [
          {"quantity": "fresnel"},
          {"quantity": "fresnel", "channel": "b"},
          {"difference": [{"quantity": "fresnel", "channel": "luminance"}, {"quantity": "fresnel"}]},
          {"quantity": "fresnel", "label": "in {channel}", "for_each": {"variable": "channel", "values": ["r", "b"]}},
          {"quantity": "d"}])",
      R"("channel": "r", "at": {"theta_o": 0}, )"));
  const auto& series = figure.panels.at(0).series;
  REQUIRE(series.size() == 6);
  CHECK(channel(series[0].value) == "g");
  CHECK(channel(series[1].value) == "b");
  CHECK(channel(series[2].value.operands.at(0)) == "luminance");
  CHECK(channel(series[2].value.operands.at(1)) == "g");
  CHECK(channel(series[3].value) == "r");
  CHECK(channel(series[4].value) == "b");
  CHECK(series[4].label == "in b");
}

TEST_CASE("figures: what is fixed comes from figure, panel, series and operand, the inner one last") {
  const auto figure = load(figure_text(
      R"("at": {"theta_o": 2, "phi_o": 0.2}, "series": [
          {"quantity": "g1"},
          {"quantity": "g1", "at": {"theta_o": 3, "phi_m": "30deg"}},
          {"difference": [{"quantity": "g1", "at": {"theta_o": 4}}, {"quantity": "g1"}], "at": {"phi_o": 0.3}}])",
      R"("at": {"theta_o": 1, "alpha": 0.25}, )"));
  const auto& series = figure.panels.at(0).series;
  REQUIRE(series.size() == 3);
  CHECK(setting(series[0].value.term, "theta_o") == 2);
  CHECK(setting(series[0].value.term, "alpha") == 0.25);
  CHECK(setting(series[1].value.term, "theta_o") == 3);
  CHECK(setting(series[1].value.term, "phi_m") == doctest::Approx(30 * degree));
  CHECK(setting(series[1].value.term, "phi_o") == 0.2);
  const auto& difference = series[2].value;
  CHECK(difference.operation == Expression::Operation::difference);
  REQUIRE(difference.operands.size() == 2);
  CHECK(setting(difference.operands[0].term, "theta_o") == 4);
  CHECK(setting(difference.operands[1].term, "theta_o") == 2);
  CHECK(setting(difference.operands[1].term, "phi_o") == 0.3);
}

TEST_CASE("figures: expressions nest") {
  const auto figure = load(figure_text(
      R"("series": [{"absolute": {"ratio": [{"difference": [{"quantity": "d"}, {"quantity": "d_cos"}]},
                                            {"quantity": "d"}]}}])"));
  const auto& absolute = figure.panels.at(0).series.at(0).value;
  CHECK(absolute.operation == Expression::Operation::absolute);
  const auto& ratio = absolute.operands.at(0);
  CHECK(ratio.operation == Expression::Operation::ratio);
  CHECK(ratio.operands.at(0).operation == Expression::Operation::difference);
  CHECK(ratio.operands.at(0).operands.at(1).term.quantity == "d_cos");
  CHECK(ratio.operands.at(1).term.quantity == "d");
}

TEST_CASE("figures: materials by name, given in place, and the nearer one counts") {
  const auto figure = load(figure_text(
      R"("material": "other", "series": [{"quantity": "d"}, {"quantity": "d", "material": "rough"},
          {"quantity": "d", "material": {"name": "own", "distribution": {"type": "phong", "exponent": 9}}},
          {"ratio": [{"quantity": "d", "material": "rough"}, {"quantity": "d"}], "material": "other"}])",
      R"("materials": {"rough": {"name": "R", "distribution": {"type": "ggx", "alpha": 1}},
                       "other": {"name": "O", "distribution": {"type": "beckmann", "alpha": 1}}}, )"));
  const auto& series = figure.panels.at(0).series;
  CHECK(series.at(0).value.term.material.name == "O");
  CHECK(series.at(1).value.term.material.name == "R");
  CHECK(series.at(2).value.term.material.name == "own");
  CHECK(series.at(3).value.operands.at(0).term.material.name == "R");
  CHECK(series.at(3).value.operands.at(1).term.material.name == "O");
}

TEST_CASE("figures: for_each makes panels and series, arrays every combination, and {variable} their names") {
  const auto figure = load(figure_text(
      R"("title": "{masking}, θ_o = {theta_o}", "for_each": [
           {"variable": "theta_o", "values": ["60deg", " 7.5 deg ", 0.5, "1rad"]},
           {"variable": "masking", "values": ["smith", "v_cavity"], "labels": ["Smith", "V"]}],
         "series": [{"label": "{alpha} at {theta_o}", "quantity": "g1",
                     "for_each": {"variable": "alpha", "values": [0.1, 1, 1e-6]}}])"));
  REQUIRE(figure.panels.size() == 8);
  CHECK(figure.panels[0].title == "Smith, θ_o = 60°");
  CHECK(figure.panels[1].title == "V, θ_o = 60°");
  CHECK(figure.panels[2].title == "Smith, θ_o = 7.5°");
  CHECK(figure.panels[4].title == "Smith, θ_o = 0.5");
  CHECK(figure.panels[7].title == "V, θ_o = 1rad");
  const auto& series = figure.panels[3].series;
  REQUIRE(series.size() == 3);
  CHECK(series[0].label == "0.1 at 7.5°");
  CHECK(series[1].label == "1 at 7.5°");
  CHECK(series[2].label == "1e-06 at 7.5°");
  CHECK(setting(series[1].value.term, "alpha") == 1);
  CHECK(setting(series[1].value.term, "theta_o") == doctest::Approx(7.5 * degree));
  CHECK(std::get<std::string>(series[1].value.term.at[1].value) == "v_cavity");
}

TEST_CASE("figures: families of five numbers and more have their places in a ramp") {
  const auto ramps = [](const std::string& values) {
    std::vector<double> out;
    const auto figure =
        load(figure_text(R"("at": {"theta_o": 1}, "series": [{"quantity": "g1", "for_each": )" + values + "}]"));
    for (const auto& series : figure.panels.at(0).series) out.push_back(series.ramp.value_or(-1));
    return out;
  };
  using Ramps = std::vector<double>;
  CHECK(ramps(R"({"variable": "alpha", "values": [0.1, 0.2, 0.3, 0.4, 1]})") == Ramps{0, 0.25, 0.5, 0.75, 1});
  CHECK(ramps(R"({"variable": "theta_o", "values": ["0deg", "20deg", "40deg", "60deg", "80deg"]})") ==
        Ramps{0, 0.25, 0.5, 0.75, 1});
  CHECK(ramps(R"({"variable": "alpha", "values": [0.1, 0.2, 0.3, 0.4]})") == Ramps(4, -1));
  CHECK(ramps(R"({"variable": "masking", "values": ["smith", "v_cavity", "implicit", "kelemen", "schlick_smith"]})") ==
        Ramps(5, -1));
  CHECK(ramps(R"([{"variable": "alpha", "values": [0.1, 0.2, 0.3, 0.4, 1]}, {"variable": "phi_o", "values": [0]}])") ==
        Ramps(5, -1));
}

TEST_CASE("figures: a panel's axis replaces single keys of the figure's") {
  const auto figure = load(figure_text(
      R"("x": {"to": 1, "label": "m", "samples": 7}, "y": {"scale": "log", "from": 1e-3}, "series": [{"quantity": "d"}])",
      R"("y": {"label": "D", "to": 10}, )"));
  const auto& panel = figure.panels.at(0);
  CHECK(panel.x.from == 0);
  CHECK(panel.x.to == 1);
  CHECK(panel.x.label == "m");
  CHECK(panel.x.unit == plot::Unit::degrees);
  CHECK(panel.samples == 7);
  CHECK(panel.y.label == "D");
  CHECK(panel.y.scale == plot::Scale::logarithmic);
  CHECK(panel.y.from == 1e-3);
  CHECK(panel.y.to == 10);
  CHECK(load(figure_text(R"("series": [{"quantity": "d"}], "x": {"samples": 12.0})")).panels.at(0).samples == 12);
}

TEST_CASE("figures: heat maps with contours, polar plots with arrows") {
  const auto map = load(R"({"id": "f", "kind": "heatmap", "title": "T", "caption": "C", "cells": 8,
    "material": {"distribution": {"type": "ggx", "alpha": 0.5}}, "value": {"label": "G", "from": 0},
    "x": {"variable": "theta_o", "from": 0, "to": 1}, "y": {"variable": "alpha", "from": 0.1, "to": 1, "scale": "log"},
    "panels": [{"series": [{"quantity": "g1"}], "contours": [{"label": "half", "level": 0.5}]}]})");
  CHECK(map.cells == 8);
  CHECK(map.panels.at(0).y.column == "alpha");
  CHECK(map.panels[0].value.value().label == "G");
  CHECK(map.panels[0].contours.at(0).level == 0.5);

  const auto polar = load(R"({"id": "f", "kind": "polar", "title": "T", "caption": "C",
    "material": {"distribution": {"type": "ggx", "alpha": 0.5}}, "x": {"variable": "theta_i", "from": -1, "to": 1},
    "panels": [{"series": [{"quantity": "brdf"}], "arrows": ["omega_o", "mirror"],
                "for_each": {"variable": "theta_o", "values": ["30deg"]}}]})");
  const auto& arrows = polar.panels.at(0).arrows;
  REQUIRE(arrows.size() == 2);
  CHECK(arrows[0].label == "ω_o");
  CHECK(arrows[0].theta == doctest::Approx(30 * degree));
  CHECK(!arrows[0].incoming);
  CHECK(arrows[1].theta == doctest::Approx(-30 * degree));
}
