#include "config/load.hpp"
#include "config/temp_files.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <string>

using namespace brdfplot;
using namespace brdfplot::test;

namespace {

std::string scene(const std::string& surface, const std::string& measures) {
  return R"({"surface": {)" + surface + R"(}, "measures": [)" + measures + "]}";
}

constexpr const char* gaussian_surface = R"("type": "gaussian", "alpha": 0.5, "samples": 64, "correlation_length": 4)";

} // namespace

TEST_CASE("a scene") {
  const TempFolder folder;
  const auto path = folder.write("rough.json", scene(gaussian_surface, R"({"type": "g1", "theta_o": "60deg"},
    {"type": "g2", "id": "pairs", "theta_o": [1, "90deg"], "theta_i": 0.5, "delta_phi": ["180deg"], "rays": 500})"));
  // An angle of 90 degrees is caught: the viewer would see no area.
  CHECK(contains(error_of(folder, 2, [&] { config::load_scene(path); }),
                 "rough.json: /measures/1/theta_o/1: found 1.57"));
  const auto good =
      config::load_scene(folder.write("good.json", scene(gaussian_surface, R"({"type": "g1", "theta_o": "60deg"},
    {"type": "g2", "id": "pairs", "theta_o": [1], "theta_i": 0.5, "delta_phi": ["180deg"], "rays": 500})")));
  CHECK(good.name == "good");
  CHECK(good.seed == 1);
  CHECK(good.realisations == 8);
  CHECK(good.surface.type == "gaussian");
  CHECK(good.surface.values.number("alpha") == 0.5);
  REQUIRE(good.measures.size() == 2);
  CHECK(good.measures[0].id == "g1");
  CHECK(good.measures[0].theta_o[0] == doctest::Approx(std::numbers::pi / 3));
  CHECK(good.measures[0].rays == 1e6);
  CHECK(good.measures[1].id == "pairs");
  CHECK(good.measures[1].theta_i == std::vector<double>{0.5});
  CHECK(good.measures[1].delta_phi[0] == doctest::Approx(std::numbers::pi));
  CHECK(good.measures[1].rays == 500);
}

TEST_CASE("what is wrong with a scene, and where") {
  const TempFolder folder;
  const auto error = [&](const std::string& surface, const std::string& measures) {
    const auto path = folder.write("s.json", scene(surface, measures));
    return error_of(folder, 2, [&] { config::load_scene(path); });
  };
  const std::string g1 = R"({"type": "g1", "theta_o": 1})";
  CHECK(contains(error(R"("type": "gaussian", "alpha": 0.5, "samples": 64.5)", g1), "/surface/samples: found 64.5"));
  CHECK(contains(error(R"("type": "gaussian", "alpha": 0.5, "samples": 32)", g1),
                 "/surface/correlation_length: found 16"));
  CHECK(contains(error(R"("type": "gaussian", "alhpa": 0.5)", g1), "did you mean \"alpha\"?"));
  CHECK(contains(error(gaussian_surface, g1 + "," + g1), "/measures/1/id: the id \"g1\" stands twice"));
  CHECK(contains(error(gaussian_surface, R"({"type": "g1", "id": "surface", "theta_o": 1})"), "/measures/0/id"));
  CHECK(contains(error(gaussian_surface, R"({"type": "g4", "theta_o": 1})"),
                 "unknown type \"g4\"; did you mean \"g1\"?"));
}

TEST_CASE("the path of a height map is relative to its file") {
  const TempFolder folder;
  const auto path = folder.write("a/s.json", scene(R"("type": "height_map", "file": "../maps/m.pfm", "height": 1)",
                                                   R"({"type": "g1", "theta_o": 1})"));
  CHECK(config::load_scene(path).surface.values.text("file") == folder.path("a/../maps/m.pfm"));
}
