#include "math/quadrature.hpp"

#include "base/threads/interrupt.hpp"

#include "math/gauss_kronrod.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace brdfplot {

namespace {

constexpr std::size_t node_count = 21;

struct Interval {
  double a, b, value, error;
  bool operator<(const Interval& other) const { return error < other.error; }
};

Interval apply(const BatchFunction& f, double a, double b) {
  const auto& rule = GaussKronrod<node_count>::rule();
  const double centre = 0.5 * (a + b);
  const double half = 0.5 * (b - a);
  std::array<double, node_count> x;
  std::array<double, node_count> y;
  for (std::size_t k = 0; k < node_count; ++k) x[k] = centre + half * rule.x[k];
  f(x.data(), y.data(), node_count);
  const RuleSums sums = apply_rule<node_count>(y);
  return {a, b, half * sums.kronrod, std::fabs(half) * error_of<node_count>(sums)};
}

using Pair = std::array<Interval, 2>;

Pair cut(const BatchFunction& f, const Interval& whole, double at) {
  const double point = whole.a + at * (whole.b - whole.a);
  return {apply(f, whole.a, point), apply(f, point, whole.b)};
}

double value(const Pair& pair) { return pair[0].value + pair[1].value; }
double error(const Pair& pair) { return pair[0].error + pair[1].error; }

/// The two halves, or two other parts where the halves cannot be believed: a jump next to the cut lies between the end
/// of a half and its first node, where no rule sees it, and then they seem to be far better than the whole was.
/// Smooth functions do that too, and there the two cuts are alike.
Pair divide(const BatchFunction& f, const Interval& whole, std::size_t& evaluations) {
  const Pair halves = cut(f, whole, 0.5);
  evaluations += 2 * node_count;
  if (error(halves) > 1e-4 * std::fabs(value(halves) - whole.value)) return halves;
  const Pair others = cut(f, whole, 0.45);
  evaluations += 2 * node_count;
  return error(others) > error(halves) ? others : halves;
}

} // namespace

Estimate integrate(const BatchFunction& f, std::span<const double> points, const Tolerance& tolerance,
                   std::size_t max_evaluations) {
  std::vector<Interval> heap; // the largest error on top
  Estimate estimate;
  const auto add = [&](const Interval& interval) {
    heap.push_back(interval);
    std::push_heap(heap.begin(), heap.end());
  };
  // Summed anew each time: a running difference would keep the rounding of large intermediate values.
  const auto sum = [&] {
    estimate.value = estimate.error = 0;
    for (const Interval& interval : heap) {
      estimate.value += interval.value;
      estimate.error += interval.error;
    }
    return estimate.error <= std::max(tolerance.absolute, tolerance.relative * std::fabs(estimate.value));
  };
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (!(points[k] < points[k + 1])) continue;
    add(apply(f, points[k], points[k + 1]));
    estimate.evaluations += node_count;
  }
  while (!sum() && estimate.evaluations < max_evaluations) {
    throw_if_interrupted();
    std::pop_heap(heap.begin(), heap.end());
    const Interval worst = heap.back();
    if (worst.b - worst.a < 1e-14 * std::max(std::fabs(worst.a), std::fabs(worst.b))) break;
    heap.pop_back();
    for (const Interval& part : divide(f, worst, estimate.evaluations)) add(part);
  }
  return estimate;
}

double power_tail(const std::function<double(double x)>& f, double from) {
  const double here = f(from);
  if (!(here > 0)) return 0;
  const double power = std::log(f(1e-5 * from) / here) / std::log(1e5);
  return power > 1 ? here * from / (power - 1) : std::numeric_limits<double>::infinity();
}

} // namespace brdfplot
