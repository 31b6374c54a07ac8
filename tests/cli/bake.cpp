// Tables through the command line: each format written, what a compiler makes of the source, and errors.
#include "cli/program.hpp"

using namespace test;

namespace {

const std::string ggx = R"({"distribution": {"type": "ggx", "alpha": 0.5}})";

} // namespace

TEST_CASE("bake writes the table that it describes") {
  const Folder folder;
  folder.write("ggx.json", ggx);
  const auto said =
      run(folder, "brdfplot bake ggx.json -q furnace --over cos_theta_o=0:1:5 --over alpha=0.1:1:3 -o t.csv");
  REQUIRE(said.code == 0);
  CHECK(said.out.starts_with("table      furnace of ggx.json: 5 x 3 x 1 numbers, "));
  CHECK(said.out.find("error      at most ") != std::string::npos);
  std::istringstream csv(folder.read("t.csv"));
  std::string line;
  std::getline(csv, line);
  CHECK(line == "cos_theta_o,alpha,furnace");
  int rows = 0;
  while (std::getline(csv, line)) ++rows;
  CHECK(rows == 15);
  // The same bytes on any number of threads, and the same values as JSON.
  const std::string table = folder.read("t.csv");
  REQUIRE(run(folder,
              "brdfplot bake ggx.json -q furnace --over cos_theta_o=0:1:5 --over alpha=0.1:1:3 -o u.csv --threads 1")
              .code == 0);
  CHECK(folder.read("u.csv") == table);
  const auto json = run(folder, "brdfplot bake ggx.json -q furnace --over cos_theta_o=0:1:5 --json");
  CHECK(json.code == 0);
  CHECK(json.out.find("\"nodes\": 5") != std::string::npos);
  CHECK(json.out.find("\"bound\": ") != std::string::npos);
}

TEST_CASE("what bake writes as C and GLSL is what a compiler takes, and interpolates") {
  const Folder folder;
  folder.write("ggx.json", ggx);
  REQUIRE(run(folder, "brdfplot bake ggx.json -q furnace --over cos_theta_o=0:1:9:2 --over alpha=0.1:1:5 -o ggx_e.h")
              .code == 0);
  REQUIRE(run(folder, "brdfplot bake ggx.json -q furnace --over cos_theta_o=0:1:9:2 --over alpha=0.1:1:5 -o ggx_e.csv")
              .code == 0);
  folder.write("main.c", R"(#include "ggx_e.h"
#include <stdio.h>
int main(void) {
  float value[1];
  ggx_e(0.25f, 0.1f, value); /* a node: t = 1/2 */
  printf("%.6f ", (double)value[0]);
  ggx_e(1.0f, 1.0f, value);
  printf("%.6f ", (double)value[0]);
  ggx_e(2.0f, 9.0f, value); /* clamped */
  printf("%.6f\n", (double)value[0]);
})");
  REQUIRE(run(folder, BRDFPLOT_CXX " -x c++ -Wall -Wextra -Werror main.c -o main").code == 0);
  std::istringstream numbers(run(folder, "./main").out);
  double node = 0, last = 0, clamped = 0;
  numbers >> node >> last >> clamped;
  std::vector<double> values;
  std::istringstream csv(folder.read("ggx_e.csv"));
  for (std::string line; std::getline(csv, line);)
    if (line.front() != 'c') values.push_back(std::stod(line.substr(line.rfind(',') + 1)));
  REQUIRE(values.size() == 45);
  CHECK(node == doctest::Approx(values[4]).epsilon(1e-5));
  CHECK(last == doctest::Approx(values[44]).epsilon(1e-5));
  CHECK(clamped == doctest::Approx(last).epsilon(1e-6));

  REQUIRE(run(folder, "brdfplot bake ggx.json -q furnace --over cos_theta_o=0:1:9:2 --over alpha=0.1:1:5 -o ggx_e.glsl")
              .code == 0);
  folder.write("t.frag",
               "#version 330\n" + folder.read("ggx_e.glsl") +
                   "out vec4 colour;\nvoid main() { float v[1]; ggx_e(0.25, 0.1, v); colour = vec4(v[0]); }\n");
  CHECK(run(folder, "glslangValidator t.frag").code == 0);
}

TEST_CASE("bake refuses in one line what it cannot write") {
  const Folder folder;
  folder.write("ggx.json", ggx);
  const auto refused = [&](const std::string& words, const std::string& says) {
    const auto said = run(folder, "brdfplot bake " + words);
    CHECK(said.code == 2);
    CHECK(said.err.find(says) != std::string::npos);
    CHECK(std::ranges::count(said.err, '\n') == 1);
  };
  refused("", "MATERIAL.json");
  refused("ggx.json", "-o TABLE");
  refused("ggx.json -o t.png", "a name that ends in .npy, .ktx2, .exr, .h, .glsl, .csv");
  refused("ggx.json -q fnord -o t.npy", "unknown quantity \"fnord\"");
  refused("ggx.json --type double -o t.ktx2", "accepted: float, half");
  refused("ggx.json --error 0 -o t.npy", "a number > 0");
  refused("ggx.json --over alpha=0.1:1 -o t.npy", "cos_theta_o");
  refused("ggx.json --over alpha=1 -o t.npy", "NAME=FROM:TO");
  CHECK(folder.list() == std::vector<std::string>{"ggx.json"});
}
