#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "draw/figures.hpp"
#include "draw/layout.hpp"
#include "draw/markup.hpp"
#include "draw/model.hpp"

namespace {

using namespace brdfplot::plot;
using plot_tests::count;
using plot_tests::fault_of;

/// The path data of the first series in this colour.
std::string series_path(const std::string& svg, const std::string& colour) {
  const auto panel = svg.find("<g clip-path");
  const auto at = svg.find("bp-" + colour, panel);
  const auto data = svg.find(" d=\"", at) + 4;
  return svg.substr(data, svg.find('"', data) - data);
}

} // namespace

TEST_CASE("the check for well-formed markup finds faults") {
  for (const char* bad : {"<a><b></a>", "<a>", "</a>", "<a>&</a>", "<a>1 < 2</a>", "<a id=\"x\"/><b id=\"x\"/>"}) {
    CAPTURE(bad);
    CHECK(fault_of(bad) != "");
  }
  CHECK(fault_of("<a id=\"x\">&amp;<b/></a>") == "");
}

TEST_CASE("SVG of each kind is a well-formed, described, scalable document") {
  for (const auto& figure :
       {plot_tests::lines_figure(), plot_tests::polar_figure(), plot_tests::heatmap_figure(), Figure{}}) {
    CAPTURE(figure.id);
    const auto svg = to_svg(figure);
    CHECK(fault_of(svg) == "");
    CHECK(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    CHECK(count(svg, "role=\"img\"") == 1);
    CHECK(count(svg, " viewBox=\"0 0 ") == 1);
    CHECK(svg.find("<title") < svg.find("<desc"));
    CHECK(svg.find("<desc") < svg.find("<style"));
    CHECK(count(svg, "class=\"bg ") == 1);
    CHECK(count(svg, "nan") == count(svg, "-nan")); // class and variable names only
    CHECK(count(svg, "inf") == 0);
    CHECK(svg == to_svg(figure));
  }
}

TEST_CASE("SVG text is escaped and has its scripts lowered") {
  const auto svg = to_svg(plot_tests::lines_figure());
  CHECK(count(svg, "Masking G_1 &lt;of&gt; A &amp; B</title>") == 1);
  CHECK(count(svg, "How much is &quot;seen&quot;.</desc>") == 1);
  CHECK(count(svg, ">1</tspan><tspan dy=\"-4.08\"> &lt;of&gt; A &amp; B</tspan>") == 1);
}

TEST_CASE("a shared legend names each label once, and panels without common labels have their own") {
  auto figure = plot_tests::lines_figure();
  const auto shared = to_svg(figure);
  CHECK(count(shared, ">GGX<") == 1);
  CHECK(count(shared, ">Beckmann<") == 1);
  CHECK(count(shared, "class=\"bp-legend\"") == 1);

  figure.panels[1].series[0].label = "Phong";
  figure.panels[1].series[1].label = "Ward";
  const auto own = to_svg(figure);
  for (const char* label : {">GGX<", ">Beckmann<", ">Phong<", ">Ward<"}) CHECK(count(own, label) == 1);
  CHECK(count(own, "class=\"bp-legend\"") == 2);
}

TEST_CASE("a panel whose only series has no label needs no legend") {
  auto figure = plot_tests::lines_figure();
  figure.panels.resize(1);
  figure.panels[0].series.resize(1);
  figure.panels[0].series[0].label.clear();
  CHECK(count(to_svg(figure), "bp-legend") == 0);
}

TEST_CASE("the legend shows what is measured as it is drawn: a dot with a bar, a line on its band") {
  const auto in_legend = [](const std::string& svg) { return svg.substr(svg.find("class=\"bp-legend\"")); };
  const auto entries = [&](Figure figure, bool measured) {
    figure.panels.resize(1);
    auto& series = figure.panels[0].series[0];
    if (measured) series.error.assign(series.x.size(), 0.01);
    const auto legend = in_legend(to_svg(figure));
    return legend.substr(0, legend.find("class=\"bp-panel\""));
  };
  const auto parts = [](const std::string& legend) { // dots and bands; lines and bars
    return std::pair{count(legend, "class=\"bp-f-s0\""), count(legend, "<path class=\"bp-no bp-s0\"")};
  };
  CHECK(parts(entries(plot_tests::lines_figure(), true)) == std::pair{1, 2});
  CHECK(parts(entries(plot_tests::lines_figure(), false)) == std::pair{0, 1});
  CHECK(parts(entries(plot_tests::polar_figure(), true)) == std::pair{1, 1});
  CHECK(parts(entries(plot_tests::polar_figure(), false)) == std::pair{0, 1});
}

TEST_CASE("NaN breaks a line, and a point on its own is a dot") {
  auto figure = plot_tests::lines_figure();
  auto& y = figure.panels[0].series[0].y;
  CHECK(count(series_path(to_svg(figure), "s0"), "M") == 1);
  y[20] = std::nan("");
  CHECK(count(series_path(to_svg(figure), "s0"), "M") == 2);
  y[22] = std::numeric_limits<double>::infinity();
  const auto path = series_path(to_svg(figure), "s0");
  CHECK(count(path, "M") == 3);
  CHECK(count(path, "A") == 2);
}

TEST_CASE("data outside the axis are cut off") {
  auto figure = plot_tests::lines_figure();
  figure.panels[0].y.from = 0;
  figure.panels[0].y.to = 1;
  figure.panels[0].series[0].y[20] = 1e300;
  const auto svg = to_svg(figure);
  CHECK(count(series_path(svg, "s0"), "M") == 2);
  CHECK(count(svg, "clip-path=\"url(#g1-p1-clip)\"") == 1);
}

TEST_CASE("a value range is shared on demand") {
  auto figure = plot_tests::lines_figure();
  for (auto& value : figure.panels[1].series[0].y) value *= 1000;
  CHECK(count(to_svg(figure), ">1000<") == 1);
  figure.share = Share::rows;
  CHECK(count(to_svg(figure), ">1000<") == 2);
  figure.columns = 1;
  CHECK(count(to_svg(figure), ">1000<") == 1);
  figure.share = Share::all;
  CHECK(count(to_svg(figure), ">1000<") == 2);
}

TEST_CASE("ramps get a colour of their own for each place") {
  auto figure = plot_tests::lines_figure();
  figure.panels[0].series[0].ramp = 0;
  figure.panels[0].series[1].ramp = 1;
  figure.panels.resize(1);
  const auto svg = to_svg(figure);
  // Once plainly, and once with the variable of a page, where a renderer has variables.
  CHECK(count(svg, ".bp-r0{") == 2);
  CHECK(count(svg, ".bp-r20{") == 2);
  CHECK(svg.find("var(") > svg.find("@supports (fill:var("));
  CHECK(count(svg, ".bp-s0{") == 0);
}

TEST_CASE("polar plots show half a disc, or the full one for angles below the surface") {
  auto figure = plot_tests::polar_figure();
  const auto half = to_svg(figure);
  CHECK(count(half, ">−90°<") == 1);
  CHECK(count(half, ">180°<") == 0);
  CHECK(count(half, ">ω<tspan") == 2);
  figure.panels[0].arrows[0].theta = 3;
  const auto full = to_svg(figure);
  CHECK(count(full, ">180°<") == 1);
  CHECK(fault_of(full) == "");
}

TEST_CASE("heat maps merge cells of one colour and mark those without value") {
  const auto svg = to_svg(plot_tests::heatmap_figure());
  CHECK(count(svg, "class=\"bp-nan\"") == 2); // the cells and the legend
  CHECK(count(svg, ">undefined<") == 1);
  CHECK(count(svg, ">boundary<") == 1);
  const auto cells = svg.find("class=\"bp-q0\"");
  const auto data = svg.substr(cells, svg.find("/>", cells) - cells);
  CHECK(count(data, "M") == 1); // four cells of value 0
}

TEST_CASE("heat maps of both signs diverge from white") {
  auto figure = plot_tests::heatmap_figure();
  figure.panels[0].grid->value[0] = -1;
  const auto svg = to_svg(figure);
  CHECK(count(svg, "class=\"bp-d0\"") > 0);
  CHECK(count(svg, "class=\"bp-q") == 0);
  figure.panels[0].value->scale = Scale::logarithmic;
  CHECK(count(to_svg(figure), "class=\"bp-d") == 0);
}

TEST_CASE("figures without usable data are drawn all the same") {
  for (auto figure : {plot_tests::lines_figure(), plot_tests::polar_figure(), plot_tests::heatmap_figure()}) {
    for (auto& panel : figure.panels) {
      for (auto& series : panel.series) series.y.assign(series.y.size(), std::nan(""));
      if (panel.grid) panel.grid = Grid{};
      panel.y.scale = Scale::logarithmic;
    }
    CHECK(fault_of(to_svg(figure)) == "");
    for (auto& panel : figure.panels) panel.series.clear();
    CHECK(fault_of(to_svg(figure)) == "");
  }
}

TEST_CASE("a drawing says what a page needs to read it and to hide its series") {
  const auto lines = to_svg(plot_tests::lines_figure());
  CHECK(count(lines, "<g class=\"bp-panel\" data-kind=\"lines\" data-plot=\"") == 2);
  CHECK(count(lines, " data-x=\"0 1.5707963267948966 degrees linear\" data-x-label=\"θ&lt;sub&gt;o&lt;/sub&gt;\"") ==
        2);
  CHECK(count(lines, "<g class=\"bp-entry\" data-key=\"s0.0\">") == 1);
  CHECK(count(lines, " data-key=\"s0.0\"") == 3); // and a path in each panel
  const auto map = to_svg(plot_tests::heatmap_figure());
  CHECK(count(map, " data-panel=\"\" data-columns=\"x,y\"") == 1);
  CHECK(count(map, "<g class=\"bp-entry\">") == 1); // cells without value belong to no series
  CHECK(count(to_svg(plot_tests::polar_figure()), "data-kind=\"polar\"") == 1);
}

TEST_CASE("on paper text keeps its size, and panels stand in as many columns as have room") {
  Layout paper;
  paper.width_mm = 84;
  const auto figure = plot_tests::lines_figure();
  const auto svg = to_svg(figure, paper);
  CHECK(fault_of(svg) == "");
  CHECK(svg.find(" width=\"84mm\" height=\"") != std::string::npos);
  CHECK(svg.find(" viewBox=\"0 0 357.17 ") != std::string::npos);
  const auto left_of = [&](const std::string& drawing, int panel) {
    std::size_t at = 0;
    for (int k = 0; k <= panel; ++k) at = drawing.find("data-plot=\"", at) + 11;
    return std::stod(drawing.substr(at));
  };
  CHECK(left_of(to_svg(figure), 1) > left_of(to_svg(figure), 0));
  CHECK(left_of(svg, 1) == left_of(svg, 0)); // below it
  CHECK(count(svg, "font-size=\"12\"") > 0);
  paper.font_pt = 4;
  CHECK(left_of(to_svg(figure, paper), 1) > left_of(to_svg(figure, paper), 0));
  paper.title = false;
  CHECK(count(to_svg(figure, paper), "bp-title") == 0);
  CHECK(count(to_svg(figure, paper), "Masking G_1 &lt;of&gt; A &amp; B</title>") == 1); // for those who do not see it
}

TEST_CASE("a shared bar stands where it does, whatever room there is") {
  auto figure = plot_tests::heatmap_figure();
  for (int k = 0; k < 3; ++k) figure.panels.push_back(figure.panels[0]);
  figure.panels[2].grid->value[0] = figure.panels[3].grid->value[0] = 7;
  figure.columns = 2;
  figure.share = Share::rows;
  Layout paper;
  paper.width_mm = 84;
  const auto bars = [](const std::string& svg) { return count(svg, ">v</text>"); };
  CHECK(bars(to_svg(figure)) == 2);
  CHECK(bars(to_svg(figure, paper)) == 4); // one column: each row is one panel
}

TEST_CASE("a label of several parts begins where it has to: some renderers anchor each part by itself") {
  const auto svg = to_svg(plot_tests::lines_figure());
  for (std::size_t at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at + 1)) {
    const auto text = svg.substr(at, svg.find("</text>", at) - at);
    CAPTURE(text);
    CHECK((text.find("<tspan") == std::string::npos || text.find("text-anchor") == std::string::npos));
  }
}

TEST_CASE("labels over lines have a box under them, no outline: renderers that paint it over the text hide the text") {
  auto figure = plot_tests::polar_figure();
  figure.panels[0].arrows[0].theta = 3; // a full disc, whose labels lie in it
  const auto svg = to_svg(figure);
  CHECK(count(svg, "paint-order") == 0);
  CHECK(count(svg, "<rect class=\"bp-bg bp-veil\"") > 3);
}
