#include "math/direction.hpp"
#include "base/number.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace brdfplot;

TEST_CASE("normalized is safe over the whole range of doubles") {
  for (const double scale : {5e-324, 1e-310, 1e-200, 1.0, 1e200, 1.7e308}) {
    const Direction d = normalized({scale, 0, -scale});
    INFO("scale " << scale);
    CHECK(d.x == doctest::Approx(0.70710678118654752).epsilon(1e-15));
    CHECK(d.z == doctest::Approx(-0.70710678118654752).epsilon(1e-15));
  }
  CHECK(dot(normalized({0, 0, 0}), {1, 1, 1}) == 0);
}

TEST_CASE("half vector and mirror direction belong together") {
  const Direction o = from_angles(1.1, 0.4), m = from_angles(0.3, 2.2);
  const Direction i = reflected(o, m);
  CHECK(dot(i, i) == doctest::Approx(1).epsilon(1e-15));
  CHECK(dot(o, m) == doctest::Approx(dot(i, m)).epsilon(1e-15));
  const Direction h = half_vector(o, i);
  CHECK(dot(h, m) == doctest::Approx(1).epsilon(1e-15));
  const Direction none = half_vector(o, -1.0 * o);
  CHECK(none.x == 0);
  CHECK(none.z == 0);
}

TEST_CASE("numbers are written in the shortest form that reads back") {
  for (const double value : {0.1, 1.0 / 3, 1e-300, 5e-324, 1.7976931348623157e308, -0.0, 42.0})
    CHECK(*parse_number(format_number(value)) == value);
  CHECK(format_number(0.1) == "0.1");
  CHECK(*parse_number(" +1.5e3 ") == 1500);
  CHECK_FALSE(parse_number("1.5x"));
  CHECK_FALSE(parse_number(""));
  CHECK(*parse_number("1e999") == std::numeric_limits<double>::infinity());
}
