/// \file
/// Polynomials in two variables on the unit square, and proofs that they are positive there.
#pragma once

#include <cstddef>
#include <vector>

namespace brdfplot {

/// sum c[j (dx + 1) + i] x^i y^j for i <= dx, j <= dy. In one variable dy = 0.
struct Polynomial {
  std::size_t dx = 0;
  std::size_t dy = 0;
  std::vector<double> c = {0};

  static Polynomial zero(std::size_t dx, std::size_t dy) { return {dx, dy, std::vector<double>((dx + 1) * (dy + 1))}; }
  double& at(std::size_t i, std::size_t j) { return c[j * (dx + 1) + i]; }
  double at(std::size_t i, std::size_t j) const { return c[j * (dx + 1) + i]; }
  double operator()(double x, double y) const;
};

Polynomial operator*(const Polynomial& p, const Polynomial& q);
/// p + factor q.
Polynomial add(const Polynomial& p, const Polynomial& q, double factor = 1);
/// d/dx.
Polynomial derivative_x(const Polynomial& p);

/// p as a polynomial in 1 - x.
Polynomial mirrored_x(const Polynomial& p);

/// n! / (k! (n - k)!), k <= n.
double binomial(std::size_t n, std::size_t k);

/// The Bernstein polynomials of one degree at x, b[k] = C(n, k) x^k (1 - x)^(n - k): the basis in which fits are
/// computed, since its values are in [0, 1] and nearly independent.
void bernstein(std::size_t degree, double x, double* b);

/// The polynomial whose coefficients in the tensor products of Bernstein polynomials are `b`.
Polynomial from_bernstein(std::size_t dx, std::size_t dy, const std::vector<double>& b);

/// Whether p > 0 on all of [0, 1]^2 is proved: the coefficients in the Bernstein basis, whose convex hull holds all
/// values, are positive by more than their rounding, on the square or on the parts of a subdivision. False when p is
/// not positive, and when it is so close to 0 that the subdivision ends before the proof.
bool proved_positive(const Polynomial& p);

} // namespace brdfplot
