// `brdfplot fit --quantity albedo`: what it writes, compiled.
#include "cli/fit_program.hpp"

using namespace test;

TEST_CASE("the code of a fit of an albedo computes the albedo, in every language") {
  const Folder folder;
  folder.write("m.json", R"({"name": "m", "distribution": {"type": "ggx", "alpha": 0.3}})");
  const std::string said = check_output(folder, "brdfplot fit m.json -q albedo --tolerance 0.01 -o out");
  CHECK(said.find("proved: E in [0, 1]") != std::string::npos);
  build_fit_program(folder, "m_albedo", 1, {"m_albedo(T(p[0]), T(0.3))"});
  // As `eval` has it, at cosines of which doubles and floats are one.
  const std::vector<std::vector<double>> points = {{0.0625}, {0.25}, {0.5}, {1}};
  folder.write("directions.csv", "x_o,y_o,z_o\n0.998044963916957,0,0.0625\n0.9682458365518543,0,0.25\n"
                                 "0.8660254037844386,0,0.5\n0,0,1\n");
  const auto exact = cells(check_output(folder, "brdfplot eval m.json -q albedo -i directions.csv"));
  const auto rows = run_fit_program(folder, "m_albedo", points);
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (const double value : rows[k]) CHECK(std::fabs(value - std::stod(exact[k + 1].back())) < 0.01);
  CHECK(run(folder, "brdfplot fit m.json -q fnord").code == 2);
}
