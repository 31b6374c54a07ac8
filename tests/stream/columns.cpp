#include "stream/columns.hpp"

#include "base/errors.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace brdfplot;

namespace {

std::optional<std::string> read(const DirectionColumns& columns, const std::string& row,
                                std::array<Direction, letter_count>& directions) {
  FieldScanner scanner(row);
  return columns.read_row(scanner, directions);
}

void check_same(const Direction& found, const Direction& expected) {
  CHECK(std::fabs(found.x - expected.x) < 1e-15);
  CHECK(std::fabs(found.y - expected.y) < 1e-15);
  CHECK(std::fabs(found.z - expected.z) < 1e-15);
}

} // namespace

TEST_CASE("directions of a row, in any order of columns") {
  const DirectionColumns columns("z_m,phi_i,note,theta_o,\"y_m\", theta_i ,x_m", "f:1");
  CHECK(columns.has(Letter::o));
  CHECK(columns.has(Letter::i));
  CHECK(columns.has(Letter::m));
  CHECK(columns.names().at(5) == "theta_i");
  std::array<Direction, letter_count> directions{};
  CHECK_FALSE(read(columns, "4,90deg,x,30deg,\"0\",0.5rad,-3\n", directions));
  check_same(directions[0], from_angles(std::numbers::pi / 6, 0));
  check_same(directions[1], from_angles(0.5, std::numbers::pi / 2));
  check_same(directions[2], {-0.6, 0, 0.8});
}

TEST_CASE("vectors of any length are directions") {
  const DirectionColumns columns("x_o,y_o,z_o", "f:1");
  std::array<Direction, letter_count> directions{};
  for (const char* row : {"3e-320,0,4e-320\n", "3e307,0,4e307\n", "0.6,0,0.8\n"}) {
    CHECK_FALSE(read(columns, row, directions));
    CHECK(directions[0].x == doctest::Approx(0.6).epsilon(1e-3));
    CHECK(std::fabs(dot(directions[0], directions[0]) - 1) < 1e-15);
  }
  CHECK(read(columns, "0,0,-0\n", directions) == "(x_o, y_o, z_o) is the zero vector: it has no direction");
}

TEST_CASE("columns that are not there leave the direction alone") {
  const DirectionColumns columns("theta_i", "f:1");
  CHECK_FALSE(columns.has(Letter::o));
  std::array<Direction, letter_count> directions{};
  directions[0] = {1, 2, 3};
  CHECK_FALSE(read(columns, "0\n", directions));
  CHECK(directions[0].y == 2);
  CHECK(directions[1].z == 1);
}

TEST_CASE("what is wrong with a row") {
  const DirectionColumns columns("theta_o,note", "f:1");
  std::array<Direction, letter_count> directions{};
  CHECK(read(columns, "0\n", directions) == "found 1 field, the header has 2");
  CHECK(read(columns, "0,0,0\n", directions) == "found 3 fields, the header has 2");
  CHECK(read(columns, "x,\n", directions) ==
        "column \"theta_o\": found \"x\", accepted: a finite number (radians, or with a unit: 80deg)");
  CHECK(read(columns, "0,\"\n", directions) == "a quote is not closed");
}
