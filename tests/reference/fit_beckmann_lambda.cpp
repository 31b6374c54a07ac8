/// \file
/// Fits the rational function that src/microfacet/beckmann_lambda.hpp evaluates, and writes its coefficients.
///
///   fit-beckmann-lambda src/microfacet/beckmann_lambda_coefficients.hpp
///
/// With R(a) = 2 sqrt(pi) a e^(a^2) Lambda(a) = 1 - sqrt(pi) a erfcx(a), the function fitted is
///
///   U(a) = (1 / R(a) - 1) / a - 2 a,
///
/// which falls from sqrt(pi) at a = 0 to 2 / a at infinity. Remez's exchange finds the N / M, of degree n - 1 over n,
/// whose error in R is minimax in the relative sense: the error of U is weighted with a R(a), because
/// R = M / ((1 + 2 a^2) M + a N).
#include <boost/math/special_functions/erf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstdio>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Real = boost::multiprecision::cpp_bin_float_100;
using Reals = std::vector<Real>;

/// e^(-a^2) underflows to zero before this a, also when a roughness of 1e3 multiplies it.
const Real largest_a = 27.5;
/// The fit runs in q = (a - k) / (a + k), in which U is smooth up to a = infinity.
const Real k = 2;

Real root_pi() { return sqrt(boost::math::constants::pi<Real>()); }
Real from_q(const Real& q) { return k * (1 + q) / (1 - q); }

Real scaled_lambda(const Real& a) { return 1 - root_pi() * a * exp(a * a) * boost::math::erfc(a); }

Real polynomial(const Reals& c, const Real& x) {
  Real sum = 0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * x + c[i];
  return sum;
}

/// f = (a + k) U and the weight of its error, at one q.
struct Sample {
  Real q, f, weight;
};

Sample sample(const Real& q) {
  const Real a = from_q(q);
  const Real r = scaled_lambda(a);
  return {q, (a + k) * ((1 / r - 1) / a - 2 * a), a * r / (a + k)};
}

struct Rational {
  Reals numerator, denominator;
  Real error = 0;
};

/// Gaussian elimination with partial pivoting; the rows hold the right-hand side in their last column.
Reals solve(std::vector<Reals> rows) {
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
Rational level(const std::vector<Sample>& nodes, std::size_t n, Rational fit) {
  const std::size_t unknowns = nodes.size();
  for (int pass = 0; pass < 30; ++pass) {
    std::vector<Reals> rows(unknowns, Reals(unknowns + 1));
    for (std::size_t i = 0; i < unknowns; ++i) {
      const auto& [q, f, weight] = nodes[i];
      const Real sign = (i % 2 ? -1 : 1) / weight;
      const Real last = polynomial(fit.denominator, q);
      Real power = 1;
      for (std::size_t j = 0; j < n; ++j, power *= q) rows[i][j] = power;
      power = q;
      for (std::size_t j = 1; j <= n; ++j, power *= q) rows[i][n + j - 1] = -(f + sign * fit.error) * power;
      rows[i][2 * n] = -sign * last;
      rows[i][2 * n + 1] = f + sign * fit.error * (1 - last);
    }
    const Reals x = solve(std::move(rows));
    const Real change = x[2 * n] - fit.error;
    fit.numerator.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n));
    fit.denominator.assign(x.begin() + static_cast<std::ptrdiff_t>(n - 1),
                           x.begin() + static_cast<std::ptrdiff_t>(2 * n));
    fit.denominator[0] = 1;
    fit.error = x[2 * n];
    if (abs(change) < 1e-12 * abs(fit.error)) break;
  }
  return fit;
}

/// The largest error of each run of equal signs: the next nodes.
std::vector<Sample> extrema(const std::vector<Sample>& grid, const Rational& fit, Real& largest) {
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

Rational remez(std::size_t n) {
  const std::size_t nodes_needed = 2 * n + 1;
  const std::size_t points = 40 * nodes_needed;
  const Real right = (largest_a - k) / (largest_a + k);
  std::vector<Sample> grid, nodes;
  // The weight is zero at a = 0: no node stands there.
  for (std::size_t i = 1; i <= points; ++i) {
    const Real phase = boost::math::constants::pi<Real>() * Real(i) / Real(points);
    grid.push_back(sample((right - 1) / 2 - (right + 1) / 2 * cos(phase)));
  }
  for (std::size_t i = 0; i < nodes_needed; ++i) nodes.push_back(grid[20 + 40 * i]);
  Rational fit{Reals(n), Reals(n + 1), 0};
  fit.denominator[0] = 1;
  for (int step = 0; step < 40; ++step) {
    fit = level(nodes, n, fit);
    Real largest;
    std::vector<Sample> next = extrema(grid, fit, largest);
    if (next.size() < nodes_needed) throw std::runtime_error("the error does not alternate often enough");
    next.resize(nodes_needed);
    nodes = std::move(next);
    if (largest < 1.01 * abs(fit.error)) return fit;
  }
  throw std::runtime_error("the exchange does not settle");
}

/// sum c_j q^j (a + k)^degree as a polynomial in a.
Reals in_a(const Reals& c) {
  const std::size_t degree = c.size() - 1;
  Reals sum(c.size());
  for (std::size_t j = 0; j < c.size(); ++j) {
    Reals term{1};
    for (std::size_t factor = 0; factor < degree; ++factor) {
      const Real root = factor < j ? Real(-k) : k;
      term.push_back(0);
      for (std::size_t i = term.size(); i-- > 0;) term[i] = root * term[i] + (i > 0 ? term[i - 1] : Real(0));
    }
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += c[j] * term[i];
  }
  return sum;
}

/// Scaled so that M(0) = 1 (hence R(0) = 1 exactly) and rounded to the type that will hold them.
template <class Float>
std::pair<std::vector<Float>, std::vector<Float>> rounded(const Rational& fit) {
  const Reals n = in_a(fit.numerator), m = in_a(fit.denominator);
  std::vector<Float> numerator, denominator;
  for (const Real& c : n) numerator.push_back(static_cast<Float>(Real(c / m[0])));
  for (const Real& c : m) denominator.push_back(static_cast<Float>(Real(c / m[0])));
  for (const auto* list : {&numerator, &denominator})
    for (const Float c : *list)
      if (!(c > 0)) throw std::runtime_error("a coefficient is not positive");
  return {numerator, denominator};
}

template <class Float>
Real largest_error(const std::vector<Float>& numerator, const std::vector<Float>& denominator) {
  const Reals n(numerator.begin(), numerator.end()), m(denominator.begin(), denominator.end());
  Real largest = 0;
  for (int i = 0; i <= 4000; ++i) {
    const Real a = largest_a * pow(Real(i) / 4000, 3);
    const Real fitted = polynomial(m, a) / ((1 + 2 * a * a) * polynomial(m, a) + a * polynomial(n, a));
    const Real error = abs(fitted / scaled_lambda(a) - 1);
    if (error > largest) largest = error;
  }
  return largest;
}

template <class Float>
void write(std::ostream& out, const std::string& type, std::size_t degree) {
  const auto [numerator, denominator] = rounded<Float>(remez(degree));
  out << "/// Relative error of R with these coefficients, before rounding in its evaluation: " << std::setprecision(2)
      << std::scientific << static_cast<double>(largest_error(numerator, denominator)) << ".\n";
  out << "template <>\nstruct BeckmannLambdaFit<" << type << "> {\n";
  const auto list = [&](const char* name, const std::vector<Float>& values) {
    out << "  static constexpr " << type << " " << name << "[] = {";
    for (std::size_t i = 0; i < values.size(); ++i) {
      char text[40];
      std::snprintf(text, sizeof text, sizeof(Float) == 4 ? "%.6a%s" : "%.13a%s", static_cast<double>(values[i]), "");
      std::string literal = text;
      if (sizeof(Float) == 4) literal += "f";
      out << (i ? (i % 4 ? ", " : ",\n      ") : "\n      ") << literal;
    }
    out << "};\n";
  };
  list("numerator", numerator);
  list("denominator", denominator);
  out << "};\n";
}

void write_header(std::ostream& out) {
  out << "/// \\file\n"
         "/// Generated by tests/reference/fit_beckmann_lambda.cpp (target fit-beckmann-lambda). Do not edit.\n"
         "#pragma once\n\n"
         "// clang-format off\n"
         "namespace brdfplot {\n\n"
         "/// N and M of beckmann_lambda.hpp, ascending powers of a, all positive: no term cancels another.\n"
         "template <class Float>\n"
         "struct BeckmannLambdaFit;\n\n";
  write<double>(out, "double", 10);
  out << "\n";
  write<float>(out, "float", 5);
  out << "\n} // namespace brdfplot\n";
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fit-beckmann-lambda HEADER\n";
    return 2;
  }
  try {
    std::ofstream file(argv[1]);
    write_header(file);
    if (!file.flush()) throw std::runtime_error(std::string("cannot write ") + argv[1]);
  } catch (const std::exception& e) {
    std::cerr << "fit-beckmann-lambda: " << e.what() << "\n";
    return 1;
  }
}
