#include "figure/numbers.hpp"

#include "base/errors.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace brdfplot;
using namespace brdfplot::plot;
using Form = NumberDescription::Form;
using Take = Reading::Take;

namespace {

Figure parabola() {
  Panel panel;
  Series curve;
  curve.label = "curve";
  for (int k = -4; k <= 4; ++k) {
    curve.x.push_back(k);
    curve.y.push_back(k * k - 3.0);
  }
  Series line;
  line.label = "line";
  line.x = {0, 1};
  line.y = {20, 40};
  panel.series = {curve, line};
  panel.notes = {{"distance", "distance", 0.25, 0}};
  Figure figure;
  figure.panels = {panel};
  return figure;
}

NumberExpression reading(Reading of) {
  NumberExpression out;
  out.reading = std::move(of);
  return out;
}

double read(const Reading& of) { return value_of(reading(of), parabola()); }

} // namespace

TEST_CASE("numbers: read at a point, between two, and at extremes") {
  CHECK(read({.series = "curve", .x = 2}) == 1);
  CHECK(read({.series = "curve", .x = 2.5}) == 3.5);
  CHECK(read({.series = "curve", .x = -4}) == 13);
  CHECK(read({.take = Take::largest, .series = "curve"}) == 13);
  CHECK(read({.take = Take::smallest, .series = "curve"}) == -3);
  CHECK(read({.take = Take::smallest, .series = "curve", .place = true}) == 0);
  CHECK(read({.take = Take::largest, .series = "curve", .from = -1, .to = 1, .magnitude = true}) == 3);
  // The ends of the range count although no point is drawn there.
  CHECK(read({.take = Take::largest, .series = "curve", .from = -1, .to = 2.5}) == 3.5);
  CHECK(read({.take = Take::largest, .series = "curve", .from = -1, .to = 2.5, .place = true}) == 2.5);
  CHECK(read({.take = Take::largest, .any_series = true}) == 40);
  CHECK(read({.take = Take::note, .series = "distance"}) == 0.25);
}

TEST_CASE("numbers: what is not there is an error that says what is") {
  CHECK_THROWS_WITH_AS(read({.series = "circle", .x = 2}), doctest::Contains("accepted: \"curve\", \"line\""),
                       InputError);
  CHECK_THROWS_WITH_AS(read({.series = "curve", .x = 5}), doctest::Contains("not drawn"), InputError);
  CHECK_THROWS_WITH_AS(read({.series = "curve", .x = -5}), doctest::Contains("not drawn"), InputError);
  CHECK_THROWS_AS(read({.take = Take::largest, .series = "curve", .from = 7, .to = 8}), InputError);
  CHECK_THROWS_WITH_AS(read({.take = Take::note, .series = "size"}), doctest::Contains("distance"), InputError);
}

TEST_CASE("numbers: between two points of a logarithmic axis, and beyond an axis") {
  Figure figure;
  Panel panel;
  Series fall;
  fall.label = "fall";
  fall.x = {0, 1, 2};
  fall.y = {1, 1e-4, 1e-20};
  panel.series = {fall};
  figure.panels = {panel};
  const NumberExpression half = reading({.series = "fall", .x = 0.5}), tail = reading({.series = "fall", .x = 1.5});
  CHECK(value_of(half, figure) == doctest::Approx(0.5 * (1 + 1e-4)).epsilon(1e-14));
  figure.panels[0].y.scale = Scale::logarithmic;
  CHECK(value_of(half, figure) == doctest::Approx(1e-2).epsilon(1e-14));
  CHECK(value_of(tail, figure) == doctest::Approx(1e-12).epsilon(1e-14));
  // Below the axis the curve has no more points than it needs to leave it.
  figure.panels[0].y.from = 1e-3;
  CHECK(value_of(half, figure) == doctest::Approx(1e-2).epsilon(1e-14));
  CHECK_THROWS_WITH_AS(value_of(tail, figure), doctest::Contains("beyond the axis of y"), InputError);
}

TEST_CASE("numbers: ratios and differences") {
  NumberExpression both;
  both.operands = {reading({.series = "line", .x = 1}), reading({.series = "line", .x = 0})};
  both.operation = NumberExpression::Operation::ratio;
  CHECK(value_of(both, parabola()) == 2);
  both.operation = NumberExpression::Operation::difference;
  CHECK(value_of(both, parabola()) == 20);
}

TEST_CASE("numbers: significant digits") {
  CHECK(text_of(1.5237, Form::plain, 3) == "1.52");
  CHECK(text_of(0.0031268, Form::percent, 3) == "0.313 %");
  CHECK(text_of(std::numbers::pi / 4, Form::degrees, 2) == "45°");
  CHECK(text_of(0.999, Form::plain, 2) == "1.0");
  CHECK(text_of(37449, Form::plain, 2) == "37000");
  CHECK(text_of(-0.0123, Form::plain, 2) == "−0.012");
  CHECK(text_of(1.96e-15, Form::plain, 2) == "2.0·10^{−15}");
  CHECK(text_of(2.5e7, Form::plain, 1) == "3·10^{7}");
  CHECK(text_of(0, Form::percent, 2) == "0 %");
}

TEST_CASE("numbers: names are in braces, groups of scripts are not names") {
  CHECK(names_in("10^{-3} of E_{2+} is {share} at {angle}, {open") == std::vector<std::string>{"share", "angle"});
  const std::vector<NumberDescription> numbers = {{"two", reading({.series = "curve", .x = 2}), Form::plain, 2}};
  CHECK(caption_with("{two} and {two}, E_{two}", numbers, parabola()) == "1.0 and 1.0, E_{two}");
}
