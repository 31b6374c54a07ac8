#include "math/gauss_kronrod.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/legendre.hpp>

#include <algorithm>
#include <limits>

namespace brdfplot {

namespace {

template <std::size_t N>
GaussKronrod<N> make() {
  using Kronrod = boost::math::quadrature::gauss_kronrod<double, N>;
  using Gauss = boost::math::quadrature::gauss<double, N / 2>;
  GaussKronrod<N> rule{};
  constexpr std::size_t middle = N / 2;
  // Boost lists the non-negative half, from the centre outwards; Gauss's nodes are every second one, from the centre
  // where their number is odd.
  for (std::size_t k = 0; k <= middle; ++k) {
    const double g = k % 2 == (middle + 1) % 2 ? Gauss::weights()[k / 2] : 0;
    for (const std::size_t at : {middle + k, middle - k}) {
      rule.x[at] = at < middle ? -Kronrod::abscissa()[k] : Kronrod::abscissa()[k];
      rule.kronrod[at] = Kronrod::weights()[k];
      rule.gauss[at] = g;
      const auto coefficient = [&](int degree) {
        return g * (degree + 0.5) * boost::math::legendre_p(degree, rule.x[at]);
      };
      rule.last[at] = coefficient(N / 2 - 1);
      rule.before_last[at] = coefficient(N / 2 - 2);
    }
  }
  return rule;
}

} // namespace

double RuleSums::error() const {
  double error = std::fabs(kronrod - gauss);
  if (spread > 0) {
    const double ratio = 200 * error / spread;
    error = spread * std::min(1.0, ratio * std::sqrt(ratio));
    const double decay = std::min(1.0, coefficient / spread);
    error = std::max(error, spread * decay * decay * decay);
  }
  return std::max(error, 50 * std::numeric_limits<double>::epsilon() * magnitude);
}

template <std::size_t N>
const GaussKronrod<N>& GaussKronrod<N>::rule() {
  static const GaussKronrod made = make<N>();
  return made;
}

template struct GaussKronrod<15>;
template struct GaussKronrod<21>;
template struct GaussKronrod<31>;
template struct GaussKronrod<61>;

} // namespace brdfplot
