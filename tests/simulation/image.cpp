#include "simulation/surfaces/image.hpp"
#include "simulation/scenes.hpp"

#include "config/temp_files.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

using namespace test;
using brdfplot::test::TempFolder;

namespace {

std::string bytes_of(float value, bool big_endian) {
  std::string raw(4, '\0');
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (std::size_t k = 0; k < 4; ++k) raw[big_endian ? 3 - k : k] = static_cast<char>(bits >> (8 * k));
  return raw;
}

std::string pfm(const std::string& scale, bool big_endian, int width, int height) {
  std::string text = "Pf\n" + std::to_string(width) + " " + std::to_string(height) + "\n" + scale + "\n";
  for (int k = 0; k < width * height; ++k) text += bytes_of(0.5F * static_cast<float>(k), big_endian);
  return text;
}

} // namespace

TEST_CASE("PFM, of both byte orders") {
  const TempFolder folder;
  for (const bool big : {false, true}) {
    const auto image = read_image(folder.write("a.pfm", pfm(big ? "1.0" : "-1.0", big, 3, 2)));
    CHECK(image.width == 3);
    CHECK(image.height == 2);
    CHECK(image.at(1, 0) == 0.5F);
    CHECK(image.at(2, 1) == 2.5F);
  }
}

TEST_CASE("files that are no heights") {
  using brdfplot::test::contains;
  const TempFolder folder;
  const auto error = [&](const std::string& name, const std::string& bytes) {
    const std::string path = folder.write(name, bytes);
    return brdfplot::test::error_of(folder, 2, [&] { read_image(path); });
  };
  CHECK(contains(error("a.txt", "hello"), "a.txt: is neither a PNG nor a PFM"));
  CHECK(contains(error("b.pfm", "PF\n1 1\n-1\n"), "with colour"));
  CHECK(contains(error("c.pfm", pfm("-1.0", false, 3, 2).substr(0, 30)), "ends too early"));
  CHECK(contains(error("d.pfm", "Pf\n3 x\n"), "its header"));
  CHECK(contains(error("e.pfm", pfm("-1.0", false, 1, 1)), "1 by 1 pixels"));
  // As many pixels as no integer can hold, or as there cannot be.
  CHECK(contains(error("g.pfm", "Pf\n-5e37 3\n-1\n"), "g.pfm: found -5e+37 by 3 pixels; accepted: a whole number"));
  CHECK(contains(error("h.pfm", "Pf\n3 1e300\n-1\n"), "found 3 by 1e+300 pixels"));
  CHECK(contains(error("i.pfm", "Pf\n2.5 3\n-1\n"), "found 2.5 by 3 pixels"));
  CHECK(contains(error("f.png", "\x89PNG\r\n\x1a\nnot much more"), "is a broken PNG"));
}

TEST_CASE("a height map with its scale, periodic or mirrored") {
  const TempFolder folder;
  // A plane wave in x: slope 0.5 * height / pitch up, then down.
  std::string text = "Pf\n4 4\n-1\n";
  for (int iy = 0; iy < 4; ++iy)
    for (const float h : {0.0F, 1.0F, 2.0F, 1.0F}) text += bytes_of(h, false);
  ModelChoice choice{.type = "height_map", .values = {}};
  choice.values.set("file", folder.write("wave.pfm", text));
  choice.values.set("height", 3.0);
  choice.values.set("pitch", 2.0);
  auto g1 = measure("g1", {30}, 2000);
  const SimulationResult result = run(scene(choice, g1));
  CHECK(at(result.surface, 0, "alpha_x") == doctest::Approx(1.5 * std::sqrt(2.0)));
  CHECK(at(result.surface, 0, "alpha_y") == 0);
  CHECK(std::isnan(at(result.surface, 0, "alpha_x_asked")));
  CHECK(at(result.tables[0], 0, "projected_area") == doctest::Approx(1).epsilon(0.02));
  choice.values.set("border", std::string("mirror"));
  // Mirrored, 0 1 2 1 1 2 1 0: six of eight steps have the slope.
  CHECK(at(run(scene(choice, g1)).surface, 0, "alpha_x") == doctest::Approx(1.5 * std::sqrt(2 * 6.0 / 8)));
}
