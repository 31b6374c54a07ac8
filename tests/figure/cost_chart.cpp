#include "figure/cost_chart.hpp"

#include "draw/text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <regex>

using namespace brdfplot::plot;

namespace {

CostChart chart() {
  CostChart chart;
  chart.cost = {.label = "cost", .column = "cost"};
  chart.error = {.label = "error", .column = "error"};
  chart.points = {{"cheap", 1, 1e-1, true, "a"},
                  {"worse", 2, 2e-1, false, "b"},
                  {"good", 4, 1e-8, true, "b"},
                  {"exact", 9, 0, false, "a"},
                  {"unknown", std::nan(""), 1e-3, false, "b"}};
  return chart;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

} // namespace

TEST_CASE("cost chart: the front is a staircase, and what has no place is told of") {
  const Figure figure = cost_figure({chart()}, "chart", "Costs", "What costs what.");
  REQUIRE(figure.panels.size() == 1);
  const Panel& panel = figure.panels[0];
  const Series& front = panel.series.at(0);
  CHECK(front.y == std::vector<double>{1e-1, 1e-1, 1e-8, 1e-8});
  CHECK(front.x == std::vector<double>{1, 4, 4, panel.x.to});
  REQUIRE(panel.notes.size() == 1);
  CHECK(panel.notes[0].text == "not shown: exact (no error); unknown (cost not counted)");
  // "a" and "b" on the front, then "b" behind it, in the colour of "b".
  REQUIRE(panel.series.size() == 4);
  CHECK(panel.series[2].style == panel.series[3].style);
  CHECK(panel.series[3].names == std::vector<std::string>{"worse"});
}

TEST_CASE("cost chart: a measured cost has its spread as a line") {
  CostChart measured = chart();
  measured.points[1].cost_to = 3;
  const Figure figure = cost_figure({measured}, "chart", "", "");
  const Series& spread = figure.panels.at(0).series.at(1);
  CHECK(spread.x == std::vector<double>{2, 3});
  CHECK(spread.y == std::vector<double>{2e-1, 2e-1});
  CHECK(spread.names.empty());
}

TEST_CASE("cost chart: every name is drawn once, every group has one entry in the legend") {
  const std::string svg = to_svg(cost_figure({chart()}, "chart", "Costs", "What costs what."));
  for (const char* name : {">cheap<", ">worse<", ">good<", ">a<", ">b<", ">front<"}) {
    CAPTURE(name);
    CHECK(count(svg, name) == 1);
  }
  CHECK(count(to_csv(cost_figure({chart()}, "chart", "", "")), ",good\n") == 1);
}

TEST_CASE("cost chart: names of points that lie near each other do not cover each other") {
  CostChart crowded = chart();
  crowded.points.clear();
  for (int k = 0; k < 14; ++k)
    crowded.points.push_back({"point_" + std::to_string(k), 10 * std::pow(1.04, k), 1e-3, k == 0, "a"});
  const std::string svg = to_svg(cost_figure({crowded}, "chart", "", ""));
  CHECK(count(svg, ">point_") == 14);
  CHECK(count(svg, "<title>point_") == 0); // one that has no room
}

TEST_CASE("cost chart: points that lie on each other are one dot with their names") {
  CostChart same = chart();
  same.points = {{"p", 10, 1e-3, false, "a"}, {"q", 10, 1.001e-3, false, "a"}, {"r", 10, 1e-3, false, "b"},
                 {"s", 20, 1e-3, false, "a"}, {"t", 20, 1e-3, false, "a"},     {"u", 20, 1e-3, false, "a"}};
  const std::string svg = to_svg(cost_figure({same}, "chart", "", ""));
  for (const char* name : {">p, q<", ">r<", ">s … u<"}) CHECK(count(svg, name) == 1);
}

TEST_CASE("cost chart: names for which there is no room without crossing lines have one with it") {
  // The errors of the second factor of GGX's albedo.
  CostChart crowded = chart();
  crowded.points = {{"materialx", 52, 0.02401, false, "a"},
                    {"materialx_float", 26, 0.02401, true, "a"},
                    {"unreal", 58, 0.05564, false, "a"},
                    {"unreal_float", 29, 0.05564, false, "a"},
                    {"lazarov_2013", 48, 0.2618, false, "a"},
                    {"lazarov_2013_float", 24, 0.2618, false, "a"},
                    {"karis_2014", 36, 0.08487, false, "a"},
                    {"karis_2014_float", 18, 0.08487, true, "a"},
                    {"table_8", 88, 0.09216, false, "b"},
                    {"table_16", 88, 0.043, false, "b"},
                    {"table_32", 88, 0.02831, false, "b"},
                    {"quadrature_1e-2", 245520, 9.105e-10, true, "c"},
                    {"quadrature_1e-4", 245520, 9.105e-10, false, "c"},
                    {"quadrature_1e-6", 286440, 8.429e-10, false, "c"}};
  const std::string svg = to_svg(cost_figure({crowded}, "chart", "", ""));
  for (const CostPoint& point : crowded.points) {
    CAPTURE(point.name);
    CHECK(count(svg, point.name + "</text>") + count(svg, ">" + point.name + ", ") == 1);
  }
}

TEST_CASE("cost chart: what is said of the hidden stays on the page, however long") {
  for (std::size_t length = 1; length < 120; ++length) {
    CAPTURE(length);
    CostChart hidden = chart();
    hidden.points[4].name = "n " + std::string(length, 'w');
    const std::string svg = to_svg(cost_figure({hidden}, "chart", "", ""));
    const std::regex middle("<text class=\"bp-muted\" x=\"([0-9.]+)\"[^>]*font-size=\"([0-9.]+)\"[^>]*"
                            "text-anchor=\"middle\"[^>]*>([^<]*)</text>");
    std::size_t lines = 0;
    for (std::sregex_iterator line(svg.begin(), svg.end(), middle), end; line != end; ++line, ++lines) {
      const double x = std::stod((*line)[1]), half = text_width((*line)[3].str(), std::stod((*line)[2])) / 2;
      CHECK(x - half >= 0);
      CHECK(x + half <= 640);
    }
    CHECK(lines > 0);
  }
}
