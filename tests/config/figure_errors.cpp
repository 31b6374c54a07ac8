#include "config/load.hpp"
#include "temp_files.hpp"

#include <vector>

namespace {

using namespace brdfplot;
using test::contains;
using test::error_of;
using test::TempFolder;

struct Case {
  std::string panel;   ///< keys of the panel, or nothing for one plain series
  std::string rest;    ///< further keys of the figure
  std::string pointer; ///< where the error stands
  std::string what;    ///< part of what it says
};

const std::string series = R"("series": [{"quantity": "d"}])";
const std::string with_view = R"("series": [{"quantity": "g1", "at": {"theta_o": 1}}])";
const std::string x = R"("x": {"variable": "theta_m", "from": 0, "to": 1})";
const std::string head = R"("id": "f", "kind": "lines", "title": "T", "caption": "C", )";

/// A figure; `rest` replaces the keys it names.
std::string figure_text(const Case& one) {
  const auto unless = [&](const std::string& key, const std::string& text) {
    return contains(one.rest, "\"" + key + "\":") ? "" : text + ", ";
  };
  return "{" + unless("id", R"("id": "f")") + unless("kind", R"("kind": "lines")") +
         unless("title", R"("title": "T")") + (contains(one.rest, R"("spheres")") ? "" : unless("x", x)) +
         unless("material", R"("material": {"distribution": {"type": "ggx", "alpha": 0.5}})") +
         (one.rest.empty() ? "" : one.rest + ", ") + R"("caption": "C", "panels": [{)" +
         (one.panel.empty() ? series : one.panel) + "}]}";
}

void check_all(const std::vector<Case>& cases) {
  const TempFolder folder;
  for (const auto& one : cases) {
    CAPTURE(one.panel);
    CAPTURE(one.rest);
    const auto path = folder.write("fig.json", figure_text(one));
    const std::string error = error_of(folder, 2, [&] { config::load_figure(path); });
    CAPTURE(error);
    CHECK(error.substr(0, error.find(": ", 10)) == "fig.json: " + one.pointer);
    CHECK_MESSAGE(contains(error, one.what), error);
  }
}

} // namespace

TEST_CASE("figures: simulated terms") {
  const auto walked = [](const std::string& keys, const std::string& at = R"("theta_o": 1)") {
    return R"("series": [{"quantity": "albedo", "at": {)" + at + R"(}, "simulate": {)" + keys + "}}]";
  };
  const std::string walk = R"("source": "smith_walk")";
  check_all({
      {walked(""), "", "/panels/0/series/0/simulate", "\"source\" is missing"},
      {walked(R"("source": "smith_wolk")"), "", "/panels/0/series/0/simulate/source", "did you mean \"smith_walk\"?"},
      {walked(walk + R"(, "bounces": "5")"), "", "/panels/0/series/0/simulate/bounces",
       "accepted: 1, 2, 3, 4, 2+, all"},
      {walked(walk + R"(, "samples": 1)"), "", "/panels/0/series/0/simulate/samples", "found 1"},
      {walked(walk + R"(, "facets": "dielectric")"), "", "/panels/0/series/0", "need the Fresnel term \"dielectric\""},
      {walked(walk + R"(, "facets": "diffuse")"), "", "/panels/0/series/0", "accepted: conductor, dielectric"},
      {walked(R"("source": "surface")"),
       R"("material": {"distribution": {"type": "ggx", "alpha": 0.5}, "facet": "diffuse"})", "/panels/0/series/0",
       "found \"facet_diffuse\", accepted: one term, mirror"},
      {walked(walk, R"("phi_o": 1)"), "", "/panels/0/series/0", "needs theta_o"},
      {walked(walk, R"("theta_o": 2)"), "", "/panels/0/series/0", "below the horizon"},
      {walked(walk, R"("theta_o": 1, "distribution": "phong")"), "", "/panels/0/series/0", "beckmann and ggx"},
      {R"("series": [{"quantity": "g1", "at": {"theta_o": 1}, "simulate": {"source": "smith_walk"}}])", "",
       "/panels/0/series/0", "unknown quantity of smith_walk \"g1\""},
      {walked(walk), R"("kind": "heatmap", "y": {"variable": "alpha", "from": 0.1, "to": 1})",
       "/panels/0/series/0/simulate", "a heat map is not simulated"},
  });
}

TEST_CASE("figures: channels") {
  const std::string gold =
      R"("x": {"variable": "theta_i", "from": -1, "to": 1}, "at": {"theta_o": 0.5},
         "material": {"distribution": {"type": "ggx", "alpha": 0.5}, "fresnel": {"type": "schlick", "f0": [1, 0.7, 0.3]}})";
  const auto one = [](const std::string& keys) { return R"("series": [{)" + keys + "}]"; };
  check_all({
      {one(R"("quantity": "brdf")"), gold, "/panels/0/series/0",
       R"(write which is meant: "channel": "r", "g", "b" or "luminance")"},
      {one(R"("ratio": [{"quantity": "brdf", "channel": "r"}, {"quantity": "brdf"}])"), gold,
       "/panels/0/series/0/ratio/1", "three channels"},
      {one(R"("quantity": "albedo", "simulate": {"source": "smith_walk"})"), gold, "/panels/0/series/0",
       "three channels"},
      {one(R"("quantity": "mean_theta_i", "channel": "luminance")"), gold, "/panels/0/series/0", "no luminance"},
      {one(R"("quantity": "brdf", "channel": "red")"), gold, "/panels/0/series/0/channel",
       "accepted: r, g, b, luminance"},
      {one(R"("quantity": "g2", "channel": "r")"), gold, "/panels/0/series/0/channel",
       "\"g2\" does not depend on \"channel\""},
      {one(R"("quantity": "brdf", "for_each": {"variable": "channel", "values": ["r", "x"]})"), gold,
       "/panels/0/series/0/for_each/values/1", "unknown channel \"x\""},
  });
}

TEST_CASE("figures: spheres") {
  const auto spheres = [](const std::string& keys, const std::string& material = R"("alpha": 0.5)") {
    return R"("kind": "spheres", "material": {"distribution": {"type": "ggx", )" + material + R"(}}, "sphere": {)" +
           keys + "}";
  };
  const auto lit = [](const std::string& light) { return R"("sphere": {"lights": [{)" + light + "}]}"; };
  const auto panel = [](const std::string& keys) { return R"("sphere": {)" + keys + "}"; };
  const std::string sun = R"("lights": [{"type": "directional", "theta": 0.5, "irradiance": 1}])";
  const std::string furnace = R"("lights": [{"type": "environment", "radiance": 0.5}])";
  const std::string none = spheres(""), one = "/panels/0/sphere/lights/0";
  check_all({
      {"", none, "/panels/0", "a sphere has \"sphere\", not \"series\""},
      {panel(sun), "", "/panels/0", "only a panel of kind \"spheres\" has \"sphere\""},
      {panel(""), none, "/panels/0/sphere", "\"lights\" is missing here and above"},
      {panel(R"("lights": [])"), none, "/panels/0/sphere/lights", "accepted: an array of 1 to 16 items"},
      {lit(R"("type": "spot")"), none, one + "/type",
       "unknown type \"spot\"; accepted: directional, sphere, environment"},
      {lit(R"("theta": 1)"), none, one, "\"type\" is missing"},
      {lit(R"("type": "directional", "irradiance": 1)"), none, one, "\"theta\" is missing"},
      {lit(R"("type": "directional", "theta": 1, "radiance": 1)"), none, one + "/radiance", "unknown key \"radiance\""},
      {lit(R"("type": "directional", "theta": 1, "irradiance": -1)"), none, one + "/irradiance",
       "found -1, accepted: a number in [0, 1e+06]"},
      {lit(R"("type": "environment", "radiance": [0.1, -0.2, 0])"), none, one + "/radiance/1", "found -0.2"},
      {lit(R"("type": "environment", "radiance": [0.1, 0.2])"), none, one + "/radiance", "accepted: an array of 3"},
      {lit(R"("type": "directional", "theta": "181deg", "irradiance": 1)"), none, one + "/theta",
       "accepted: an angle from 0 to 180deg"},
      {lit(R"("type": "sphere", "theta": 1, "radiance": 1)"), none, one, "\"radius\" is missing"},
      {lit(R"("type": "sphere", "theta": 1, "radius": 0, "radiance": 1)"), none, one + "/radius",
       "found 0 rad; accepted: an angle above 0 and up to 90deg"},
      {panel(""), spheres(R"("lights": [{"type": "sphere", "theta": 1, "radius": "91deg", "radiance": 1}])"),
       "/sphere/lights/0/radius", "found 1.588"},
      {lit(R"("type": "environment", "radiance": 0.6)"), spheres(R"("exposure": 2)"), "/panels/0/sphere/lights",
       "the environment is 1.2 after the exposure, brighter than white; accepted: up to 1"},
      {panel(R"("exposure": 0)"), none, "/panels/0/sphere/exposure", "found 0, accepted: a number in [1e-06, 1e+06]"},
      {panel(R"("pixels": 15)"), none, "/panels/0/sphere/pixels", "accepted: a whole number in [16, 2048]"},
      {panel(R"("pixels": 2049)"), none, "/panels/0/sphere/pixels", "found 2049"},
      {panel(R"("light": 1)"), none, "/panels/0/sphere/light", "did you mean \"lights\"?"},
      {panel("") + R"(, "at": {"theta_o": 1})", spheres(sun), "/panels/0/at/theta_o", "a sphere has no \"theta_o\""},
      {panel("") + R"(, "channel": "g")", spheres(sun), "/panels/0/channel", "a sphere has no \"channel\""},
      {panel("") + R"(, "at": {"alhpa": 1})", spheres(sun), "/panels/0/at/alhpa", "did you mean \"alpha\"?"},
      {panel("") + R"(, "for_each": {"variable": "alpha", "values": [0.1, -1]})", spheres(sun),
       "/panels/0/for_each/values/1", "found -1"},
      {panel("") + R"(, "y": {"label": "L"})", spheres(sun), "/panels/0/y", "a sphere has no \"y\""},
      {panel(""), spheres(sun, R"("alpha": 0.5, "mean_slope": [0.1, 0])"), "/panels/0", "has no mean slope"},
      {panel(""), spheres(furnace, R"("alpha_x": 0.5, "alpha_y": 0.2, "correlation": 0.3)"), "/sphere/lights",
       "symmetric about x and y"},
  });
}

TEST_CASE("figures: profiles") {
  const auto kind = [](const std::string& profile) { return R"("kind": "profile", "profile": {)" + profile + "}"; };
  const std::string surface =
      R"("surface": {"type": "gaussian", "alpha": 0.5, "samples": 64, "correlation_length": 4})";
  const std::string viewed = surface + R"(, "omega_o": "60deg")";
  const auto panel = [](const std::string& keys) { return R"("profile": {)" + keys + "}"; };
  check_all({
      {"", kind(surface), "/panels/0", "a profile has \"profile\", not \"series\""},
      {panel(surface), "", "/panels/0", "only a panel of kind \"profile\""},
      {series + ", " + panel(surface), kind(""), "/panels/0", "accepted: either series, or profile"},
      {R"("title": "T")", "", "/panels/0", "found none of series, profile"},
      {panel(""), kind(""), "/panels/0/profile", "\"surface\" is missing here and above"},
      {panel("") + R"(, "at": {"theta_o": 1})", kind(viewed), "/panels/0/at", "a profile has no \"at\""},
      {panel(R"("ray": 1)"), kind(viewed), "/panels/0/profile/ray", "did you mean \"rays\"?"},
      {panel(R"("surface": {"type": "gausian", "alpha": 1})"), kind(""), "/panels/0/profile/surface/type",
       "did you mean \"gaussian\"?"},
      {panel(R"("surface": {"type": "uncorrelated"})"), kind(""), "/panels/0/profile/surface", "\"alpha\" is missing"},
      {panel(R"("surface": {"type": "gaussian", "alpha": 1, "samples": 64, "correlation_length": 40})"), kind(""),
       "/panels/0/profile/surface/correlation_length", "samples / 4"},
      {panel(R"("rays": 3)"), kind(R"("surface": {"type": "ggx", "alpha": 1, "mean_slope": [1, 0]}, "omega_o": 1)"),
       "/profile/surface/mean_slope", "accepted: [0, 0]"},
      {panel(R"("rays": 3)"), kind(surface), "/panels/0/profile", "\"omega_o\" is missing"},
      {panel(R"("rays": 3)"), kind(surface + R"(, "omega_o": "90.5deg")"), "/profile/omega_o", "below the horizon"},
      {panel(R"("shear": -2)"), kind(viewed), "/panels/0/profile/shear", "takes omega_o below the horizontal"},
      {panel(R"("omega_i": 2)"), kind(viewed), "/panels/0/profile/omega_i", "below the horizon"},
      {panel(R"("arrows": ["omega_i"])"), kind(viewed), "/panels/0/profile/arrows", "needs \"omega_i\""},
      {panel(R"("numbers": ["theta_m"])"), kind(viewed), "/panels/0/profile/numbers", "known of v_cavity"},
      {panel(R"("numbers": ["g2"])"), kind(viewed), "/panels/0/profile/numbers", "\"g2\" needs \"omega_i\""},
      {panel(R"("arrows": ["omega"])"), kind(viewed), "/panels/0/profile/arrows/0", "accepted: omega_o, omega_i"},
      {panel(R"("numbers": ["autocorrelation"])"), kind(R"("surface": {"type": "v_cavity", "alpha": 1})"),
       "/panels/0/profile/numbers", "known of gaussian, ggx and uncorrelated"},
      {panel(R"("rays": 2)"), kind(R"("omega_o": 1, "surface": {"type": "uncorrelated", "alpha": 1})"),
       "/panels/0/profile/rays", "accepted: a joined surface"},
      {panel(R"("cut": 64)"), kind(viewed), "/panels/0/profile/cut", "found 64; accepted: a whole number below 64"},
      {panel(R"("stretch": 0)"), kind(viewed), "/panels/0/profile/stretch", "found 0"},
  });
}

TEST_CASE("figures: shape") {
  check_all({
      {"", R"("colums": 2)", "/colums", "did you mean \"columns\"?"},
      {"", R"("kind": "line")", "/kind", "unknown value \"line\"; did you mean \"lines\"?"},
      {"", R"("columns": 0)", "/columns", "found 0, accepted: a whole number in [1, 8]"},
      {"", R"("columns": 1.5)", "/columns", "found 1.5"},
      {"", R"("tolerance": 0)", "/tolerance", "found 0"},
      {"", R"("cells": 1)", "/cells", "found 1"},
      {"", R"("id": "../x")", "/id", "found \"../x\", accepted: letters, digits"},
      {"", R"("id": "")", "/id", "found \"\""},
      {"", R"("id": "a/b")", "/id", "found \"a/b\""},
      {"", R"("id": "a\nb")", "/id", "found \"a\\nb\""},
      {"", R"("id": ".hidden")", "/id", "found \".hidden\""},
      {"", R"("id": "fïg")", "/id", "found \"fïg\""},
      {R"("series": [])", "", "/panels/0/series", "found 0 items"},
      {R"("series": [{}])", "", "/panels/0/series/0",
       "found none of quantity, ratio, difference, absolute; accepted: either"},
      {R"("series": [{"quantity": "d", "ratio": [{"quantity": "d"}, {"quantity": "d"}]}])", "", "/panels/0/series/0",
       "found quantity with ratio"},
      {R"("series": [{"ratio": [{"quantity": "d"}]}])", "", "/panels/0/series/0/ratio", "found 1 items"},
      {R"("series": [{"absolute": {"difference": [{"quantity": "d"}, 3]}}])", "",
       "/panels/0/series/0/absolute/difference/1", "found 3"},
      {R"("title": 3, )" + series, "", "/panels/0/title", "found 3"},
      {R"("for_each": {"variable": "alpha", "values": []}, )" + series, "", "/panels/0/for_each/values",
       "found 0 items"},
      {R"("for_each": {"variable": "alpha", "values": [[1]]}, )" + series, "", "/panels/0/for_each/values/0",
       "found an array"},
  });
}

TEST_CASE("figures: names that nothing has, at the name") {
  check_all({
      {R"("series": [{"quantity": "g11", "at": {"theta_o": 1}}])", "", "/panels/0/series/0/quantity",
       "unknown quantity \"g11\"; did you mean \"g1\"?"},
      {R"("series": [{"ratio": [{"quantity": "d"}, {"quantity": "brdff"}]}])", "",
       "/panels/0/series/0/ratio/1/quantity", "did you mean \"brdf\"?"},
      {R"("series": [{"quantity": "d", "at": {"alhpa": 1}}])", "", "/panels/0/series/0/at/alhpa",
       "unknown variable \"alhpa\"; did you mean \"alpha\"?"},
      {R"("at": {"theta_0": 1}, )" + series, "", "/panels/0/at/theta_0", "did you mean \"theta_o\"?"},
      {"", R"("at": {"exponent": 1})", "/at/exponent", "unknown variable \"exponent\""},
      {R"("for_each": {"variable": "gama", "values": [1]}, )" + series, "", "/panels/0/for_each/values/0",
       "unknown variable \"gama\""},
      {"", R"("x": {"variable": "thetam", "from": 0, "to": 1})", "/x", "did you mean \"theta_m\"?"},
      {R"("x": {"variable": "thetam"}, )" + series, "", "/panels/0/x", "did you mean \"theta_m\"?"},
      {R"("at": {"masking": "smiht"}, )" + series, "", "/panels/0/at/masking",
       "unknown masking \"smiht\"; did you mean \"smith\"?"},
      {R"("for_each": {"variable": "distribution", "values": ["ggx", "bekmann"]}, )" + series, "",
       "/panels/0/for_each/values/1", "did you mean \"beckmann\"?"},
      {R"("at": {"maskin": "smith"}, )" + series, "", "/panels/0/at/maskin", "did you mean \"masking\"?"},
      {R"("at": {"alpha": "rough"}, )" + series, "", "/panels/0/at/alpha",
       "\"alpha\" cannot be \"rough\"; accepted: a number"},
      {R"("at": {"theta_o": "nan"}, )" + series, "", "/panels/0/at/theta_o", "cannot be \"nan\""},
      {R"("at": {"theta_o": "infdeg"}, )" + series, "", "/panels/0/at/theta_o", "cannot be \"infdeg\""},
      {R"("at": {"theta_o": "60"}, )" + series, "", "/panels/0/at/theta_o", "cannot be \"60\""},
      {R"("series": [{"quantity": "d", "material": "gols"}])",
       R"("materials": {"gold": {"distribution": {"type": "ggx", "alpha": 1}}})", "/panels/0/series/0/material",
       "unknown material \"gols\"; did you mean \"gold\"?"},
      {"", R"("material": "gold")", "/material", "unknown material \"gold\"; accepted: none"},
  });
}

TEST_CASE("figures: values that a material refuses, where they were set") {
  check_all({
      {R"("series": [{"quantity": "d", "at": {"alpha": 0}}])", "", "/panels/0/series/0/at/alpha",
       "found 0, accepted: a number in [1e-06, 1e+06]"},
      {R"("for_each": {"variable": "alpha", "values": [1, -2]}, )" + series, "", "/panels/0/for_each/values/1",
       "found -2"},
      {"", R"("x": {"variable": "correlation", "from": 0, "to": 1}, "at": {"theta_m": 0})", "/x",
       "found 1, accepted: a number in (-1, 1)"},
      {"", R"("x": {"variable": "stretch_x", "from": 0, "to": 1}, "at": {"theta_m": 0})", "/x",
       "found 0, accepted: a number > 0"},
      {"", R"("x": {"variable": "stretch_x", "from": 1, "to": 2}, "at": {"theta_m": 0},
              "material": {"distribution": {"type": "phong", "exponent": 4}})",
       "/panels/0/series/0", "shape-invariant"},
      {R"("at": {"masking": "v_cavity"}, )" + series,
       R"("material": {"distribution": {"type": "ggx", "alpha": 1}, "shadowing": {"type": "height_correlated"}})",
       "/panels/0/series/0", "/shadowing/type: \"height_correlated\" needs"},
      {"", R"("materials": {"unused": {"distribution": {"type": "ggx", "alpha": 1}, "masking": {"type": "kelemen"},
                            "shadowing": {"type": "height_correlated"}}})",
       "/materials/unused/shadowing/type", "needs a masking"},
      {"", R"("material": {"distribution": {"type": "ggx", "alpha": 0}})", "/material/distribution/alpha", "found 0"},
  });
}

TEST_CASE("figures: what a quantity needs") {
  check_all({
      {R"("series": [{"quantity": "d"}, {"quantity": "g1"}])", "", "/panels/0/series/1", "needs omega_o: theta_o"},
      {R"("series": [{"quantity": "brdf", "at": {"theta_o": 1}}])", "", "/panels/0/series/0", "needs omega_i: theta_i"},
      {R"("series": [{"difference": [{"quantity": "d"}, {"quantity": "lambda"}]}])", "",
       "/panels/0/series/0/difference/1", "needs omega_o: theta_o"},
      {R"("series": [{"quantity": "furnace"}])", "", "/panels/0/series/0", "needs theta_o"},
      {R"("series": [{"quantity": "lambda", "at": {"theta_o": 1, "masking": "v_cavity"}}])", "", "/panels/0/series/0",
       "the masking function depends on the normal and has no Lambda"},
      {R"("series": [{"quantity": "d", "at": {"theta_m": 1}}])", R"("x": {"variable": "theta_o", "from": 0, "to": 1},
        "material": {"distribution": {"type": "ggx"}})",
       "/material/distribution", "found none of alpha"},
  });
  const TempFolder folder;
  const auto bare = folder.write("fig.json", "{" + head + x + R"(, "panels": [{)" + series + "}]}");
  CHECK(error_of(folder, 2, [&] { config::load_figure(bare); }) ==
        "fig.json: /panels/0/series/0: \"material\" is missing here and above");
  const auto no_x = folder.write("fig.json", "{" + head + R"("panels": [{)" + series + "}]}");
  CHECK(
      contains(error_of(folder, 2, [&] { config::load_figure(no_x); }), "fig.json: /panels/0: \"variable\" of \"x\""));
}

TEST_CASE("figures: settings of a term that its quantity does not depend on") {
  const std::string over_i = R"("x": {"variable": "theta_i", "from": 0, "to": 1}, "at": {"theta_o": 0.5})";
  check_all({
      {R"("series": [{"quantity": "brdf", "at": {"theta_m": 1}}])", over_i, "/panels/0/series/0/at/theta_m",
       "\"brdf\" does not depend on \"theta_m\""},
      {R"("series": [{"difference": [{"quantity": "brdf_cos"}, {"quantity": "brdf", "at": {"slope": 1}}]}])", over_i,
       "/panels/0/series/0/difference/1/at/slope", "does not depend on \"slope\""},
      {R"("series": [{"quantity": "albedo", "at": {"phi_i": 1}}])", over_i, "/panels/0/series/0/at/phi_i",
       "\"albedo\" does not depend on \"phi_i\""},
      {R"("series": [{"quantity": "brdf", "at": {"theta_o": 1, "theta_i": 1}}])", "", "/x",
       "\"brdf\" does not depend on \"theta_m\""},
  });
  // Outer levels set what some of the terms use, and a constant may be drawn beside a curve.
  const TempFolder folder;
  const auto path = folder.write(
      "fig.json",
      figure_text({R"("series": [{"quantity": "brdf"}, {"quantity": "furnace"}])",
                   R"("x": {"variable": "theta_i", "from": 0, "to": 1}, "at": {"theta_o": 0.5, "theta_m": 1})", "",
                   ""}));
  CHECK(config::load_figure(path).figure.panels.at(0).series.size() == 2);
}

TEST_CASE("figures: axes, labels and what only some kinds have") {
  const std::string polar = R"("kind": "polar", "x": {"variable": "theta_m", "from": -1, "to": 1})";
  const std::string map = R"("kind": "heatmap", "y": {"variable": "theta_o", "from": 0, "to": 1})";
  check_all({
      {"", R"("x": {"variable": "theta_m", "from": 0, "to": 1, "scale": "log"})", "/x", "found from = 0 on a log axis"},
      {R"("y": {"scale": "log", "from": -1}, )" + series, "", "/panels/0/y", "found from = -1 on a log axis"},
      {"", R"("y": {"scale": "log", "to": 0})", "/y", "found to = 0 on a log axis, accepted: a number > 0"},
      {"", R"("x": {"variable": "theta_m", "from": 1, "to": 1})", "/x",
       "found from = 1 and to = 1, accepted: from < to"},
      {R"("x": {"from": 2}, )" + series, "", "/panels/0/x", "found from = 2 and to = 1"},
      {"", R"("x": {"variable": "theta_m", "from": 1})", "/x", "needs \"from\" and \"to\""},
      {"", R"("x": {"from": 0, "to": 1})", "/x", "\"variable\" of \"x\" is missing"},
      {"", R"("x": {"variable": "theta_m", "from": "0º", "to": 1})", "/x/from",
       "found \"0º\", accepted: a number in radians"},
      {"", R"("x": {"variable": "theta_m", "from": 0, "to": 1, "samples": 1})", "/x/samples", "found 1"},
      {"", R"("x": {"variable": "theta_m", "from": 0, "to": 1, "unit": "degree"})", "/x/unit",
       "did you mean \"degrees\"?"},
      {R"("arrows": ["omega_o"], )" + series, polar, "/panels/0/arrows", "\"omega_o\" needs \"theta_o\""},
      {R"("arrows": ["mirror"], )" + with_view, polar, "/panels/0/arrows", "\"mirror\" needs \"theta_o\""},
      {R"("arrows": ["omega_m"], )" + series, polar, "/panels/0/arrows/0", "unknown value \"omega_m\""},
      {R"("arrows": ["omega_o"], "at": {"theta_o": 1}, )" + series, "", "/panels/0/arrows",
       "only a polar plot has arrows"},
      {R"("series": [{"quantity": "g1"}, {"quantity": "g1"}])", map, "/panels/0/series", "a heat map has one series"},
      {R"("series": [{"quantity": "g1"}])", R"("kind": "heatmap")", "/panels/0", "\"variable\" of \"y\" is missing"},
      {R"("contours": [{"label": "", "level": 1}], )" + series, "", "/panels/0/contours",
       "only a heat map has contours"},
      {R"("for_each": {"variable": "alpha", "values": [1, 2], "labels": ["one"]}, )" + series, "",
       "/panels/0/for_each/labels", "found 1 labels for 2 values"},
      {R"("series": [{"quantity": "d", "for_each": [{"variable": "phi_m", "values": [1]},
          {"variable": "alpha", "values": [1], "labels": ["a", "b"]}]}])",
       "", "/panels/0/series/0/for_each/1/labels", "found 2 labels for 1 values"},
  });
}

TEST_CASE("figures: the numbers of a caption") {
  const auto numbers = [](const std::string& number) { return R"("numbers": {"n": )" + number + R"(})"; };
  // figure_text's caption is "C": a figure with numbers is written out.
  const TempFolder folder;
  const auto error_with = [&](const std::string& caption, const std::string& number,
                              const std::string& kind = "lines") {
    const std::string text = R"({"id": "f", "kind": ")" + kind + R"(", "title": "T", "caption": ")" + caption +
                             R"(", )" + numbers(number) + ", " + x +
                             R"(, "y": {"variable": "phi_m", "from": 0, "to": 1},
      "material": {"distribution": {"type": "ggx", "alpha": 0.5}},
      "panels": [{"title": "P", "series": [{"label": "s", "quantity": "d"}]}]})";
    const auto path = folder.write("fig.json", text);
    return error_of(folder, 2, [&] { config::load_figure(path); });
  };
  struct Wrong {
    std::string caption, number, what;
  };
  const std::vector<Wrong> cases = {
      {"{n}", R"({"series": "t", "x": 0.5})", "/numbers/n/series: unknown series \"t\""},
      {"{n}", R"({"series": "s", "x": 0.5, "panel": "Q"})", "/numbers/n/panel: unknown panel \"Q\""},
      {"{n}", R"({"series": "s", "x": 0.5, "panel": 2})", "/numbers/n/panel: found 2; accepted: 1 to 1"},
      {"{n}", R"({"series": "s"})", "/numbers/n: accepted: one of \"x\" and \"take\""},
      {"{n}", R"({"x": 0.5})", "/numbers/n: \"series\" is missing"},
      {"{n}", R"({"series": "s", "x": 0.5, "from": 0.1})", "/numbers/n/from: not used beside \"x\""},
      {"{n}", R"({"note": "s", "x": 0.5})", "/numbers/n/x: not used beside \"note\""},
      {"{n}", R"({"series": "s", "note": "s"})", "/numbers/n: accepted: one of series, note, ratio, difference"},
      {"{n}", R"({"ratio": [{"series": "s", "x": 0.5}, {"series": "t", "x": 0.5}]})", "/numbers/n/ratio/1/series"},
      {"{n} {m}", R"({"series": "s", "x": 0.5})", "/caption: unknown number \"m\""},
      {"C", R"({"series": "s", "x": 0.5})", "/numbers/n: the caption has no {n}"},
  };
  for (const auto& one : cases) {
    CAPTURE(one.number);
    const std::string error = error_with(one.caption, one.number);
    CHECK_MESSAGE(contains(error, one.what), error);
  }
  CHECK(contains(error_with("{n}", R"({"series": "s", "take": "largest"})", "heatmap"), "/numbers/n/series: not used"));
}

TEST_CASE("figures: what is swept is not fixed as well, which would be a flat line") {
  const std::string swept = "which is swept by /x; accepted: one of the two, or to fix it within an operand";
  check_all({
      {R"("at": {"theta_m": 0.3}, )" + series, "", "/panels/0/at/theta_m", "\"theta_m\" fixes \"theta_m\", " + swept},
      {series, R"("at": {"slope": 0.3})", "/at/slope", "\"slope\" fixes \"theta_m\", " + swept},
      {R"("series": [{"quantity": "d", "for_each": {"variable": "theta_m", "values": [0.1, 0.2]}}])", "",
       "/panels/0/series/0/for_each/values/0", swept},
  });
}

TEST_CASE("figures: names in labels and titles are those of for_each") {
  check_all({
      {R"("series": [{"label": "α = {alpa}", "quantity": "d", "for_each": {"variable": "alpha", "values": [0.1, 0.2]}}])",
       "", "/panels/0/series/0/label", "unknown variable of for_each \"alpa\"; did you mean \"alpha\"?"},
      {R"("title": "{alpha}", )" + series, "", "/panels/0/title", "accepted: none"},
  });
}
