#include "choice/methods/add.hpp"
#include "choice/methods/problems.hpp"
#include "microfacet/distributions/student_t.hpp"

#include <numbers>

#include <boost/math/special_functions/gamma.hpp>

namespace brdfplot::choice {

namespace {

/// A cubic over a cubic, ascending powers.
template <class T>
T cubics(const double (&n)[4], const double (&d)[4], const T& x) {
  const auto cubic = [&](const double(&c)[4]) { return T(c[0]) + x * (T(c[1]) + x * (T(c[2]) + x * T(c[3]))); };
  return cubic(n) / cubic(d);
}

/// The fit of the paper (Ribardiere et al. 2017, Eqs. 13-15, 22, 23), z = a:
/// Lambda = Gamma(g - 1/2) / (sqrt(pi) Gamma(g)) ((g - 1)^g / (2 g - 3) S1 + sqrt(g - 1) S2) - 1/2. The factor of S1 is
/// taken in logarithms, which the power overflows without; ln Gamma counts as one transcendental function.
struct RibardiereFit {
  template <class T>
  T operator()(const std::array<T, 2>& x) const {
    using std::exp, std::log, std::sqrt;
    const T z = x[0], g = x[1], g1 = g - T(1);
    constexpr double n21[] = {0, 1.066, 2.655, 4.892}, d21[] = {1.038, 2.969, 4.305, 4.418};
    constexpr double n22[] = {14.402, -27.145, 20.574, -2.745}, d22[] = {-30.612, 86.567, -84.341, 29.938};
    constexpr double n23[] = {-129.404, 324.987, -299.305, 93.268}, d23[] = {-92.609, 256.006, -245.663, 86.064};
    constexpr double n24[] = {6.537, 6.074, -0.623, 5.223}, d24[] = {6.538, 6.103, -3.218, 6.347};
    const T s1 = exp(g * log(g1) + (T(1.5) - g) * log(g1 + z * z)) / (z * (T(2) * g - T(3)));
    const T s2 = cubics(n21, d21, z) * (cubics(n22, d22, g) + cubics(n23, d23, g) * cubics(n24, d24, z));
    const T factor = T(std::numbers::inv_sqrtpi) * exp(log_gamma(g - T(0.5)) - log_gamma(g));
    return factor * (s1 + sqrt(g1) * s2) - T(0.5);
  }

  static double log_gamma(double x) { return boost::math::lgamma(x); }
  static float log_gamma(float x) { return boost::math::lgamma(x); }
  static Counted log_gamma(const Counted& x) {
    ++Counted::operations().transcendentals;
    return {boost::math::lgamma(x.value())};
  }
};

double student_t_lambda(double a, double gamma) { return StudentTShape::of_excess(gamma - 1.5).a_lambda(a) / a; }

void run_student_t(std::size_t n, const double* const* in, double* out) {
  for (std::size_t i = 0; i < n; ++i) out[i] = student_t_lambda(in[0][i], in[1][i]);
}

} // namespace

Problem lambda_student_t() {
  Problem p{.name = "lambda_student_t",
            .doc = "Smith's Lambda of Student's t",
            .source = "Ribardiere et al. 2017",
            .inputs = {{"a", "cot(theta) / alpha", 0.01, 50, Scale::logarithmic},
                       {"gamma", "exponent", 1.75, 40, Scale::logarithmic}},
            .exact =
                [](std::span<const double> x) {
                  return Exact{student_t_lambda(x[0], x[1]), 0};
                },
            .methods = {},
            .least = 0,
            .monotone = {-1, -1},
            .seen = [](double lambda) { return 1 / (1 + lambda); },
            .seen_as = "G1",
            .exact_error = 1e-13,
            .samples = 8192};
  add_formula<2>(p, "ribardiere_2017", "the fit of the paper", "Ribardiere et al. 2017, Eqs. 22, 23",
                 Kind::approximation, RibardiereFit{}, {{{1.0, 3.0}}});
  p.methods.push_back({.name = "exact",
                       .doc = "with the incomplete beta function; what errors are measured against",
                       .source = "derived; tests/microfacet",
                       .kind = Kind::kernel,
                       .run = Run<double>(run_student_t),
                       .operations = {},
                       .bound = 1e-13});
  return p;
}

} // namespace brdfplot::choice
