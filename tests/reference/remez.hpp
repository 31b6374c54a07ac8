/// \file
/// Remez's exchange for rational functions, in multiprecision: what the generators of coefficients share.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstddef>
#include <cstdio>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace brdfplot::fit {

using Real = boost::multiprecision::cpp_bin_float_100;
using Reals = std::vector<Real>;

/// The function to fit, and the weight that its error gets, at one q.
struct Sample {
  Real q, f, weight;
};

/// Ascending powers of q; denominator[0] = 1. `error` is the largest weighted error, signed.
struct Rational {
  Reals numerator, denominator;
  Real error = 0;
};

inline Real polynomial(const Reals& c, const Real& x) {
  Real sum = 0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * x + c[i];
  return sum;
}

/// Gaussian elimination with partial pivoting; the rows hold the right-hand side in their last column.
inline Reals solve(std::vector<Reals> rows) {
  const std::size_t n = rows.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r)
      if (abs(rows[r][c]) > abs(rows[pivot][c])) pivot = r;
    std::swap(rows[c], rows[pivot]);
    for (std::size_t r = c + 1; r < n; ++r) {
      const Real factor = rows[r][c] / rows[c][c];
      for (std::size_t j = c; j <= n; ++j) rows[r][j] -= factor * rows[c][j];
    }
  }
  Reals x(n);
  for (std::size_t i = n; i-- > 0;) {
    Real sum = rows[i][n];
    for (std::size_t j = i + 1; j < n; ++j) sum -= rows[i][j] * x[j];
    x[i] = sum / rows[i][i];
  }
  return x;
}

/// The N / M with N - (f + (-1)^i E / weight) M = 0 on the nodes. The product E M is linearised about the last M.
inline Rational level(const std::vector<Sample>& nodes, Rational fit) {
  const std::size_t n = fit.numerator.size(), m = fit.denominator.size() - 1, unknowns = n + m + 1;
  for (int pass = 0; pass < 30; ++pass) {
    std::vector<Reals> rows(unknowns, Reals(unknowns + 1));
    for (std::size_t i = 0; i < unknowns; ++i) {
      const auto& [q, f, weight] = nodes[i];
      const Real sign = (i % 2 ? -1 : 1) / weight;
      const Real last = polynomial(fit.denominator, q);
      Real power = 1;
      for (std::size_t j = 0; j < n; ++j, power *= q) rows[i][j] = power;
      power = q;
      for (std::size_t j = 0; j < m; ++j, power *= q) rows[i][n + j] = -(f + sign * fit.error) * power;
      rows[i][n + m] = -sign * last;
      rows[i][n + m + 1] = f + sign * fit.error * (1 - last);
    }
    const Reals x = solve(std::move(rows));
    const Real change = x[n + m] - fit.error;
    for (std::size_t j = 0; j < n; ++j) fit.numerator[j] = x[j];
    for (std::size_t j = 0; j < m; ++j) fit.denominator[j + 1] = x[n + j];
    fit.error = x[n + m];
    if (abs(change) < 1e-12 * abs(fit.error)) break;
  }
  return fit;
}

/// The largest error of each run of equal signs: the next nodes.
inline std::vector<Sample> extrema(const std::vector<Sample>& grid, const Rational& fit, Real& largest) {
  std::vector<Sample> chosen;
  Real best = 0;
  largest = 0;
  for (const Sample& s : grid) {
    const Real error = s.weight * (polynomial(fit.numerator, s.q) / polynomial(fit.denominator, s.q) - s.f);
    if (abs(error) > largest) largest = abs(error);
    if (chosen.empty() || error * best < 0) {
      chosen.push_back(s);
      best = error;
    } else if (abs(error) > abs(best)) {
      chosen.back() = s;
      best = error;
    }
  }
  return chosen;
}

/// The N / M, `n` coefficients over degree `m`, whose weighted error on (left, right] is minimax. `sample` gives the
/// function at a q; its weight may be zero at `left`.
template <class Sampler>
Rational remez(std::size_t n, std::size_t m, const Real& left, const Real& right, const Sampler& sample) {
  const std::size_t nodes_needed = n + m + 1;
  const std::size_t density = 40;
  std::vector<Sample> grid, nodes;
  for (std::size_t i = 1; i <= density * nodes_needed; ++i) {
    const Real phase = boost::math::constants::pi<Real>() * Real(i) / Real(density * nodes_needed);
    grid.push_back(sample((right + left) / 2 - (right - left) / 2 * cos(phase)));
  }
  for (std::size_t i = 0; i < nodes_needed; ++i) nodes.push_back(grid[density / 2 + density * i]);
  Rational fit{Reals(n), Reals(m + 1), 0};
  fit.denominator[0] = 1;
  for (int step = 0; step < 40; ++step) {
    fit = level(nodes, fit);
    Real largest;
    nodes = extrema(grid, fit, largest);
    if (nodes.size() < nodes_needed) throw std::runtime_error("the error does not alternate often enough");
    nodes.resize(nodes_needed);
    if (largest < 1.01 * abs(fit.error)) return fit;
  }
  throw std::runtime_error("the exchange does not settle");
}

template <class Float>
std::vector<Float> rounded(const Reals& values) {
  std::vector<Float> out;
  for (const Real& value : values) out.push_back(static_cast<Float>(value));
  return out;
}

/// `  static constexpr TYPE NAME[] = {...};` in hexadecimal: the bits, not their decimal image.
template <class Float>
void write_array(std::ostream& out, const char* name, const std::vector<Float>& values) {
  const bool single = sizeof(Float) == sizeof(float);
  out << "  static constexpr " << (single ? "float " : "double ") << name << "[] = {";
  for (std::size_t i = 0; i < values.size(); ++i) {
    char text[40];
    std::snprintf(text, sizeof text, single ? "%.6af" : "%.13a", static_cast<double>(values[i]));
    out << (i == 0 ? "\n      " : i % 4 == 0 ? ",\n      " : ", ") << text;
  }
  out << "};\n";
}

} // namespace brdfplot::fit
