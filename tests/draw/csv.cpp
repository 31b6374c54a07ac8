#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "draw/figures.hpp"
#include "draw/model.hpp"

namespace {

using namespace brdfplot::plot;

} // namespace

TEST_CASE("CSV of lines is tidy, with the shortest numbers") {
  Figure figure;
  Panel panel;
  panel.title = "first, \"best\"";
  panel.x.column = "theta_o";
  panel.y.column = "g1";
  panel.series.push_back({"α_{x} = 1", {0, 0.1}, {1, std::nan("")}, 0, {}});
  panel.series.push_back({"two\nlines", {1e-5}, {1.0 / 3}, 1, {}});
  figure.panels.push_back(panel);
  CHECK(to_csv(figure) == "panel,series,theta_o,g1\n"
                          "\"first, \"\"best\"\"\",α_x = 1,0,1\n"
                          "\"first, \"\"best\"\"\",α_x = 1,0.1,nan\n"
                          "\"first, \"\"best\"\"\",\"two\nlines\",1e-05,0.3333333333333333\n");
}

TEST_CASE("CSV of a heat map has its cells, not its contours") {
  CHECK(to_csv(plot_tests::heatmap_figure()) == "panel,x,y,v\n,0,0,0\n,1,0,0\n,2,0,1\n,0,1,0\n,1,1,0\n,2,1,nan\n");
}

TEST_CASE("CSV of simulated series has their standard errors, of others none") {
  Figure figure;
  Panel panel;
  panel.y.column = "energy";
  panel.series.push_back({"exact", {1}, {2}, 0, {}, {}});
  panel.series.push_back({"simulated", {1, 2}, {3, 4}, 0, {}, {0.5, 0.25}});
  figure.panels.push_back(panel);
  CHECK(to_csv(figure) ==
        "panel,series,x,energy,energy_stderr\n,exact,1,2,\n,simulated,1,3,0.5\n,simulated,2,4,0.25\n");
}

TEST_CASE("CSV of an empty figure is the header") {
  CHECK(to_csv(Figure{}) == "panel,series,x,y\n");
  Figure map;
  map.kind = Kind::heatmap;
  CHECK(to_csv(map) == "panel,x,y,value\n");
}

TEST_CASE("CSV: a column for each variable that panels sweep, and panels that are not drawn") {
  Figure figure;
  Panel first, second;
  first.x.column = "theta_o";
  second.x.column = "alpha";
  first.y.column = second.y.column = "value";
  first.series.resize(1);
  first.series[0].label = "a";
  first.series[0].x = {1};
  first.series[0].y = {2};
  second.series = first.series;
  second.series[0].label = "b";
  second.series[0].x = {3};
  second.series[0].y = {4};
  second.drawn = false;
  second.title = "hidden";
  figure.panels = {first, second};
  CHECK(to_csv(figure) == "panel,series,theta_o,alpha,value\n,a,1,,2\nhidden,b,,3,4\n");
  CHECK(to_svg(figure).find("hidden") == std::string::npos);
}
