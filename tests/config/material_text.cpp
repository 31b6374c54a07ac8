#include "choice/advise/draft.hpp"
#include "config/load.hpp"
#include "config/temp_files.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

using namespace brdfplot;
using namespace brdfplot::test;

TEST_CASE("a material that is written reads back as it was") {
  const TempFolder folder;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BRDFPLOT_SOURCE_DIR "/configs/materials")) {
    const MaterialDescription before = choice::canonical(config::load_material(entry.path().string()));
    const auto path = folder.write("m.json", config::material_text(before));
    CHECK_MESSAGE(choice::identity_of(choice::canonical(config::load_material(path))) == choice::identity_of(before),
                  entry.path().string());
    ++count;
  }
  CHECK(count > 10);
}

TEST_CASE("coats within coats are written as they were") {
  const TempFolder folder;
  const std::string mirror = R"({"type": "mirror", "distribution": {"type": "ggx", "alpha": 0.1},
    "fresnel": {"type": "dielectric", "eta": 1.5}})";
  const auto path = folder.write("m.json", R"({"name": "m", "terms": [{"type": "lambert", "albedo": 0.1},
    {"name": "outer", "type": "coated", "weight": 0.5, "coat": )" +
                                               mirror + R"(, "tint": 0.5, "base": [
      {"name": "inner", "type": "coated", "attenuation": "half", "coat": {"name": "second", )" +
                                               mirror.substr(1) +
                                               R"(, "base": [{"name": "a", "type": "lambert"}]},
      {"name": "b", "type": "lambert"}]}, {"name": "c", "type": "lambert"}]})");
  const MaterialDescription before = choice::canonical(config::load_material(path));
  const auto again = folder.write("n.json", config::material_text(before));
  CHECK(choice::identity_of(choice::canonical(config::load_material(again))) == choice::identity_of(before));
}
