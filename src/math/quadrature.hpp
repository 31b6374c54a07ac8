/// \file
/// Adaptive quadrature that returns what it knows about its own error.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>

namespace brdfplot {

/// An integral: its value, an estimate of |value - truth|, and what it cost.
struct Estimate {
  double value = 0;
  double error = 0;
  std::size_t evaluations = 0;

  void add(const Estimate& other) {
    value += other.value;
    error += other.error;
    evaluations += other.evaluations;
  }
};

/// Up to three integrals that were taken together: those of the channels of a colour.
struct ColourEstimate {
  std::array<double, 3> value{};
  std::array<double, 3> error{};
  std::size_t evaluations = 0;

  Estimate channel(std::size_t c) const { return {value[c], error[c], evaluations}; }
  void add(const ColourEstimate& other, const std::array<double, 3>& weight = {1, 1, 1}) {
    for (std::size_t c = 0; c < 3; ++c) {
      value[c] += weight[c] * other.value[c];
      error[c] += weight[c] * other.error[c];
    }
    evaluations += other.evaluations;
  }
};

struct Tolerance {
  double absolute = 0;
  double relative = 0;
};

/// Evaluates the integrand at x[0..n) into y[0..n); called with all nodes of a rule at once.
using BatchFunction = std::function<void(const double* x, double* y, std::size_t n)>;

/// Whether f is of a user's, so that it may jump anywhere.
enum class Jumps { none, possible };

/// Integral of f over [points.front(), points.back()], cut at the points between (where f has kinks). Globally
/// adaptive: Gauss-Kronrod 10-21, the interval with the largest error is halved until the sum of the errors is below
/// max(absolute, relative |value|) or rounding forbids more. The error of an interval is judged by how fast its
/// Legendre coefficients fall (error_of() of gauss_kronrod.hpp), never below 50 roundings of the integral of |f|. The
/// caller sees from `error` whether the tolerance was met. A jump between an end of an interval and its first node is
/// seen by no rule: where jumps are possible f is taken at the ends too, and what it differs there from the polynomial
/// through the nodes, over that distance, is part of the error.
Estimate integrate(const BatchFunction& f, std::span<const double> points, const Tolerance& tolerance,
                   std::size_t max_evaluations = 100000, Jumps jumps = Jumps::none);

/// What an integral of f over [0, infinity) has beyond `from`, if f goes on falling by the power by which it falls from
/// 1e-5 `from` to there: for tails that reach further than numbers do. Infinite where that power is 1 or less.
double power_tail(const std::function<double(double x)>& f, double from);

} // namespace brdfplot
