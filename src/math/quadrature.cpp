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

/// What no node sees of an integral over [-1, 1], if f goes on at the ends by steps.
double missed_at_ends(const std::array<double, node_count>& y, double at_begin, double at_end) {
  const auto& rule = GaussKronrod<node_count>::rule();
  double begin = -at_begin, end = -at_end;
  for (std::size_t k = 0; k < node_count; ++k) {
    begin += rule.at_end[node_count - 1 - k] * y[k];
    end += rule.at_end[k] * y[k];
  }
  return (std::fabs(begin) + std::fabs(end)) * (1 - rule.x[node_count - 1]);
}

/// An integrand, and what it costs.
struct Integrand {
  const BatchFunction& f;
  Jumps jumps;
  std::size_t evaluations = 0;

  Interval apply(double a, double b) {
    const auto& rule = GaussKronrod<node_count>::rule();
    const double centre = 0.5 * (a + b);
    const double half = 0.5 * (b - a);
    std::array<double, node_count> x;
    std::array<double, node_count> y;
    for (std::size_t k = 0; k < node_count; ++k) x[k] = centre + half * rule.x[k];
    f(x.data(), y.data(), node_count);
    evaluations += node_count;
    const RuleSums sums = apply_rule<node_count>(y);
    double error = error_of<node_count>(sums);
    if (jumps == Jumps::possible) {
      const std::array<double, 2> ends = {a + 1e-12 * (b - a), b - 1e-12 * (b - a)};
      std::array<double, 2> at_ends;
      f(ends.data(), at_ends.data(), ends.size());
      evaluations += ends.size();
      error += missed_at_ends(y, at_ends[0], at_ends[1]);
    }
    return {a, b, half * sums.kronrod, std::fabs(half) * error};
  }
};

using Pair = std::array<Interval, 2>;

Pair cut(Integrand& f, const Interval& whole, double at) {
  const double point = whole.a + at * (whole.b - whole.a);
  return {f.apply(whole.a, point), f.apply(point, whole.b)};
}

double value(const Pair& pair) { return pair[0].value + pair[1].value; }
double error(const Pair& pair) { return pair[0].error + pair[1].error; }

/// The two halves, or two other parts where the halves cannot be believed: a jump next to the cut lies between the end
/// of a half and its first node, where no rule sees it, and then they seem to be far better than the whole was.
/// Smooth functions do that too, and there the two cuts are alike.
Pair divide(Integrand& f, const Interval& whole) {
  const Pair halves = cut(f, whole, 0.5);
  if (error(halves) > 1e-4 * std::fabs(value(halves) - whole.value)) return halves;
  const Pair others = cut(f, whole, 0.45);
  return error(others) > error(halves) ? others : halves;
}

} // namespace

Estimate integrate(const BatchFunction& f, std::span<const double> points, const Tolerance& tolerance,
                   std::size_t max_evaluations, Jumps jumps) {
  std::vector<Interval> heap; // the largest error on top
  Estimate estimate;
  Integrand integrand{f, jumps};
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
    add(integrand.apply(points[k], points[k + 1]));
  }
  while (!sum() && integrand.evaluations < max_evaluations) {
    throw_if_interrupted();
    std::pop_heap(heap.begin(), heap.end());
    const Interval worst = heap.back();
    if (worst.b - worst.a < 1e-14 * std::max(std::fabs(worst.a), std::fabs(worst.b))) break;
    heap.pop_back();
    for (const Interval& part : divide(integrand, worst)) add(part);
  }
  estimate.evaluations = integrand.evaluations;
  return estimate;
}

double power_tail(const std::function<double(double x)>& f, double from) {
  const double here = f(from);
  if (!(here > 0)) return 0;
  const double power = std::log(f(1e-5 * from) / here) / std::log(1e5);
  return power > 1 ? here * from / (power - 1) : std::numeric_limits<double>::infinity();
}

} // namespace brdfplot
