#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"
#include "microfacet/visible_slopes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/erf.hpp>

namespace brdfplot::choice {

namespace {

double erf_inverse(double x) { return boost::math::erf_inv(x); }
float erf_inverse(float x) { return boost::math::erf_inv(x); }
Counted erf_inverse(const Counted& x) {
  ++Counted::operations().transcendentals;
  return {boost::math::erf_inv(x.value())};
}

/// The slope below which a share u of the visible slopes lies, towards the viewer, at unit roughness: by Newton's rule
/// in b = erf(-x), on [-1, erf(cot theta)], from the start that Mitsuba has; a step that leaves the bracket halves it.
struct NewtonSlope {
  int steps;

  template <class T>
  T operator()(const std::array<T, 2>& in) const {
    using std::erf, std::exp, std::max, std::min, std::pow, std::tan;
    const T theta = in[0], v = T(1) - in[1], t = tan(theta), a = T(1) / t;
    const T root = T(std::numbers::inv_sqrtpi);
    const T most = erf(a), all = T(1) + most + root * t * exp(-(a * a));
    const T power = T(1) + theta * (T(-0.876) + theta * (T(0.4265) - T(0.0594) * theta));
    T low = T(-1), high = most, b = most - (T(1) + most) * pow(T(1) - v, power);
    const T end = T(1) - T(1e-6); // where erf^-1 still has digits in float
    for (int k = 0; k < steps; ++k) {
      if (!(b >= low && b <= high)) b = T(0.5) * (low + high);
      const T x = erf_inverse(max(min(b, end), -end));
      const T excess = (T(1) + b + root * t * exp(-(x * x))) / all - v;
      if (excess > T(0))
        high = b;
      else
        low = b;
      b -= excess * all / (T(1) - x * t);
    }
    if (!(b >= low && b <= high)) b = T(0.5) * (low + high);
    return -erf_inverse(max(min(b, end), -end));
  }
};

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
