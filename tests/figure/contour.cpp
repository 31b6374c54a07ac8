#include "figure/contour.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace {

using namespace brdfplot::plot;

std::vector<double> steps(double from, double to, int count) {
  std::vector<double> out;
  for (int k = 0; k <= count; ++k) out.push_back(from + (to - from) * k / count);
  return out;
}

/// Lines of a function of two values.
std::vector<Contour::Line> level_lines(const std::function<double(double, double)>& value, double level,
                                       const std::vector<double>& x, const std::vector<double>& y) {
  const PlaneFunction values = [&](const std::vector<double>& u, const std::vector<double>& v) {
    std::vector<double> out;
    for (std::size_t k = 0; k < u.size(); ++k) out.push_back(value(u[k], v[k]));
    return out;
  };
  return brdfplot::plot::level_lines(values, level, x, y);
}

bool is_closed(const Contour::Line& line) {
  return line.x.size() > 2 && line.x.front() == line.x.back() && line.y.front() == line.y.back();
}

/// The largest distance of a line's points from where they should be.
double worst(const std::vector<Contour::Line>& lines, const std::function<double(double, double)>& distance) {
  double largest = 0;
  for (const auto& line : lines) {
    REQUIRE(line.x.size() == line.y.size());
    for (std::size_t k = 0; k < line.x.size(); ++k)
      largest = std::max(largest, std::fabs(distance(line.x[k], line.y[k])));
  }
  return largest;
}

} // namespace

TEST_CASE("a circle is one closed line") {
  const auto radius = [](double x, double y) { return std::hypot(x - 0.1, y + 0.05); };
  for (const double sign : {1.0, -1.0}) {
    const auto lines = level_lines([&](double x, double y) { return sign * radius(x, y); }, sign * 0.7,
                                   steps(-1, 1, 40), steps(-1, 1, 31));
    REQUIRE(lines.size() == 1);
    CHECK(is_closed(lines[0]));
    CHECK(lines[0].x.size() > 80);
    CHECK(worst(lines, [&](double x, double y) { return radius(x, y) - 0.7; }) < 1e-6);
    double turned = 0; // once around, without jumping back and forth
    for (std::size_t k = 0; k + 1 < lines[0].x.size(); ++k)
      turned += std::remainder(std::atan2(lines[0].y[k + 1] + 0.05, lines[0].x[k + 1] - 0.1) -
                                   std::atan2(lines[0].y[k] + 0.05, lines[0].x[k] - 0.1),
                               2 * std::numbers::pi);
    CHECK(std::fabs(turned) == doctest::Approx(2 * std::numbers::pi));
  }
}

TEST_CASE("a diagonal is one open line from border to border") {
  const auto lines = level_lines([](double x, double y) { return x - y; }, 0.1, steps(0, 1, 17), steps(0, 1, 23));
  REQUIRE(lines.size() == 1);
  CHECK(!is_closed(lines[0]));
  CHECK(worst(lines, [](double x, double y) { return x - y - 0.1; }) < 1e-6);
  const auto [low, high] = std::ranges::minmax(lines[0].x);
  CHECK(low == doctest::Approx(0.1));
  CHECK(high == doctest::Approx(1));
  const bool up = lines[0].x.front() < lines[0].x.back();
  CHECK((up ? std::ranges::is_sorted(lines[0].x) : std::ranges::is_sorted(lines[0].x, std::greater())));
}

TEST_CASE("a line through the nodes of the lattice is complete") {
  const auto lines = level_lines([](double x, double y) { return x - y; }, 0, steps(0, 1, 8), steps(0, 1, 8));
  double length = 0;
  for (const auto& line : lines)
    for (std::size_t k = 0; k + 1 < line.x.size(); ++k)
      length += std::hypot(line.x[k + 1] - line.x[k], line.y[k + 1] - line.y[k]);
  CHECK(length == doctest::Approx(std::sqrt(2.0)).epsilon(1e-6));
  CHECK(worst(lines, [](double x, double y) { return x - y; }) < 1e-6);
}

TEST_CASE("the edge of a plateau is located like a slope") {
  const auto plateau = [](double x, double y) { return y < 0.3 + 0.5 * x * x ? 1.0 : 0.25; };
  const auto lines = level_lines(plateau, 0.999, steps(-1, 1, 30), steps(0, 1, 30));
  REQUIRE(lines.size() == 1);
  CHECK(worst(lines, [](double x, double y) { return y - 0.3 - 0.5 * x * x; }) < 1e-6);
}

TEST_CASE("two islands are two lines, a saddle crosses none") {
  const auto islands = [](double x, double y) {
    return std::exp(-20 * (std::pow(x - 0.5, 2) + y * y)) + std::exp(-20 * (std::pow(x + 0.5, 2) + y * y));
  };
  const auto lines = level_lines(islands, 0.5, steps(-1, 1, 50), steps(-1, 1, 50));
  REQUIRE(lines.size() == 2);
  CHECK(is_closed(lines[0]));
  CHECK(is_closed(lines[1]));
  const auto saddle = level_lines([](double x, double y) { return x * y; }, 0.001, steps(-1, 1, 21), steps(-1, 1, 21));
  CHECK(saddle.size() == 2);
  CHECK(worst(saddle, [](double x, double y) { return x * y - 0.001; }) < 1e-6);
}

TEST_CASE("where nothing crosses there is no line") {
  const auto x = steps(0, 1, 10);
  CHECK(level_lines([](double, double) { return 1.0; }, 2, x, x).empty());
  CHECK(level_lines([](double, double) { return 1.0; }, 1, x, x).empty());
  CHECK(level_lines([](double, double) { return 1.0; }, 0.5, x, x).empty());
  CHECK(level_lines([](double, double) { return std::numeric_limits<double>::quiet_NaN(); }, 0, x, x).empty());
  CHECK(level_lines([](double u, double) { return u; }, 0.5, {0.0}, x).empty());
}
