/// \file
/// Numbers that carry a bound of the error with which a machine computes them.
#pragma once

#include <algorithm>
#include <cmath>

namespace brdfplot {

/// How a machine rounds, relative to results: sums and products, quotients, square roots.
struct SingleArithmetic { ///< float: IEEE, fused or not, or GLSL's highp (a quotient within 2.5 ulp, a root within 4.5)
  static double nearest(double value) { return static_cast<double>(static_cast<float>(value)); }
  static constexpr double unit = 0x1p-24;
  static constexpr double quotient = 5 * unit;
  static constexpr double root = 9 * unit;
};
struct DoubleArithmetic { ///< IEEE; twice its unit, since the values that it is compared with are rounded like that too
  static double nearest(double value) { return value; }
  static constexpr double unit = 0x1p-52;
  static constexpr double quotient = unit;
  static constexpr double root = unit;
};

/// Running error analysis (Wilkinson 1986; Higham 2002, section 3.3): the exact value of an expression and a bound of
/// what `Machine` makes of it, if nothing overflows or underflows. Errors are taken to be independent, which they are
/// not: the bound is right, and larger than what is seen.
template <class Machine>
struct Rounded {
  double value = 0;
  double error = 0;

  Rounded() = default;
  /// A constant of the code.
  explicit Rounded(double constant)
      : value(constant), error(Machine::nearest(constant) == constant ? 0 : Machine::unit * std::fabs(constant)) {}
  /// A result with the error that its operands give it, and its own.
  Rounded(double result, double passed_on, double own)
      : value(result), error(passed_on + own * (std::fabs(result) + passed_on)) {}
  /// An argument, which has no error.
  static Rounded exact(double value) { return {value, 0, 0}; }

  friend Rounded operator+(const Rounded& a, const Rounded& b) {
    return {a.value + b.value, a.error + b.error, Machine::unit};
  }
  friend Rounded operator-(const Rounded& a, const Rounded& b) {
    return {a.value - b.value, a.error + b.error, Machine::unit};
  }
  friend Rounded operator*(const Rounded& a, const Rounded& b) {
    return {a.value * b.value, std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error,
            Machine::unit};
  }
  /// Infinite error where the denominator may be 0.
  friend Rounded operator/(const Rounded& a, const Rounded& b) {
    const double quotient = a.value / b.value;
    const double least = std::max(std::fabs(b.value) - b.error, 0.0);
    return {quotient, (a.error + std::fabs(quotient) * b.error) / least, Machine::quotient};
  }
  friend Rounded sqrt(const Rounded& a) {
    const double root = std::sqrt(a.value);
    const double least = std::sqrt(std::max(a.value - a.error, 0.0));
    return {root, a.error > 0 ? a.error / (root + least) : 0, Machine::root};
  }
  friend Rounded max(const Rounded& a, const Rounded& b) {
    return {std::max(a.value, b.value), std::max(a.error, b.error), 0};
  }
  friend Rounded min(const Rounded& a, const Rounded& b) {
    return {std::min(a.value, b.value), std::max(a.error, b.error), 0};
  }
};

} // namespace brdfplot
