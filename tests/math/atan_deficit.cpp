#include "math/atan_deficit.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

#include <limits>

TEST_CASE("1 - atan(s) / s to 4e-15, on both sides of where the series ends") {
  using Wide = boost::multiprecision::cpp_bin_float_100;
  for (int k = -160; k <= 400; ++k) {
    const double s = std::pow(10.0, 0.05 * k);
    const Wide exact = 1 - atan(Wide(s)) / Wide(s);
    CHECK(abs(Wide(brdfplot::atan_deficit(s)) / exact - 1) < 4e-15);
  }
  for (const double s : {0.349999, 0.35, 0.350001}) {
    const Wide exact = 1 - atan(Wide(s)) / Wide(s);
    CHECK(abs(Wide(brdfplot::atan_deficit(s)) / exact - 1) < 4e-15);
  }
  CHECK(brdfplot::atan_deficit(0) == 0);
  CHECK(brdfplot::atan_deficit(std::numeric_limits<double>::infinity()) == 1);
}
