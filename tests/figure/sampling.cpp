#include "figure/sampling.hpp"

#include "brdf/evaluate.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

namespace {

using namespace brdfplot;
using namespace brdfplot::plot;

using Function = std::function<double(double)>;

constexpr double promised = 5e-4;

CurveRequest request(double from, double to, double low = automatic, double high = automatic) {
  CurveRequest out;
  out.x.from = from;
  out.x.to = to;
  out.y.from = low;
  out.y.to = high;
  return out;
}

/// Samples a function of one value.
Curve sample(const Function& y, const CurveRequest& wanted) {
  return plot::sample(
      [&](const std::vector<double>& x) {
        std::vector<double> values;
        for (const double one : x) values.push_back(y(one));
        return values;
      },
      wanted);
}

double height(const Curve& curve) {
  const auto [low, high] = std::ranges::minmax(curve.y);
  return high - low;
}

/// The largest distance between polyline and curve at `count` places, in units of the height.
double worst_error(const Function& y, const Curve& curve, int count = 60001) {
  double worst = 0;
  std::size_t at = 0;
  for (int k = 0; k < count; ++k) {
    const double x = curve.x.front() + (curve.x.back() - curve.x.front()) * k / (count - 1);
    while (at + 2 < curve.x.size() && curve.x[at + 1] < x) ++at;
    const double t = (x - curve.x[at]) / (curve.x[at + 1] - curve.x[at]);
    worst = std::max(worst, std::fabs(curve.y[at] + t * (curve.y[at + 1] - curve.y[at]) - y(x)));
  }
  return worst / height(curve);
}

/// The distance of the nearest point of the curve.
double nearest(const Curve& curve, double x) {
  double best = std::numeric_limits<double>::infinity();
  for (const double point : curve.x) best = std::min(best, std::fabs(point - x));
  return best;
}

Material material_of(const std::string& type, double alpha, const std::string& masking = "smith") {
  TermDescription description;
  description.name = "m";
  description.distribution.type = type;
  description.masking.type = masking;
  description.distribution.values.set("alpha", alpha);
  return build(description);
}

} // namespace

TEST_CASE("smooth curves are true to the promise with few points") {
  struct Case {
    Function y;
    double from, to;
  };
  const Case cases[] = {
      {[](double x) { return std::sin(x); }, 0, 2 * std::numbers::pi},
      {[](double x) { return std::exp(-x); }, 0, 5},
      {[](double x) { return 1e6 + 10 * x * x * x; }, -10, 10},
      {[](double x) { return 1e-200 / (1 + x * x); }, -2, 2},
      {[](double x) { return std::sqrt(x); }, 0, 1},
  };
  for (const auto& one : cases) {
    const Curve curve = sample(one.y, request(one.from, one.to));
    CHECK(curve.x.front() == one.from);
    CHECK(curve.x.back() == one.to);
    CHECK(std::ranges::is_sorted(curve.x));
    CHECK(curve.x.size() < 120);
    CHECK(worst_error(one.y, curve) < promised);
    for (std::size_t k = 0; k < curve.x.size(); ++k) CHECK(curve.y[k] == one.y(curve.x[k]));
  }
}

TEST_CASE("straight and constant curves are two points, also when rounding shakes them") {
  CHECK(sample([](double x) { return 3 * x + 1; }, request(0, 1)).x.size() == 2);
  for (const double value : {0.0, 1.0, -1e-300, 1e300})
    CHECK(sample([&](double) { return value; }, request(0, 1)).x.size() == 2);
  CHECK(sample([](double x) { return 1 + 1e-15 * std::sin(1e9 * x); }, request(0, 1)).x.size() == 2);
  auto integral = request(0, 1);
  integral.noise = 1e-7;
  CHECK(sample([](double x) { return 1 + 9e-8 * std::sin(1e9 * x); }, integral).x.size() == 2);
}

TEST_CASE("narrow lobes of brdf cos are found and drawn as promised") {
  for (const double alpha : {0.1, 0.01, 0.001})
    for (const double theta : {0.3, 0.7, 1.2}) {
      CAPTURE(alpha);
      CAPTURE(theta);
      const auto material = material_of("ggx", alpha);
      const auto o = from_angles(theta, 0);
      const Function y = [&](double x) { return evaluate(material, Quantity::brdf_cos, o, from_angles(x, 0), {}); };
      auto lobe = request(-std::numbers::pi / 2, std::numbers::pi / 2);
      lobe.seeds = {-theta, theta, 0};
      int evaluations = 0;
      const Curve curve = sample([&](double x) { return ++evaluations, y(x); }, lobe);
      CHECK(curve.x.size() < 400);
      CHECK(evaluations < 4000);
      CHECK(*std::ranges::max_element(curve.y) >= 0.9999 * y(-theta));
      CHECK(worst_error(y, curve) < promised);
    }
}

TEST_CASE("a kink is drawn where it is") {
  // Eq. 49: masking begins where 2 (m.g) c = o.m.
  const auto material = material_of("beckmann", 1, "v_cavity");
  for (const double theta_m : {0.2, 0.5, 0.8}) {
    const auto m = from_angles(theta_m, 0);
    const Function y = [&](double x) { return evaluate(material, Quantity::g1, from_angles(x, 0), {}, m); };
    const double kink = std::atan(1 / std::tan(theta_m)); // 2 cos m cos o = cos(o - m) <=> tan o tan m = 1
    CAPTURE(theta_m);
    const Curve curve = sample(y, request(0, std::numbers::pi / 2));
    CHECK(nearest(curve, kink) < 1e-6);
    CHECK(curve.x.size() < 120);
    CHECK(worst_error(y, curve) < promised);
  }
  for (const double place : {1 / std::numbers::pi, 0.5, 0.123456789}) {
    const Curve curve = sample([&](double x) { return std::fabs(x - place); }, request(0, 1));
    CHECK(nearest(curve, place) < 1e-9);
    CHECK(curve.x.size() <= 8);
  }
}

TEST_CASE("a jump is a vertical line") {
  for (const double place : {1 / std::numbers::pi, 0.5, 0.9999}) {
    const Curve curve = sample([&](double x) { return x < place ? 1 + x : -2.0; }, request(0, 1));
    CAPTURE(place);
    const auto right = std::ranges::find(curve.y, -2.0) - curve.y.begin();
    REQUIRE(right > 0);
    const auto k = static_cast<std::size_t>(right);
    CHECK(curve.x[k] - curve.x[k - 1] < 1e-6);
    CHECK(curve.x[k - 1] <= place);
    CHECK(curve.x[k] >= place);
    CHECK(curve.x.size() < 12);
  }
}

TEST_CASE("logarithmic axes") {
  auto power = request(1e-6, 1e6);
  power.x.scale = power.y.scale = Scale::logarithmic;
  const Curve straight = sample([](double x) { return 1 / (x * x); }, power);
  CHECK(straight.x.size() <= 3);
  CHECK(straight.x.front() == 1e-6);
  CHECK(straight.x.back() == 1e6);

  const Function knee = [](double x) { return 1 / (1 + x); };
  const Curve curve = sample(knee, power);
  CHECK(curve.x.size() < 120);
  CHECK(nearest(curve, 1) < 0.2);

  // What is not positive cannot be drawn; what is beyond the axis is not followed.
  auto falling = request(0, 3, 1e-6, 10);
  falling.y.scale = Scale::logarithmic;
  const Curve cut = sample([](double x) { return x < 2 ? std::exp(-20 * x * x) : 0; }, falling);
  CHECK(cut.x.size() < 120);
  int evaluations = 0;
  sample([&](double x) { return ++evaluations, std::exp(-20 * x * x); }, falling);
  CHECK(evaluations < 1000);
}

TEST_CASE("polar curves are true in the plane") {
  auto lobe = request(-1.5, 1.5);
  lobe.polar = true;
  const Function y = [](double x) { return std::exp(-50 * x * x); };
  const Curve curve = sample(y, lobe);
  CHECK(curve.x.size() < 200);
  double worst = 0;
  for (int k = 0; k <= 20000; ++k) {
    const double x = -1.5 + 3.0 * k / 20000, px = y(x) * std::sin(x), py = y(x) * std::cos(x);
    double best = 1;
    for (std::size_t j = 0; j + 1 < curve.x.size(); ++j) {
      const double ax = curve.y[j] * std::sin(curve.x[j]), ay = curve.y[j] * std::cos(curve.x[j]);
      const double dx = curve.y[j + 1] * std::sin(curve.x[j + 1]) - ax,
                   dy = curve.y[j + 1] * std::cos(curve.x[j + 1]) - ay;
      const double length2 = dx * dx + dy * dy;
      const double t = length2 > 0 ? std::clamp(((px - ax) * dx + (py - ay) * dy) / length2, 0.0, 1.0) : 0;
      best = std::min(best, std::hypot(px - ax - t * dx, py - ay - t * dy));
    }
    worst = std::max(worst, best);
  }
  CHECK(worst < promised);
}

TEST_CASE("gaps and infinities are bounded and keep their ends") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const Curve gap = sample([&](double x) { return x > 0.3 && x < 0.6 ? nan : x * x; }, request(0, 1));
  CHECK(gap.x.size() < 120);
  const auto hole = std::ranges::find_if(gap.y, [](double v) { return std::isnan(v); }) - gap.y.begin();
  const auto end = std::ranges::count_if(gap.y, [](double v) { return std::isnan(v); });
  CHECK(end == 2);
  CHECK(gap.x.at(static_cast<std::size_t>(hole) - 1) == doctest::Approx(0.3).epsilon(1e-6));
  CHECK(gap.x.at(static_cast<std::size_t>(hole) + 2) == doctest::Approx(0.6).epsilon(1e-6));

  CHECK(sample([&](double) { return nan; }, request(0, 1)).x.size() == 2);
  CHECK(sample([&](double x) { return x < 1 ? 1 / (1 - x) : infinite; }, request(0, 1, 0, 10)).x.size() < 120);
  auto polar = request(-1, 1);
  polar.polar = true;
  CHECK(sample([&](double x) { return x > 0.5 ? infinite : 1.0; }, polar).x.size() < 200);
}

TEST_CASE("noise ends at the bound on evaluations") {
  int evaluations = 0;
  const Function noise = [&](double x) {
    ++evaluations;
    const double wild = std::sin(x * 12.9898e5) * 43758.5453;
    return wild - std::floor(wild);
  };
  const Curve curve = sample(noise, request(0, 1));
  CHECK(evaluations <= 129 + most_evaluations);
  CHECK(evaluations > 10000);
  CHECK(std::ranges::is_sorted(curve.x));
}

TEST_CASE("a round of refinement is one call: some tens for the most crooked curve") {
  const auto calls_of = [](const Function& y, const CurveRequest& wanted) {
    int calls = 0;
    std::size_t evaluations = 0;
    plot::sample(
        [&](const std::vector<double>& x) {
          ++calls;
          evaluations += x.size();
          std::vector<double> values;
          for (const double one : x) values.push_back(y(one));
          return values;
        },
        wanted);
    CHECK(evaluations > 250);
    return calls;
  };
  CHECK(calls_of([](double x) { return 3 * x + 1; }, request(0, 1)) == 2);
  CHECK(calls_of([](double x) { return std::exp(-x); }, request(0, 5)) <= 3);
  CHECK(calls_of([](double x) { return std::sin(1 / (x + 0.02)); }, request(0, 1)) < 40);
  CHECK(calls_of([](double x) { return std::fabs(std::sin(40 * x)) + (x > 0.77 ? 1 : 0); }, request(0, 1)) < 40);
}

TEST_CASE("sampling is deterministic, and can be evenly spaced") {
  const Function y = [](double x) { return std::sin(1 / (x + 0.02)); };
  const Curve first = sample(y, request(0, 1)), second = sample(y, request(0, 1));
  CHECK(first.x == second.x);
  CHECK(first.y == second.y);
  CHECK(worst_error(y, first) < promised);

  auto even = request(1, 100);
  even.adaptive = false;
  even.initial = 3;
  CHECK(sample([](double x) { return x * x; }, even).x == std::vector<double>{1, 50.5, 100});
  even.x.scale = Scale::logarithmic;
  CHECK(sample([](double x) { return x * x; }, even).x[1] == doctest::Approx(10));
}
