#include "analysis/fit/minimax/polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brdfplot {

namespace {

/// Applies `change` to the coefficients along x of every row, then along y of every column.
template <class Change>
Polynomial along_both(Polynomial p, const Change& change) {
  std::vector<double> line(p.dx + 1);
  for (std::size_t j = 0; j <= p.dy; ++j) {
    for (std::size_t i = 0; i <= p.dx; ++i) line[i] = p.at(i, j);
    change(line);
    for (std::size_t i = 0; i <= p.dx; ++i) p.at(i, j) = line[i];
  }
  line.resize(p.dy + 1);
  for (std::size_t i = 0; i <= p.dx; ++i) {
    for (std::size_t j = 0; j <= p.dy; ++j) line[j] = p.at(i, j);
    change(line);
    for (std::size_t j = 0; j <= p.dy; ++j) p.at(i, j) = line[j];
  }
  return p;
}

/// Powers to Bernstein: b_k = sum_i C(k, i) / C(n, i) c_i.
void to_bernstein(std::vector<double>& line) {
  const std::size_t n = line.size() - 1;
  std::vector<double> out(n + 1);
  for (std::size_t k = 0; k <= n; ++k)
    for (std::size_t i = 0; i <= k; ++i) out[k] += binomial(k, i) / binomial(n, i) * line[i];
  line = out;
}

/// Bernstein to powers: c_i = sum_k (-1)^(i - k) C(n, i) C(i, k) b_k.
void to_powers(std::vector<double>& line) {
  const std::size_t n = line.size() - 1;
  std::vector<double> out(n + 1);
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t k = 0; k <= i; ++k) out[i] += ((i - k) % 2 ? -1 : 1) * binomial(n, i) * binomial(i, k) * line[k];
  line = out;
}

/// De Casteljau at 1/2: the coefficients on both halves, along x or along y.
std::pair<Polynomial, Polynomial> halves(const Polynomial& b, bool along_x) {
  Polynomial left = b;
  Polynomial right = b;
  const std::size_t n = along_x ? b.dx : b.dy;
  const std::size_t lines = along_x ? b.dy : b.dx;
  std::vector<double> line(n + 1);
  for (std::size_t l = 0; l <= lines; ++l) {
    const auto entry = [&](Polynomial& p, std::size_t k) -> double& { return along_x ? p.at(k, l) : p.at(l, k); };
    for (std::size_t k = 0; k <= n; ++k) line[k] = along_x ? b.at(k, l) : b.at(l, k);
    for (std::size_t level = 0; level <= n; ++level) {
      entry(left, level) = line[0];
      entry(right, n - level) = line[n - level];
      for (std::size_t k = 0; k + level < n; ++k) line[k] = 0.5 * (line[k] + line[k + 1]);
    }
  }
  return {left, right};
}

bool positive(const Polynomial& b, double rounding, int depth) {
  if (*std::ranges::min_element(b.c) > rounding) return true;
  for (const std::size_t i : {std::size_t{0}, b.dx})
    for (const std::size_t j : {std::size_t{0}, b.dy})
      if (!(b.at(i, j) > rounding)) return false; // the value of p in a corner
  if (depth == 0) return false;
  const bool along_x = b.dy == 0 || (b.dx > 0 && depth % 2 == 0);
  const auto [left, right] = halves(b, along_x);
  return positive(left, rounding, depth - 1) && positive(right, rounding, depth - 1);
}

} // namespace

double binomial(std::size_t n, std::size_t k) {
  double value = 1;
  for (std::size_t i = 1; i <= k; ++i) value = value * static_cast<double>(n - k + i) / static_cast<double>(i);
  return value;
}

double Polynomial::operator()(double x, double y) const {
  double value = 0;
  for (std::size_t i = dx + 1; i-- > 0;) {
    double coefficient = 0;
    for (std::size_t j = dy + 1; j-- > 0;) coefficient = coefficient * y + at(i, j);
    value = value * x + coefficient;
  }
  return value;
}

Polynomial operator*(const Polynomial& p, const Polynomial& q) {
  Polynomial out = Polynomial::zero(p.dx + q.dx, p.dy + q.dy);
  for (std::size_t j = 0; j <= p.dy; ++j)
    for (std::size_t i = 0; i <= p.dx; ++i)
      for (std::size_t l = 0; l <= q.dy; ++l)
        for (std::size_t k = 0; k <= q.dx; ++k) out.at(i + k, j + l) += p.at(i, j) * q.at(k, l);
  return out;
}

Polynomial add(const Polynomial& p, const Polynomial& q, double factor) {
  Polynomial out = Polynomial::zero(std::max(p.dx, q.dx), std::max(p.dy, q.dy));
  for (std::size_t j = 0; j <= p.dy; ++j)
    for (std::size_t i = 0; i <= p.dx; ++i) out.at(i, j) += p.at(i, j);
  for (std::size_t j = 0; j <= q.dy; ++j)
    for (std::size_t i = 0; i <= q.dx; ++i) out.at(i, j) += factor * q.at(i, j);
  return out;
}

Polynomial derivative_x(const Polynomial& p) {
  Polynomial out = Polynomial::zero(p.dx > 0 ? p.dx - 1 : 0, p.dy);
  for (std::size_t j = 0; j <= p.dy; ++j)
    for (std::size_t i = 1; i <= p.dx; ++i) out.at(i - 1, j) = static_cast<double>(i) * p.at(i, j);
  return out;
}

Polynomial mirrored_x(const Polynomial& p) {
  Polynomial out = Polynomial::zero(p.dx, p.dy);
  for (std::size_t j = 0; j <= p.dy; ++j)
    for (std::size_t i = 0; i <= p.dx; ++i)
      for (std::size_t k = 0; k <= i; ++k) out.at(k, j) += (k % 2 ? -1 : 1) * binomial(i, k) * p.at(i, j);
  return out;
}

void bernstein(std::size_t degree, double x, double* b) {
  b[0] = 1;
  for (std::size_t n = 1; n <= degree; ++n) {
    b[n] = x * b[n - 1];
    for (std::size_t k = n - 1; k > 0; --k) b[k] = x * b[k - 1] + (1 - x) * b[k];
    b[0] *= 1 - x;
  }
}

Polynomial from_bernstein(std::size_t dx, std::size_t dy, const std::vector<double>& b) {
  return along_both({dx, dy, b}, to_powers);
}

bool proved_positive(const Polynomial& p) {
  double size = 0;
  for (const double c : p.c) size += std::fabs(c);
  // A coefficient is a sum of less than 1000 products, each within 20 roundings, of numbers below `size`.
  const double rounding = 1e-13 * size;
  return positive(along_both(p, to_bernstein), rounding, 24);
}

} // namespace brdfplot
