#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/newton_slope.hpp"
#include "choice/methods/problems.hpp"
#include "microfacet/visible_slopes.hpp"

#include <cmath>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/erf.hpp>

namespace brdfplot::choice {

namespace {

/// T(x) of visible_gaussian() over that of the lower end is 1 - u: Newton's rule in 50 digits, from where the program
/// is.
Exact exact_slope(std::span<const double> in) {
  const Real theta = in[0], u = in[1], c = cos(theta), s = sin(theta);
  const Real& root_pi = boost::math::constants::root_pi<Real>();
  const auto above = [&](const Real& x) { return Real(c * root_pi * boost::math::erfc(x) + s * exp(Real(-x * x))); };
  const Real wanted = (1 - u) * above(Real(-c / s));
  Real x = visible_gaussian(std::cos(in[0]), std::sin(in[0]), in[1]);
  for (int k = 0; k < 3; ++k) x += (above(x) - wanted) / (2 * (c + s * x) * exp(Real(-x * x)));
  return exact_of(x);
}

} // namespace

Problem sample_beckmann() {
  Problem p{.name = "sample_beckmann",
            .doc = "Visible slope of Beckmann below which a share u lies",
            .source = "Heitz and d'Eon 2014",
            .inputs = {{"theta_o", "polar angle of the viewer", 0.02, 1.55}, {"u", "share below", 1e-3, 0.999}},
            .exact = exact_slope,
            .methods = {},
            .monotone = {0, 1},
            .samples = 2048};
  for (const int steps : {0, 1, 2, 3, 5, 8})
    add_formula<2>(p, "newton_" + std::to_string(steps),
                   std::to_string(steps) + " steps in erf(x) from Mitsuba's start", "Heitz and d'Eon 2014; Jakob 2014",
                   Kind::approximation, NewtonSlope{steps}, {{{0.8, 0.3}}, {{0.3, 0.9}}});
  p.methods.push_back({.name = "program",
                       .doc = "steps in x for the logarithm of the share above",
                       .source = "Heitz and d'Eon 2014, in x",
                       .kind = Kind::kernel,
                       .run = Run<double>([](std::size_t n, const double* const* in, double* out) {
                         for (std::size_t k = 0; k < n; ++k)
                           out[k] = visible_gaussian(std::cos(in[0][k]), std::sin(in[0][k]), in[1][k]);
                       })});
  return p;
}

} // namespace brdfplot::choice
