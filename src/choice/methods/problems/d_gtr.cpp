#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"
#include "microfacet/distributions/isotropic/gtr.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/expm1.hpp>
#include <boost/math/special_functions/log1p.hpp>

#include <cmath>
#include <numbers>

namespace brdfplot::choice {

namespace {

/// RTR4, Eqs. 9.46-9.47, with the three cases of the normalization as they are printed.
struct PrintedGtrDensity {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    using std::log, std::pow;
    const T alpha2 = x[0] * x[0], gamma = x[1], above = alpha2 - T(1);
    T k = T(1);
    if (!(x[0] == T(1)))
      k = gamma == T(1) ? above / log(alpha2) : (gamma - T(1)) * above / (T(1) - pow(alpha2, T(1) - gamma));
    return k / (T(std::numbers::pi) * pow(T(1) + above * (x[2] * x[2]), gamma));
  }
};

/// ln((e^x - 1) / x), of few cancelled digits.
Real exact_log_phi(const Real& x) { return x == 0 ? Real(0) : Real(log(Real(boost::math::expm1(x) / x))); }

Exact exact_gtr_density(std::span<const double> x) {
  const Real alpha = x[0], gamma = x[1], mu = x[2];
  const Real log_alpha2 = 2 * boost::math::log1p(Real(alpha - 1));
  const Real log_k = exact_log_phi(log_alpha2) - exact_log_phi(Real((1 - gamma) * log_alpha2));
  const Real base = 1 - mu * mu + alpha * alpha * mu * mu;
  return exact_of(Real(exp(Real(log_k - gamma * log(base))) / boost::math::constants::pi<Real>()));
}

void gtr_density_kernel(std::size_t n, const double* const* in, double* out) {
  for (std::size_t i = 0; i < n; ++i) {
    const double mu = in[2][i];
    out[i] = std::exp(GtrLobe(in[0][i], in[1][i]).log_density((1 - mu) * (1 + mu), mu * mu));
  }
}

} // namespace

Problem d_gtr() {
  Problem p{.name = "d_gtr",
            .doc = "Distribution of normals of Generalized Trowbridge-Reitz",
            .source = "Akenine-Moller et al. 2018, Eqs. 9.46-9.47",
            .inputs = {{"alpha", "roughness", 1e-3, 10, Scale::logarithmic},
                       {"gamma", "exponent of the tail", 0.1, 10},
                       {"cos_theta", "cosine of the normal to the geometric one", 0, 1}},
            .exact = exact_gtr_density,
            .least = 0};
  add_formula<3>(p, "printed", "k = (gamma - 1) (alpha^2 - 1) / (1 - alpha^(2 (1 - gamma)))",
                 "Akenine-Moller et al. 2018, Eqs. 9.46-9.47", Kind::printed, PrintedGtrDensity{},
                 {{0.5, 1.5, 0.5}, {0.5, 1.0, 0.5}, {1.0, 2.0, 0.5}});
  p.methods.push_back({.name = "kernel",
                       .doc = "k = phi(L) / phi((1 - gamma) L), phi(x) = expm1(x) / x, L = ln alpha^2, in logarithms",
                       .source = "Akenine-Moller et al. 2018, Eqs. 9.46-9.47, rewritten",
                       .kind = Kind::kernel,
                       .run = Run<double>(gtr_density_kernel)});
  return p;
}

} // namespace brdfplot::choice
