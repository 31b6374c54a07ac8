#include "choice/methods/add.hpp"
#include "choice/methods/problems.hpp"
#include "microfacet/beckmann_lambda.hpp"
#include "microfacet/direction_factor.hpp"

#include <algorithm>
#include <numbers>

namespace brdfplot::choice {

namespace {

/// Inputs: a_o, a_i and the azimuth phi between them. G2 = 1 / (1 + max Lambda + lambda min Lambda) (Heitz 2014, Eq.
/// 101) with Smith's Lambda of Beckmann.
template <class T>
T beckmann_by_erfc(const T& a) {
  using std::erfc, std::exp;
  return T(0.5 * std::numbers::inv_sqrtpi) * exp(-(a * a)) / a - T(0.5) * erfc(a);
}

template <class T>
T g2_of(const std::array<T, 3>& x, const T& factor) {
  using std::max, std::min;
  const T o = beckmann_by_erfc(x[0]), i = beckmann_by_erfc(x[1]);
  return T(1) / (T(1) + max(o, i) + factor * min(o, i));
}

/// lambda = 4.41 phi / (4.41 phi + 1).
struct GinnekenG2 {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    const T t = T(4.41) * x[2];
    return g2_of(x, t / (t + T(1)));
  }
};

/// lambda = 1 - exp(-7.3 phi^2).
struct AshikhminG2 {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    using std::exp;
    return g2_of(x, T(1) - exp(T(-7.3) * (x[2] * x[2])));
  }
};

/// lambda = 1: heights alone.
struct HeightsG2 {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    return T(1) / (T(1) + beckmann_by_erfc(x[0]) + beckmann_by_erfc(x[1]));
  }
};

/// G1(o) G1(i).
struct ProductG2 {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    return T(1) / ((T(1) + beckmann_by_erfc(x[0])) * (T(1) + beckmann_by_erfc(x[1])));
  }
};

double fitted_g2(double a_o, double a_i, double phi) {
  const double o = beckmann_lambda(a_o), i = beckmann_lambda(a_i);
  const double factor = fitted_direction_correlation({phi, {a_o, 1}, {a_i, 1}}).lambda;
  return 1 / (1 + std::max(o, i) + factor * std::min(o, i));
}

} // namespace

Problem g2_directions() {
  Problem p{.name = "g2_directions",
            .doc = "G2 by height and direction of Gaussian surfaces; exact: the factor fitted to rays, itself off by "
                   "0.002 RMS",
            .source = "Heitz 2014, Eq. 101; docs/direction_factor.md",
            .inputs = {{"a_o", "cot(theta_o) / alpha", 0.05, 0.8},
                       {"a_i", "cot(theta_i) / alpha", 0.05, 0.8},
                       {"phi", "azimuth between the directions", std::numbers::pi / 36, std::numbers::pi}},
            .exact =
                [](std::span<const double> x) {
                  return Exact{fitted_g2(x[0], x[1], x[2]), 0};
                },
            .methods = {},
            .least = 0,
            .most = 1,
            .exact_error = 0.02,
            .samples = 4096};
  const std::vector<std::array<double, 3>> examples = {{0.3, 0.5, 1.0}};
  add_formula(p, "van_ginneken_1998", "lambda = 4.41 phi / (4.41 phi + 1)", "van Ginneken et al. 1998; RTR4, Eq. 9.30",
              Kind::approximation, GinnekenG2{}, examples);
  add_formula(p, "ashikhmin_2000", "lambda = 1 - exp(-7.3 phi^2)", "Ashikhmin et al. 2000; RTR4, Eq. 9.29",
              Kind::approximation, AshikhminG2{}, examples);
  add_formula(p, "heights", "lambda = 1", "Heitz 2014, Eq. 99", Kind::approximation, HeightsG2{}, examples);
  add_formula(p, "product", "G1(o) G1(i)", "Heitz 2014, Eq. 98", Kind::approximation, ProductG2{}, examples);
  p.methods.push_back({.name = "fitted",
                       .doc = "what errors are measured against",
                       .source = "docs/direction_factor.md",
                       .kind = Kind::fit,
                       .run = Run<double>([](std::size_t n, const double* const* in, double* out) {
                         for (std::size_t k = 0; k < n; ++k) out[k] = fitted_g2(in[0][k], in[1][k], in[2][k]);
                       })});
  return p;
}

} // namespace brdfplot::choice
