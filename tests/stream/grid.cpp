#include "stream/grid.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace brdfplot;

namespace {

std::string text_of(RowSource& rows, std::size_t piece) {
  std::string out(piece, ' '), all;
  while (const std::size_t count = rows.read(out.data(), piece)) all.append(out, 0, count);
  return all;
}

std::string error(const std::vector<std::string>& axes) {
  try {
    const GridRows rows(axes, "--grid");
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "none";
}

} // namespace

TEST_CASE("grid: an axis has both ends, where they are whole steps apart") {
  const GridAxis axis = grid_axis("theta_o=0:90deg:1deg", "--grid");
  CHECK(axis.count == 91);
  for (const std::uint64_t k : {0U, 37U, 90U}) CHECK(axis.value(k) == *parse_angle(std::to_string(k) + "deg"));
  const GridAxis tenths = grid_axis("theta_i=0:1:0.1", "--grid");
  CHECK(tenths.count == 11);
  CHECK(tenths.value(10) == 1);
  const GridAxis cut = grid_axis("phi_i=-10deg:10deg:7deg", "--grid");
  CHECK(cut.count == 3);
  CHECK(cut.value(2) == *parse_angle("4deg"));
  const GridAxis mixed = grid_axis("phi_i=0:3:90deg", "--grid");
  CHECK(mixed.count == 2);
  CHECK(mixed.value(1) == std::numbers::pi / 2);
  CHECK(grid_axis("theta_m=60deg", "--grid").count == 1);
}

TEST_CASE("grid: the product of axes, the last the fastest, in pieces of any size") {
  for (const std::size_t piece : {1U, 7U, 4096U}) {
    GridRows rows({"theta_o=0:1:0.5", "theta_i=0.25", "phi_i=0:1:1"}, "--grid");
    CHECK(text_of(rows, piece) ==
          "theta_o,theta_i,phi_i\n0,0.25,0\n0,0.25,1\n0.5,0.25,0\n0.5,0.25,1\n1,0.25,0\n1,0.25,1\n");
  }
}

TEST_CASE("grid: what is wrong") {
  const auto has = [](const std::vector<std::string>& axes, const std::string& part) {
    CHECK_MESSAGE(error(axes).find(part) != std::string::npos, error(axes));
  };
  const std::string form = "accepted: NAME=FROM:TO:STEP";
  for (const char* text : {"theta_o", "theta_o=", "theta_o=0:1", "theta_o=0:1:2:3", "theta_o=0:x:1", "theta_o=0:inf:1",
                           "theta_o=0:90deg:1dge"})
    has({text}, form);
  has({"theta=0:1:1"}, "unknown angle \"theta\"");
  has({"theta_o=0:1:0"}, "a step > 0");
  has({"theta_o=0:1:-1"}, "a step > 0");
  has({"theta_o=1:0:1"}, "FROM <= TO");
  has({"theta_o=0:1:1e-12"}, "at most 1000000000 values");
  has({"theta_o=0:1:1e-5", "theta_i=0:1:1e-5"}, "combinations; accepted: at most 1000000000");
  has({"theta_o=0", "theta_o=1"}, "there twice");
  has({"theta_o=0", "phi_i=1"}, "found \"phi_i\" without \"theta_i\"");
}
