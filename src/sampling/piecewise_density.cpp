#include "sampling/piecewise_density.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace brdfplot {

namespace {

constexpr std::size_t nodes = PiecewiseDensity::nodes;
using Curve = std::array<double, nodes>;
using Polynomials = std::array<double, nodes + 1>; ///< P_0 ... P_8 at a point

Polynomials legendre(double t) {
  Polynomials p{1, t};
  for (std::size_t k = 1; k < nodes; ++k) {
    const auto order = static_cast<double>(k);
    p[k + 1] = ((2 * order + 1) * t * p[k] - order * p[k - 1]) / (order + 1);
  }
  return p;
}

/// Gauss's rule on [-1, 1], and the coefficients of Legendre polynomials that values at its nodes give.
struct Rule {
  Curve abscissa{}, weight{};
  std::array<Curve, nodes> coefficient{}; ///< of P_k, the factor of value j

  Rule() {
    using Gauss = boost::math::quadrature::gauss<double, nodes>;
    for (std::size_t k = 0; k < nodes / 2; ++k) {
      const std::size_t left = nodes / 2 - 1 - k, right = nodes / 2 + k;
      abscissa[left] = -Gauss::abscissa()[k];
      abscissa[right] = Gauss::abscissa()[k];
      weight[left] = weight[right] = Gauss::weights()[k];
    }
    for (std::size_t j = 0; j < nodes; ++j) {
      const Polynomials p = legendre(abscissa[j]);
      for (std::size_t k = 0; k < nodes; ++k) coefficient[k][j] = (static_cast<double>(k) + 0.5) * weight[j] * p[k];
    }
  }
};

const Rule& rule() {
  static const Rule made;
  return made;
}

/// The value per unit of q, where x = from + (to - from) q, or q^2 with a root, q = (1 + t) / 2.
double scaled_value(const PiecewiseDensity::Piece& piece, std::size_t k) {
  const double q = 0.5 * (1 + rule().abscissa[k]);
  return piece.values[k] * (piece.to - piece.from) * (piece.root ? 2 * q : 1);
}

/// Where in t the integral of sum c_k P_k(t) / 2 from -1 is `wanted`.
double solved(const Curve& c, double wanted) {
  double low = -1, high = 1, t = std::clamp(2 * wanted / c[0] - 1, -1.0, 1.0);
  for (int step = 0; step < 64; ++step) {
    const Polynomials p = legendre(t);
    double value = c[0], integral = c[0] * (t + 1);
    for (std::size_t k = 1; k < nodes; ++k) {
      value += c[k] * p[k];
      integral += c[k] * (p[k + 1] - p[k - 1]) / (2 * static_cast<double>(k) + 1);
    }
    const double excess = 0.5 * integral - wanted;
    (excess < 0 ? low : high) = t;
    const double next = t - 2 * excess / value;
    const double before = t;
    t = next >= low && next <= high ? next : 0.5 * (low + high);
    if (std::fabs(t - before) < 1e-14) break;
  }
  return t;
}

} // namespace

double PiecewiseDensity::Piece::node(std::size_t k) const {
  const double q = 0.5 * (1 + rule().abscissa[k]);
  return from + (to - from) * (root ? q * q : q);
}

double PiecewiseDensity::Piece::integral() const {
  double sum = 0;
  for (std::size_t k = 0; k < nodes; ++k) sum += 0.5 * rule().weight[k] * scaled_value(*this, k);
  return sum;
}

void PiecewiseDensity::add(const Piece& piece) {
  pieces_.push_back(piece);
  ends_.push_back(total() + piece.integral());
}

double PiecewiseDensity::inverse(double u) const {
  const double wanted = u * total();
  const auto end = std::ranges::upper_bound(ends_, wanted);
  const auto index = static_cast<std::size_t>(std::min(end, ends_.end() - 1) - ends_.begin());
  const Piece& piece = pieces_[index];
  Curve c{};
  for (std::size_t j = 0; j < nodes; ++j) {
    const double value = scaled_value(piece, j);
    for (std::size_t k = 0; k < nodes; ++k) c[k] += rule().coefficient[k][j] * value;
  }
  const double q = 0.5 * (1 + solved(c, wanted - (index > 0 ? ends_[index - 1] : 0)));
  return piece.from + (piece.to - piece.from) * (piece.root ? q * q : q);
}

} // namespace brdfplot
