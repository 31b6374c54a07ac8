/// Pictures as PNG, and as images of an SVG.
#include "draw/png.hpp"

#include "draw/base64.hpp"
#include "draw/figures.hpp"
#include "draw/markup.hpp"
#include "simulation/surfaces/image.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace brdfplot::plot;

/// 3 x 2 pixels, every byte another.
Picture picture(int channels, bool opaque) {
  Picture out{3, 2, channels, opaque, {}};
  for (int k = 0; k < 6 * (channels + (opaque ? 0 : 1)); ++k) out.bytes.push_back(static_cast<unsigned char>(10 * k));
  return out;
}

Figure spheres_figure() {
  Figure figure;
  figure.id = "balls";
  figure.title = "Balls";
  figure.kind = Kind::spheres;
  figure.columns = 2;
  for (const char* title : {"one", "two"}) {
    Panel panel;
    panel.title = title;
    panel.series = {plot_tests::curve(
        "r", 0, -1, 1, [](double x) { return x * x; }, 4)};
    panel.notes.push_back({"3 % above white", "above_white", 0.03, 0});
    panel.picture = picture(3, false);
    figure.panels.push_back(panel);
  }
  return figure;
}

} // namespace

TEST_CASE("base64 of RFC 4648") {
  for (const auto& [bytes, text] : {std::pair{"", ""},
                                    {"f", "Zg=="},
                                    {"fo", "Zm8="},
                                    {"foo", "Zm9v"},
                                    {"foob", "Zm9vYg=="},
                                    {"fooba", "Zm9vYmE="},
                                    {"foobar", "Zm9vYmFy"}}) {
    std::string out;
    append_base64(out, bytes);
    CHECK(out == text);
  }
}

TEST_CASE("PNG: size, depth and type of colour, and that it is sRGB") {
  // Types of colour: ISO/IEC 15948, table 11.1.
  for (const auto& [channels, opaque, type] : {std::tuple{1, true, 0}, {3, true, 2}, {1, false, 4}, {3, false, 6}}) {
    const std::string png = to_png(picture(channels, opaque));
    CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    CHECK(png.substr(12, 4) == "IHDR");
    CHECK(png.substr(16, 8) == std::string("\0\0\0\3\0\0\0\2", 8));
    CHECK(int(png[24]) == 8);
    CHECK(int(png[25]) == type);
    CHECK(png.find("sRGB") != std::string::npos);
    CHECK(png == to_png(picture(channels, opaque)));
  }
}

TEST_CASE("PNG: the pixels come back") {
  std::string name = (std::filesystem::temp_directory_path() / "brdfplot-png-XXXXXX").string();
  REQUIRE(mkdtemp(name.data()) != nullptr);
  const auto path = std::filesystem::path(name) / "a.png";
  std::ofstream(path, std::ios::binary) << to_png(picture(1, true));
  const auto image = brdfplot::simulation::read_image(path.string());
  std::filesystem::remove_all(name);
  REQUIRE(image.width == 3);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column)
      CHECK(image.at(column, 1 - row) == doctest::Approx((30 * row + 10 * column) / 255.0).epsilon(1e-6));
}

TEST_CASE("SVG of spheres: a picture each, square, beside its label") {
  const auto svg = to_svg(spheres_figure());
  CHECK(plot_tests::fault_of(svg) == "");
  std::string data;
  append_base64(data, to_png(picture(3, false)));
  CHECK(plot_tests::count(svg, " href=\"data:image/png;base64," + data + "\"/>") == 2);
  CHECK(plot_tests::count(svg, "width=\"320\" height=\"320\"") == 2);
  CHECK(plot_tests::count(svg, ">one</text>") == 1);
  CHECK(plot_tests::count(svg, ">3 % above white</text>") == 2);
  CHECK(plot_tests::count(svg, "bp-legend") == 0);
}

TEST_CASE("CSV of spheres: the radiance along a diameter and what is cut") {
  auto figure = spheres_figure();
  figure.panels.resize(1);
  figure.panels[0].x.column = "position";
  figure.panels[0].y.column = "radiance";
  CHECK(to_csv(figure) == "panel,series,position,radiance\none,r,-1,1\none,r,-0.5,0.25\none,r,0,0\none,r,0.5,0.25\n"
                          "one,r,1,1\none,above_white,,0.03\n");
}
