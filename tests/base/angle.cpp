#include "base/number.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace brdfplot;

TEST_CASE("angles with and without a unit") {
  CHECK(parse_angle("1.5") == 1.5);
  CHECK(parse_angle("1.5rad") == 1.5);
  CHECK(parse_angle(" 1.5 rad ") == 1.5);
  CHECK(parse_angle("-1e-3") == -1e-3);
  CHECK(parse_angle("180deg") == std::numbers::pi);
  CHECK(parse_angle("-90 deg") == -std::numbers::pi / 2);
  CHECK(std::fabs(*parse_angle("60deg") - std::numbers::pi / 3) < 1e-15);
  for (const char* text : {"", "deg", "rad", "60grad", "60degrad", "60 deg x", "x", "1,5", "0x1"})
    CHECK_FALSE(parse_angle(text));
}
