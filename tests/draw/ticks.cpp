#include "draw/ticks.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace brdfplot::plot;

constexpr double pi = std::numbers::pi;

Axis axis_of(Scale scale, Unit unit = Unit::none) {
  Axis axis;
  axis.scale = scale;
  axis.unit = unit;
  return axis;
}

Extent extent_of(const std::vector<double>& values, Scale scale = Scale::linear) {
  Extent extent;
  extent.add(values, scale);
  return extent;
}

std::vector<std::string> labels(const Axis& axis, const Range& range, int most) {
  std::vector<std::string> out;
  for (const auto& tick : make_ticks(axis, range, most).major) out.push_back(tick.label);
  return out;
}

using Labels = std::vector<std::string>;

bool is_round(double step) {
  const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  for (const double round : {1.0, 2.0, 5.0}) {
    if (std::abs(mantissa - round) < 1e-6) return true;
  }
  return false;
}

} // namespace

TEST_CASE("linear ticks are multiples of 1, 2 or 5, evenly spaced, and cover the range") {
  const std::vector<Range> ranges = {{0, 1},      {0, 0.7},        {-1, 1},       {-3, -2.5},
                                     {0, 3e-5},   {1e6, 4e6},      {0.9, 1.1},    {-1e-9, 1e-9},
                                     {0, 1e-300}, {-1e300, 1e300}, {1, 1 + 1e-7}, {17, 9123}};
  for (const auto& range : ranges) {
    for (const int most : {2, 3, 5, 8, 10}) {
      CAPTURE(range.from);
      CAPTURE(range.to);
      CAPTURE(most);
      const auto ticks = make_ticks(axis_of(Scale::linear), range, most).major;
      REQUIRE(!ticks.empty());
      CHECK(static_cast<int>(ticks.size()) <= most);
      const double slack = 1e-5 * (range.to - range.from);
      CHECK(ticks.front().value >= range.from - slack);
      CHECK(ticks.back().value <= range.to + slack);
      if (ticks.size() < 2) continue;
      const double step = ticks[1].value - ticks[0].value;
      CHECK(is_round(step));
      CHECK(ticks.front().value - step < range.from);
      CHECK(ticks.back().value + step > range.to);
    }
  }
}

TEST_CASE("labels of linear ticks") {
  const auto linear = axis_of(Scale::linear);
  CHECK(labels(linear, {0, 1}, 6) == Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(labels(linear, {-1, 1}, 5) == Labels{"−1.0", "−0.5", "0.0", "0.5", "1.0"});
  CHECK(labels(linear, {0, 3e-5}, 4) == Labels{"0", "1·10^{−5}", "2·10^{−5}", "3·10^{−5}"});
  CHECK(labels(linear, {-1e6, 1e6}, 5) == Labels{"−1.0·10^{6}", "−0.5·10^{6}", "0", "0.5·10^{6}", "1.0·10^{6}"});
}

TEST_CASE("angles in degrees have steps that divide the right angle") {
  const auto degrees = axis_of(Scale::linear, Unit::degrees);
  CHECK(labels(degrees, {0, pi / 2}, 7) == Labels{"0°", "15°", "30°", "45°", "60°", "75°", "90°"});
  CHECK(labels(degrees, {-pi / 2, pi / 2}, 5) == Labels{"−90°", "−45°", "0°", "45°", "90°"});
  CHECK(labels(degrees, {0, pi / 180}, 3) == Labels{"0.0°", "0.5°", "1.0°"});
  CHECK(labels(degrees, {0, 2 * pi}, 5) == Labels{"0°", "90°", "180°", "270°", "360°"});
}

TEST_CASE("angles in radians are parts of pi where the range is") {
  const auto radians = axis_of(Scale::linear, Unit::radians);
  CHECK(labels(radians, {0, pi / 2}, 5) == Labels{"0", "π/8", "π/4", "3π/8", "π/2"});
  CHECK(labels(radians, {-pi, pi}, 5) == Labels{"−π", "−π/2", "0", "π/2", "π"});
  CHECK(labels(radians, {0, 1}, 6) == Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(labels(radians, {0, 0.2}, 3) == Labels{"0.0", "0.1", "0.2"});
}

TEST_CASE("logarithmic ticks are decades, thinned when there are many, with 2 and 5 when there are few") {
  const auto logarithmic = axis_of(Scale::logarithmic);
  CHECK(labels(logarithmic, {1e-2, 1e1}, 8) == Labels{"10^{−2}", "10^{−1}", "10^{0}", "10^{1}"});
  CHECK(labels(logarithmic, {1e-16, 1}, 9) ==
        Labels{"10^{−16}", "10^{−14}", "10^{−12}", "10^{−10}", "10^{−8}", "10^{−6}", "10^{−4}", "10^{−2}", "10^{0}"});
  CHECK(labels(logarithmic, {0.1, 1}, 8) == Labels{"0.1", "0.2", "0.5", "1"});
  CHECK(labels(logarithmic, {1e-7, 1e-6}, 8) == Labels{"1·10^{−7}", "2·10^{−7}", "5·10^{−7}", "1·10^{−6}"});
  CHECK(labels(logarithmic, {1.1, 1.5}, 6) == Labels{"1.1", "1.2", "1.3", "1.4", "1.5"});
  CHECK(make_ticks(logarithmic, {0.01, 10}, 8).minor.size() == 24);
}

TEST_CASE("value ranges hold the data with a little air") {
  const auto linear = axis_of(Scale::linear);
  for (const auto& data :
       std::vector<std::vector<double>>{{0, 1}, {-3, 5}, {2, 2.5}, {-7, -6}, {1e-9, 3e-9}, {1e8, 2e9}}) {
    CAPTURE(data[0]);
    const auto range = value_range(linear, extent_of(data));
    CHECK(range.from <= data[0]);
    CHECK(range.to > data[1]);
    CHECK(range.to - range.from < 1.7 * (data[1] - data[0]));
  }
  CHECK(value_range(linear, extent_of({0.05, 1})).from == 0);
  CHECK(value_range(linear, extent_of({-1, -0.05})).to == 0);
}

TEST_CASE("constant data stand in the middle of a range") {
  for (const double value : {0.0, 1.0, -2.0, 1e-12, 1e12, 1e-310}) {
    for (const auto scale : {Scale::linear, Scale::logarithmic}) {
      CAPTURE(value);
      const auto range = value_range(axis_of(scale), extent_of({value, value}, scale));
      CHECK(range.from < range.to);
      CHECK(std::isfinite(range.to - range.from));
      if (scale == Scale::linear) CHECK(place_in(range, scale, value) == doctest::Approx(0.5));
      CHECK(!make_ticks(axis_of(scale), range, 5).major.empty());
    }
  }
  const auto nearly = value_range(axis_of(Scale::linear), extent_of({1, 1 + 1e-15}));
  CHECK(nearly.to - nearly.from == doctest::Approx(1));
}

TEST_CASE("no data, bad data and data out of all proportion still give a range") {
  const double inf = std::numeric_limits<double>::infinity();
  for (const auto scale : {Scale::linear, Scale::logarithmic}) {
    for (const auto& data : std::vector<std::vector<double>>{
             {}, {automatic}, {inf, -inf}, {-1e308, 1e308}, {1e-320, 1}, {-1, -2}, {0}, {5e-324, 1e308}}) {
      for (const auto& range :
           {value_range(axis_of(scale), extent_of(data, scale)), swept_range(axis_of(scale), extent_of(data, scale)),
            radius_range(axis_of(scale), extent_of(data, scale), 8),
            colour_range(axis_of(scale), extent_of(data, scale))}) {
        CHECK(range.from < range.to);
        CHECK(std::isfinite(range.to - range.from));
        CHECK(!make_ticks(axis_of(scale), range, 6).major.empty());
      }
    }
  }
}

TEST_CASE("logarithmic ranges ignore what is not positive and end beyond the data") {
  const auto logarithmic = axis_of(Scale::logarithmic);
  const auto range = value_range(logarithmic, extent_of({-1, 0, 2e-3, 0.8}, Scale::logarithmic));
  CHECK(range.from == doctest::Approx(1e-3));
  CHECK(range.to == doctest::Approx(1));
  const auto tail = value_range(logarithmic, extent_of({1e-300, 1}, Scale::logarithmic));
  CHECK(tail.from >= 1e-22);
}

TEST_CASE("swept ranges end with the data or at the round angle next to them") {
  const auto degrees = axis_of(Scale::linear, Unit::degrees);
  CHECK(swept_range(degrees, extent_of({0, 89.9 * pi / 180})).to == doctest::Approx(pi / 2));
  CHECK(swept_range(axis_of(Scale::linear), extent_of({0.013, 0.77})).from == 0.013);
}

TEST_CASE("bounds that the axis sets are kept") {
  auto axis = axis_of(Scale::linear);
  axis.from = -2;
  CHECK(value_range(axis, extent_of({0, 1})).from == -2);
  axis.to = 3;
  CHECK(value_range(axis, extent_of({0, 100})) == Range{-2, 3});
  CHECK(radius_range(axis, extent_of({0, 100}), 8) == Range{-2, 3});
}

TEST_CASE("the radius ends at a round number that the data do not exceed") {
  for (const int rings : {5, 8}) {
    for (const double most : {0.63, 1.0, 1.01, 7.9, 150.0, 3e-4, 2e7}) {
      const auto range = radius_range(axis_of(Scale::linear), extent_of({0, most}), rings);
      CHECK(range.from == 0);
      CHECK(range.to >= most * (1 - 1e-6));
      CHECK(range.to <= 1.5 * most);
    }
  }
}
