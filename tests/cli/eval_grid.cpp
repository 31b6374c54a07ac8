#include "cli/program.hpp"

using namespace test;

namespace {

const std::string eval = "brdfplot eval configs/materials/rough_gold.json ";

} // namespace

TEST_CASE("a grid needs no CSV, and has the values of one") {
  const Folder folder;
  std::string csv = "theta_o,theta_i\n";
  for (int o = 0; o <= 90; o += 15)
    for (int i = 0; i <= 80; i += 20) csv += std::to_string(o) + "deg," + std::to_string(i) + "deg\n";
  folder.write("in.csv", csv);
  const auto expected = cells(check_output(folder, eval + "-q brdf,g2 -i in.csv"));
  const auto found =
      cells(check_output(folder, eval + "-q brdf,g2 --grid theta_o=0:90deg:15deg --grid theta_i=0:80deg:20deg"));
  REQUIRE(found.size() == expected.size());
  CHECK(found[0] == expected[0]);
  for (std::size_t row = 1; row < found.size(); ++row)
    for (std::size_t k = 2; k < found[row].size(); ++k) CHECK(found[row][k] == expected[row][k]);
  CHECK(found[6][0] == "0.2617993877991494");
}

TEST_CASE("a grid of many rows comes as a stream, the same on any number of threads") {
  const Folder folder;
  const std::string call = eval + "-q g1 --grid theta_o=0:89deg:0.01deg --grid theta_m=0:9deg:1deg --threads ";
  const std::string one = check_output(folder, call + "1");
  CHECK(std::ranges::count(one, '\n') == 8901 * 10 + 1);
  CHECK(check_output(folder, call + "3") == one);
}

TEST_CASE("wrong grids are exit code 2, with one line") {
  const Folder folder;
  check_error(folder, eval + "-q g1 --grid theta_o=0:90deg", 2, {"--grid", "theta_o=0:90deg", "NAME=FROM:TO:STEP"});
  check_error(folder, eval + "-q g1 --grid thetao=1", 2, {"--grid", "thetao"});
  check_error(folder, eval + "-q brdf --grid theta_o=1", 2, {"--grid: ", "theta_i"});
  check_error(folder, eval + "-q g1 --grid theta_o=1 -i in.csv", 2, {"--grid", "beside -i"});
}
