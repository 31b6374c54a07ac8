/// \file
/// The arithmetic of the code of a fit: its operations in its order, in any type of number. What fit_code() writes and
/// what is said of its accuracy are both this; a test compiles the one and compares it with the other, to the last bit.
#pragma once

#include "analysis/fit/target.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot {

/// A polynomial as the code has it: in x, or in u = 1 - x, whichever cancels less, and in y.
struct CodePolynomial {
  Polynomial of;
  bool in_u = false;
};

/// The numbers that stand in the code.
struct FitCode {
  bool cut = false;
  int power = 1;
  double scale = 1; ///< of s: that of the form, times alpha where that is a constant
  CodePolynomial n;
  CodePolynomial m;
};

/// Lambda = n / d.
template <class Real>
struct FitTerms {
  Real n, d;
  Real n_factor, m_factor; ///< the values of the polynomials
};

/// Below every c and s that are not 0: it keeps 1 / (c + s) finite where both are.
inline constexpr double code_tiny = 1e-30;

template <class Real>
Real code_polynomial(const Polynomial& p, const Real& t, const Real& y) {
  const auto coefficient = [&](std::size_t i) {
    auto value = static_cast<Real>(p.at(i, p.dy));
    for (std::size_t j = p.dy; j-- > 0;) value = static_cast<Real>(p.at(i, j)) + y * value;
    return value;
  };
  Real value = coefficient(p.dx);
  for (std::size_t i = p.dx; i-- > 0;) value = coefficient(i) + t * value;
  return value;
}

template <class Real>
Real code_power(const Real& u, int power) {
  const Real square = u * u;
  switch (power) {
  case 1: return u;
  case 2: return square;
  case 3: return square * u;
  case 4: return square * square;
  case 6: return (square * u) * (square * u);
  default: return (square * square) * (square * square); // 8
  }
}

/// The scaled projected roughness k, s >= 0.
template <class Real>
Real code_scaled(const FitCode& code, const Real& s) {
  return static_cast<Real>(code.scale) * s + static_cast<Real>(code_tiny);
}

/// n and d from the projected area c of the mesosurface and k, c >= 0.
template <class Real>
FitTerms<Real> code_terms(const FitCode& code, const Real& c, const Real& k, const Real& y) {
  using std::max;
  const Real r = code.cut ? max(c, k) : c + k;
  const Real q = static_cast<Real>(1.0) / r;
  const Real x = c * q;
  const Real u = (code.cut ? r - c : k) * q;
  const Real n_factor = code_polynomial(code.n.of, code.n.in_u ? u : x, y);
  const Real m_factor = code_polynomial(code.m.of, code.m.in_u ? u : x, y);
  const Real v = code_power(u, code.power);
  const bool plain = code.n.of.dx + code.n.of.dy == 0; // n = 1
  return {plain ? v : v * n_factor, x * m_factor, n_factor, m_factor};
}

/// The parameter, or the end of its domain that is nearest.
template <class Real>
Real code_within(const FitParameter& p, const Real& value) {
  using std::max;
  using std::min;
  const Real above = max(value, static_cast<Real>(p.from));
  return p.to < infinity ? min(above, static_cast<Real>(p.to)) : above;
}

/// y of the parameter.
template <class Real>
Real code_y(const FitParameter& p, const Real& value) {
  const Real within = code_within(p, value);
  if (p.reciprocal) return static_cast<Real>(p.factor) / (within + static_cast<Real>(p.shift));
  return static_cast<Real>(p.offset) + static_cast<Real>(p.factor) * within;
}

/// sin(theta), without the cancellation of 1 - c^2.
template <class Real>
Real code_sine(const Real& c) {
  using std::max;
  using std::sqrt;
  return sqrt(max((static_cast<Real>(1.0) - c) * (static_cast<Real>(1.0) + c), static_cast<Real>(0.0)));
}

/// s of a direction: alpha sin(theta), with alpha the argument, the parameter or the root of y; sin(theta) where it is
/// a constant.
template <class Real>
Real code_roughness(const FitTarget& target, const Real& c, const Real& alpha, const Real& y) {
  using std::sqrt;
  switch (target.alpha) {
  case FitAlpha::argument: return alpha * code_sine(c);
  case FitAlpha::parameter: return code_within(*target.parameter, alpha) * code_sine(c);
  case FitAlpha::root_of_y: return sqrt(y) * code_sine(c);
  case FitAlpha::constant: break;
  }
  return code_sine(c);
}

} // namespace brdfplot
