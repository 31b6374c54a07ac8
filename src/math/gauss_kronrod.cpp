#include "math/gauss_kronrod.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/legendre.hpp>

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
      const auto coefficient = [&](std::size_t degree) {
        const auto n = static_cast<int>(degree);
        return rule.kronrod[at] * (n + 0.5) * boost::math::legendre_p(n, rule.x[at]);
      };
      constexpr std::size_t highest = GaussKronrod<N>::last_degree;
      for (std::size_t j = 0; j < 2; ++j) {
        rule.last[j][at] = coefficient(highest - j);
        rule.next_to_last[j][at] = coefficient(highest - 2 - j);
      }
      for (std::size_t j = 0; j < 4; ++j) rule.before[j][at] = coefficient(highest - rule.apart - j);
    }
  }
  for (std::size_t k = 0; k < N; ++k) {
    rule.at_end[k] = 1;
    for (std::size_t j = 0; j < N; ++j)
      if (j != k) rule.at_end[k] *= (1 - rule.x[j]) / (rule.x[k] - rule.x[j]);
  }
  return rule;
}

} // namespace

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
