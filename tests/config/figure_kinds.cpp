#include "config/load.hpp"
#include "draw/model.hpp"
#include "draw/style.hpp"
#include "figure/description.hpp"
#include "temp_files.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace brdfplot;
using test::contains;
using test::error_of;
using test::TempFolder;

const std::string ggx = R"("material": {"distribution": {"type": "ggx", "alpha": 0.5}}, )";
const std::string gold = R"("material": {"name": "gold", "distribution": {"type": "ggx", "alpha": 0.3},
  "fresnel": {"type": "schlick", "f0": [1, 0.7, 0.3]}}, )";

/// A figure with these keys, and its panels.
std::string figure_text(const std::string& keys, const std::string& panels) {
  return R"({"id": "f", "kind": "lines", "title": "T", "caption": "C", )" + keys + R"("panels": [)" + panels + "]}";
}

const std::string g1_panel = R"({"title": "curve", "x": {"variable": "theta_o", "from": 0, "to": "89deg"},
  "series": [{"quantity": "g1", "at": {"theta_m": 0}}]})";

std::string lobe_panel(const std::string& series, const std::string& at = R"("theta_o": "60deg")") {
  return R"({"title": "lobe", "kind": "polar", "at": {)" + at +
         R"(}, "x": {"variable": "theta_i", "from": "-90deg", "to": "90deg"}, "series": [)" + series + "]}";
}

plot::FigureDescription load(const std::string& text) {
  const TempFolder folder;
  return config::load_figure(folder.write("f.json", text)).figure;
}

std::string error_in(const std::string& text) {
  const TempFolder folder;
  const auto path = folder.write("f.json", text);
  return error_of(folder, 2, [&] { config::load_figure(path); });
}

std::vector<std::string> labels_of(const plot::PanelDescription& panel) {
  std::vector<std::string> labels;
  for (const auto& series : panel.series) labels.push_back(series.label);
  return labels;
}

using Labels = std::vector<std::string>;

} // namespace

TEST_CASE("figures: panels of every kind in one figure") {
  const std::string heatmap =
      R"({"title": "map", "kind": "heatmap", "at": {"theta_m": 0}, "series": [{"quantity": "g1"}],
    "x": {"variable": "theta_o", "from": 0, "to": 1}, "y": {"variable": "alpha", "from": 0.1, "to": 1}})";
  const std::string profile = R"({"title": "cut", "kind": "profile", "profile": {"surface": {"type": "flat"}}})";
  const std::string sphere = R"({"title": "ball", "kind": "spheres", "sphere": {"pixels": 16, "lights": [
    {"type": "directional", "theta": "30deg", "irradiance": 3}]}})";
  const auto described = load(figure_text(ggx + R"("cells": 4, "columns": 2, "x": {"unit": "degrees"}, )",
                                          g1_panel + "," + lobe_panel(R"({"quantity": "brdf"})") + "," + heatmap + "," +
                                              sphere + "," + profile));
  CHECK(plot::kind_in(described, described.panels[0]) == plot::Kind::lines);
  CHECK(plot::kind_in(described, described.panels[1]) == plot::Kind::polar);
  CHECK(plot::kind_in(described, described.panels[2]) == plot::Kind::heatmap);
  CHECK(plot::kind_in(described, described.panels[3]) == plot::Kind::spheres);
  CHECK(plot::kind_in(described, described.panels[4]) == plot::Kind::profile);
  const plot::Figure figure = plot::compute(described);
  const std::string svg = plot::to_svg(figure), csv = plot::to_csv(figure);
  for (const std::string part : {"bp-line", "bp-cells", "data:image/png", ">−90°<"})
    CHECK_MESSAGE(contains(svg, part), part);
  for (const std::string row : {"panel,series,theta_o,theta_i,alpha,position,x,value\n", "\ncurve,,0,,,,,1\n",
                                "\nlobe,,,-", "\nmap,,0.125,,0.21250000000000002,,,", "\nball,", "\ncut,"})
    CHECK_MESSAGE(contains(csv, row), row);
}

TEST_CASE("figures: a panel has what its kind draws") {
  const auto check = [](const std::string& panel, const std::string& what) {
    const std::string error = error_in(figure_text(ggx, panel));
    CHECK_MESSAGE(contains(error, what), error);
  };
  check(R"({"kind": "spheres", "series": [{"quantity": "d"}]})", "/panels/0: a sphere has \"sphere\", not \"series\"");
  check(R"({"kind": "profile", "series": [{"quantity": "d"}]})", "/panels/0: a profile has \"profile\"");
  check(R"({"sphere": {}})", "only a panel of kind \"spheres\" has \"sphere\"");
  check(R"({"kind": "rose", "series": [{"quantity": "d"}]})", "/panels/0/kind");
}

TEST_CASE("figures: the autocorrelation of a surface's heights is a curve, beside the law that it was made with") {
  const auto panel = [](const std::string& surface, const std::string& keys = "", const std::string& to = "16") {
    return R"({"title": "c", "kind": "lines", "x": {"variable": "distance", "from": 0, "to": )" + to +
           R"(}, "autocorrelation": {"surface": )" + surface + "}" + keys + "}";
  };
  const std::string gaussian =
      R"({"type": "gaussian", "alpha": 0.5, "samples": 256, "correlation_length": 6, "autocorrelation": "exponential"})";
  const std::string uncorrelated = R"({"type": "uncorrelated", "alpha": 0.5})";
  const auto figure = plot::compute(load(figure_text("", panel(gaussian) + "," + panel(uncorrelated))));
  REQUIRE(figure.panels.at(0).series.size() == 2);
  const auto& measured = figure.panels[0].series[0];
  const auto& law = figure.panels[0].series[1];
  REQUIRE(measured.x.size() == 17);
  CHECK(measured.y[0] == 1);
  CHECK(measured.y[6] == doctest::Approx(std::exp(-1)).epsilon(0.2)); // one surface of some 40^2 lengths
  CHECK(law.label == "exp(−d/L)");
  CHECK(law.y.back() == doctest::Approx(std::exp(-16.0 / 6)));
  REQUIRE(figure.panels.at(1).series.size() == 1); // it has no other law than 1 at 0
  CHECK(std::fabs(figure.panels[1].series[0].y[1]) < 0.05);
  CHECK(contains(plot::to_csv(figure), "panel,series,distance,value\nc,measured,0,1\n"));

  const auto check = [&](const std::string& text, const std::string& what) {
    const std::string error = error_in(figure_text("", text));
    CHECK_MESSAGE(contains(error, what), error);
  };
  check(panel(R"({"type": "v_cavity", "alpha": 0.5})"), "known of gaussian, ggx and uncorrelated");
  check(panel(gaussian, R"(, "at": {"theta_o": 0})"), "/panels/0/at: an autocorrelation has no \"at\"");
  check(panel(gaussian, "", "3000"), "accepted: distances within [0, 2000]");
  check(R"({"kind": "polar", "autocorrelation": {"surface": )" + gaussian + "}}", "only a panel of kind \"lines\"");
  check(R"({"x": {"variable": "theta_o", "from": 0, "to": 1}, "autocorrelation": {"surface": )" + gaussian + "}}",
        "accepted for an autocorrelation: distance");
}

TEST_CASE("figures: arrows stand on the viewer's side, also where the light's azimuth is opposite to his") {
  const auto angles = [](const std::string& at) {
    std::vector<double> out;
    const std::string panel = lobe_panel(R"({"quantity": "brdf"})", at);
    const auto figure =
        load(figure_text(ggx, panel.substr(0, panel.size() - 1) + R"(, "arrows": ["omega_o", "mirror"]})"));
    for (const auto& arrow : figure.panels[0].arrows) out.push_back(std::round(arrow.theta * 180 / 3.14159265358979));
    return out;
  };
  CHECK(angles(R"("theta_o": "60deg")") == std::vector<double>{60, -60});
  CHECK(angles(R"("theta_o": "60deg", "phi_o": "20deg", "phi_i": "phi_o")") == std::vector<double>{60, -60});
  CHECK(angles(R"("theta_o": "60deg", "phi_i": "phi_o+180deg")") == std::vector<double>{-60, 60});
}

TEST_CASE("figures: rgb draws what is coloured thrice, in the colours of its channels") {
  const std::string lobe = R"({"quantity": "brdf"})";
  const auto figure = load(figure_text(gold + R"("channel": "rgb", )", g1_panel + "," + lobe_panel(lobe)));
  CHECK(labels_of(figure.panels[0]) == Labels{""});
  CHECK_FALSE(figure.panels[0].series[0].hue);
  CHECK(labels_of(figure.panels[1]) == Labels{"r", "g", "b"});
  CHECK(figure.panels[1].series[0].hue == plot::Hue::red);
  CHECK(figure.panels[1].series[2].hue == plot::Hue::blue);
  const auto computed = plot::compute(figure);
  const std::string svg = plot::to_svg(computed);
  for (const char* colour : {"bp-s1", "bp-s2", "bp-s0"}) CHECK(contains(svg, std::string("bp-line ") + colour));

  // Dashes tell materials apart; a grey one is drawn once; labels say the channel where they do not have it.
  const auto several = load(figure_text(gold + R"("materials": {"tin": {"distribution": {"type": "ggx", "alpha": 0.3}},
        "copper": {"distribution": {"type": "ggx", "alpha": 0.3}, "fresnel": {"type": "schlick", "f0": [0.9, 0.6, 0.5]}}}, )",
                                        lobe_panel(R"({"quantity": "brdf", "channel": "rgb", "label": "gold"},
        {"quantity": "brdf", "channel": "rgb", "material": "copper", "label": "{channel} of copper"},
        {"quantity": "brdf", "channel": "rgb", "material": "tin", "label": "tin"})")));
  CHECK(labels_of(several.panels[0]) ==
        Labels{"gold, r", "gold, g", "gold, b", "r of copper", "g of copper", "b of copper", "tin"});
  const auto drawn = plot::compute(several).panels[0].series;
  CHECK(drawn[0].style == 0);
  CHECK(drawn[2].style == 0);
  CHECK(drawn[3].style == 1);
  CHECK(drawn[5].hue == plot::Hue::blue);
  CHECK_FALSE(drawn[6].hue);
  CHECK(drawn[6].style == 6); // ink: blue, and red with dashes, are the channels'
  const auto one_grey =
      load(figure_text(gold + R"("materials": {"tin": {"distribution": {"type": "ggx", "alpha": 0.3}}}, )",
                       lobe_panel(R"({"quantity": "brdf", "channel": "rgb", "label": "gold"},
        {"quantity": "brdf", "material": "tin", "label": "tin"}, {"quantity": "g1", "at": {"theta_m": 0}, "label": "G1"})")));
  std::vector<plot::Look> looks;
  for (const auto& one : plot::compute(one_grey).panels[0].series)
    if (!one.hue) looks.push_back(plot::look_of(one.style, one.ramp, 0));
  CHECK(looks.size() == 2);
  for (const auto& look : looks)
    for (const char* channel : {"s0", "s1", "s2"}) CHECK(look.colour != channel);

  const auto looped = load(figure_text(
      gold, lobe_panel(R"({"quantity": "brdf", "for_each": {"variable": "channel", "values": ["b", "luminance"]}})")));
  CHECK(looped.panels[0].series[0].hue == plot::Hue::blue);
  CHECK_FALSE(looped.panels[0].series[1].hue);
  CHECK(contains(error_in(figure_text(gold, lobe_panel(R"({"absolute": {"quantity": "brdf", "channel": "rgb"}})"))),
                 "/panels/0/series/0/absolute/channel"));
}

TEST_CASE("figures: an angle follows another") {
  const auto value = [](const std::string& phi_i, const std::string& sweep = "phi_o") {
    const auto figure = load(figure_text(
        R"("material": {"distribution": {"type": "ggx", "alpha_x": 0.2, "alpha_y": 0.6}}, )",
        R"({"at": {"theta_o": "40deg", "theta_i": "50deg", "phi_i": )" + phi_i + R"(}, "x": {"variable": ")" + sweep +
            R"(", "from": 0, "to": "90deg", "samples": 3}, "series": [{"quantity": "brdf"}]})"));
    return plot::compute(figure).panels[0].series[0].y;
  };
  const auto along = value(R"("phi_o+180deg")"), other_way = value(R"("phi_o - 180deg")"), fixed = value("\"180deg\"");
  REQUIRE(along.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) CHECK(along[k] == doctest::Approx(other_way[k]).epsilon(1e-12));
  CHECK(along[0] == doctest::Approx(fixed[0]).epsilon(1e-12));
  CHECK(along[2] != doctest::Approx(fixed[2]).epsilon(0.1));
  CHECK(along[2] == doctest::Approx(value("\"270deg\"")[2]).epsilon(1e-12));
  CHECK(value("\"-phi_o\"")[1] == doctest::Approx(value("\"-45deg\"")[1]).epsilon(1e-12));
}

TEST_CASE("figures: an angle that follows nothing") {
  const auto check = [](const std::string& at, const std::string& place, const std::string& what) {
    const std::string error = error_in(figure_text(ggx, lobe_panel(R"({"quantity": "brdf"})", at)));
    CHECK_MESSAGE(contains(error, "/panels/0/" + place), error);
    CHECK_MESSAGE(contains(error, what), error);
  };
  check(R"("theta_o": 1, "phi_i": "phi_0+180deg")", "at/phi_i", "did you mean \"phi_o\"?");
  check(R"("theta_o": 1, "phi_i": "phi_o+180")", "at/phi_i", "or another angle, as \"phi_o+180deg\"");
  check(R"("theta_o": 1, "phi_i": "phi_o+x")", "at/phi_i", "accepted: a number");
  check(R"("theta_o": 1, "alpha": "phi_o")", "at/alpha", "theta and phi of o, i and m may follow each other");
  check(R"("theta_o": "theta_m")", "series/0", "\"theta_o\" follows \"theta_m\", which is not set");
  check(R"("theta_o": "phi_o", "phi_o": "theta_o")", "at/phi_o", "follows itself");
}

TEST_CASE("figures: labels of series without one are made from what differs") {
  const auto labels = [](const std::string& series) {
    return labels_of(
        load(
            figure_text(
                gold +
                    R"("channel": "r", "materials": {"flat_paint": {"distribution": {"type": "beckmann", "alpha": 0.5}}}, )",
                lobe_panel(series)))
            .panels[0]);
  };
  CHECK(labels(R"({"quantity": "brdf"})") == Labels{""});
  CHECK(labels(R"({"quantity": "brdf"}, {"quantity": "brdf_cos"})") == Labels{"brdf", "brdf\\_cos"});
  CHECK(labels(R"({"quantity": "brdf"}, {"quantity": "brdf", "material": "flat_paint"})") ==
        Labels{"gold", "flat\\_paint"});
  CHECK(labels(R"({"quantity": "brdf", "for_each": {"variable": "alpha", "values": [0.1, 0.3]}})") ==
        Labels{"α = 0.1", "α = 0.3"});
  CHECK(labels(R"({"quantity": "brdf", "for_each": [{"variable": "theta_o", "values": ["10deg", "60deg"]},
    {"variable": "phi_i", "values": [0, "-phi_o", "phi_o-30deg"]}]})")[5] == "θ_o = 60°, φ_i = φ_o − 30°");
  CHECK(labels(R"({"quantity": "brdf"}, {"quantity": "brdf", "at": {"masking": "v_cavity"}})") ==
        Labels{"", "v\\_cavity"});
  CHECK(labels(R"({"quantity": "brdf"}, {"quantity": "brdf", "label": "mine", "at": {"alpha": 0.7}})") ==
        Labels{"", "mine"});
  CHECK(
      labels(R"({"quantity": "brdf"}, {"ratio": [{"quantity": "brdf"}, {"quantity": "brdf", "at": {"alpha": 1}}]})") ==
      Labels{"", "ratio, α = 1"});
  CHECK(labels(R"({"quantity": "brdf"}, {"quantity": "brdf_cos", "label": ""})") == Labels{"brdf", ""});
}

TEST_CASE("figures: what is swept is not fixed, but within an operand") {
  const auto check = [](const std::string& keys, const std::string& panel, const std::string& place) {
    const std::string error = error_in(figure_text(ggx + keys, panel));
    CHECK_MESSAGE(contains(error, "f.json: " + place + ": "), error);
    CHECK_MESSAGE(contains(error, "is swept by /panels/0/x; accepted: one of the two"), error);
  };
  const std::string x = R"("x": {"variable": "theta_o", "from": 0, "to": 1}, )";
  check(R"("at": {"theta_o": 1}, )", g1_panel, "/at/theta_o");
  check("", "{" + x + R"("at": {"theta_o": 1}, "series": [{"quantity": "lambda"}]})", "/panels/0/at/theta_o");
  check("", "{" + x + R"("series": [{"quantity": "lambda", "at": {"theta_o": 1}}]})", "/panels/0/series/0/at/theta_o");
  check("", "{" + x + R"("series": [{"quantity": "lambda", "at": {"a": 1}}]})", "/panels/0/series/0/at/a");
  check("", "{" + x + R"("series": [{"quantity": "lambda", "for_each": {"variable": "theta_o", "values": [1]}}]})",
        "/panels/0/series/0/for_each/values/0");
  const auto figure = load(figure_text(
      ggx,
      "{" + x + R"("series": [{"ratio": [{"quantity": "lambda"}, {"quantity": "lambda", "at": {"theta_o": 1}}]}]})"));
  const auto series = plot::compute(figure).panels[0].series[0];
  CHECK(series.y.back() == doctest::Approx(1).epsilon(1e-12));
}
