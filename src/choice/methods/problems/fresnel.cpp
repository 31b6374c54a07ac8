#include "microfacet/fresnel.hpp"
#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"
#include "math/kernels/kernels.hpp"

#include <memory>

namespace brdfplot::choice {

namespace {

constexpr double glass = 1.5;
/// Chromium at 550 nm (LLNL/CXRO and Palik, as Mitsuba 0.6 has it).
constexpr double chromium_eta = 3.116, chromium_k = 4.423;

template <class T>
T fifth_power(const T& x) {
  const T square = x * x;
  return square * square * x;
}

/// Fresnel's equations with the cosine of the refracted ray.
struct PrintedDielectric {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::sqrt;
    const T c = x[0], eta = T(glass);
    const T t = sqrt(T(1) - (T(1) - c * c) * T(1 / (glass * glass)));
    const T s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
    return T(0.5) * (s * s + p * p);
  }
};

/// Cook and Torrance 1982: g^2 = eta^2 - 1 + c^2.
struct CookTorranceDielectric {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::sqrt;
    const T c = x[0], g = sqrt(T(glass * glass - 1) + c * c);
    const T sum = g + c, difference = g - c;
    const T s = difference / sum, p = (c * sum - T(1)) / (c * difference + T(1));
    return T(0.5) * (s * s) * (T(1) + p * p);
  }
};

/// F0 + (1 - F0) (1 - c)^5.
struct SchlickFormula {
  double f0;

  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    return T(f0) + T(1 - f0) * fifth_power(T(1) - x[0]);
  }
};

/// The power as 2^((-5.55473 c - 6.98316) c).
struct GaussianSchlick {
  double f0;

  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::exp2;
    const T c = x[0];
    return T(f0) + T(1 - f0) * exp2((T(-5.55473) * c - T(6.98316)) * c);
  }
};

/// Schlick's with another exponent: F0 + (1 - F0) (1 - c)^p.
struct GeneralisedSchlick {
  double f0, exponent;

  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::pow;
    return T(f0) + T(1 - f0) * pow(T(1) - x[0], T(exponent));
  }
};

/// Polynomials of equal degree, the constant of the lower one 1. Both by Horner's rule.
template <std::size_t degree>
struct RationalFresnel {
  std::array<double, degree + 1> above;
  std::array<double, degree> below;

  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    const T c = x[0];
    T n = T(above[degree]), d = T(below[degree - 1]);
    for (std::size_t k = degree; k-- > 0;) {
      n = n * c + T(above[k]);
      d = d * c + (k > 0 ? T(below[k - 1]) : T(1));
    }
    return n / d;
  }
};

/// B(c) - a c (1 - c)^6, B Schlick's.
struct F82Formula {
  double f0, a;

  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    const T c = x[0], u = T(1) - c, power = fifth_power(u);
    return T(f0) + power * (T(1 - f0) - T(a) * c * u);
  }
};

/// With the complex index n = eta + i k: n_t = sqrt(n^2 - sin^2), r_s = (c - n_t) / (c + n_t),
/// r_p = (n^2 c - n_t) / (n^2 c + n_t).
struct ComplexConductor {
  template <class T>
  struct Complex {
    T re, im;
  };
  template <class T>
  static T squared_ratio(const Complex<T>& p, const Complex<T>& q) {
    return (p.re * p.re + p.im * p.im) / (q.re * q.re + q.im * q.im);
  }
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::sqrt;
    const T c = x[0];
    const Complex<T> n2{T(chromium_eta * chromium_eta - chromium_k * chromium_k), T(2 * chromium_eta * chromium_k)};
    const T re = n2.re - (T(1) - c * c);
    const T length = sqrt(re * re + n2.im * n2.im);
    const Complex<T> t{sqrt(T(0.5) * (length + re)), sqrt(T(0.5) * (length - re))};
    const T s = squared_ratio<T>({c - t.re, -t.im}, {c + t.re, t.im});
    const T p = squared_ratio<T>({n2.re * c - t.re, n2.im * c - t.im}, {n2.re * c + t.re, n2.im * c + t.im});
    return T(0.5) * (s + p);
  }
};

/// In real numbers (Born and Wolf 1999, section 14.2, as renderers have it): w = |n^2 - s^2|, q = Re n_t.
struct RealConductor {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::sqrt;
    const T c = x[0], c2 = c * c, s2 = T(1) - c2;
    const T t0 = T(chromium_eta * chromium_eta - chromium_k * chromium_k) - s2;
    const T w = sqrt(t0 * t0 + T(4 * chromium_eta * chromium_eta * chromium_k * chromium_k));
    const T q2 = T(2) * c * sqrt(T(0.5) * (w + t0));
    const T rs = (w + c2 - q2) / (w + c2 + q2);
    const T a = c2 * w + s2 * s2, b = q2 * s2;
    return T(0.5) * rs * (T(1) + (a - b) / (a + b));
  }
};

struct TabulatedFresnel {
  std::shared_ptr<const Table> table;
  bool cubic;

  template <class T>
  T operator()(const std::array<T, 1>& c) const {
    return cubic ? table->cubic(c[0]) : table->linear(c[0]);
  }
};

const std::vector<std::array<double, 1>> fresnel_examples = {{0.5}};

template <class F>
void add_fresnel_tables(Problem& p, const F& reflectance) {
  for (const std::size_t steps : {16U, 64U, 256U})
    for (const bool cubic : {false, true}) {
      const auto table = std::make_shared<const Table>(steps, reflectance);
      Method method = method_of<double>(std::string(cubic ? "cubic_" : "linear_") + std::to_string(steps),
                                        "F at " + std::to_string(steps) + " equal steps of the cosine", "table",
                                        choice::Kind::table, TabulatedFresnel{table, cubic}, fresnel_examples);
      method.bytes = table->bytes();
      p.methods.push_back(std::move(method));
    }
}

/// Fitted to the least largest relative error at 160 Chebyshev points (Lawson's weights), written with nine digits.
template <std::size_t degree>
void add_rational(Problem& p, const RationalFresnel<degree>& fit) {
  const std::string text = std::to_string(degree);
  add_formula(p, "rational_" + text, "polynomials of degree " + text + " over each other", "fitted", Kind::fit, fit,
              fresnel_examples);
}

/// With the exponent that has the least mean square error over the hemisphere, weighted by the cosine.
void add_generalised_schlick(Problem& p, double f0, double exponent) {
  add_formula(p, "generalized_schlick", "Schlick's with a fitted exponent", "Schlick 1994, Eq. 24; RTR4, Eq. 9.18",
              Kind::approximation, GeneralisedSchlick{f0, exponent}, fresnel_examples);
}

Exact exact_dielectric(std::span<const double> x) {
  const Real c = x[0], eta = glass;
  const Real t = sqrt(Real(1 - (1 - c * c) / (eta * eta)));
  const Real s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
  return exact_of(Real((s * s + p * p) / 2));
}

Exact exact_conductor(std::span<const double> x) {
  const Real c = x[0], eta = chromium_eta, k = chromium_k, c2 = c * c, s2 = 1 - c2;
  const Real t0 = eta * eta - k * k - s2;
  const Real w = sqrt(Real(t0 * t0 + 4 * eta * eta * k * k));
  const Real q2 = 2 * c * sqrt(Real((w + t0) / 2));
  const Real rs = (w + c2 - q2) / (w + c2 + q2);
  const Real a = c2 * w + s2 * s2, b = q2 * s2;
  return exact_of(Real(rs / 2 * (1 + (a - b) / (a + b))));
}

Problem fresnel_problem(std::string name, std::string doc, std::string source,
                        std::function<Exact(std::span<const double>)> exact) {
  return {.name = std::move(name),
          .doc = std::move(doc),
          .source = std::move(source),
          .inputs = {{"cos_theta", "cosine of the angle to the facet's normal", 0, 1}},
          .exact = std::move(exact),
          .methods = {},
          .least = 0,
          .most = 1,
          .seen = {},
          .samples = 8192};
}

void add_schlick_kernel(Problem& p, double f0) {
  add_kernel<double>(
      p, {"schlick_kernel", "Schlick's, the kernel of this program", "Schlick 1994, Eq. 24", Kind::approximation, 0},
      operations_of(p, "schlick_1994"), [f0](std::size_t n, const double* const* in, double* out) {
        kernels::reflectance_schlick(in[0], f0, 1, 5, out, n);
      });
}

void add_schlick(Problem& p, double f0) {
  add_formula(p, "schlick_1994", "F0 + (1 - F0) (1 - c)^5", "Schlick 1994, Eq. 24", Kind::approximation,
              SchlickFormula{f0}, fresnel_examples);
  add_formula(p, "gaussian_schlick", "the power as 2^((-5.55473 c - 6.98316) c)", "Lagarde 2012; Karis 2013",
              Kind::approximation, GaussianSchlick{f0}, fresnel_examples);
  add_schlick_kernel(p, f0);
}

} // namespace

Problem fresnel_dielectric() {
  Problem p = fresnel_problem("fresnel_dielectric", "Fresnel's reflectance of a dielectric of index 1.5",
                              "Born and Wolf 1999, section 1.5.2", exact_dielectric);
  p.monotone = {-1};
  const double f0 = (glass - 1) * (glass - 1) / ((glass + 1) * (glass + 1));
  add_formula(p, "printed", "with the cosine of the refracted ray", "Born and Wolf 1999, section 1.5.2", Kind::printed,
              PrintedDielectric{}, fresnel_examples);
  add_formula(p, "cook_torrance", "with g^2 = eta^2 - 1 + c^2", "Cook and Torrance 1982", Kind::rewritten,
              CookTorranceDielectric{}, fresnel_examples);
  add_kernel<double>(p, {"kernel", "the kernel of this program", "Born and Wolf 1999", Kind::kernel, 0},
                     operations_of(p, "printed"), [](std::size_t n, const double* const* in, double* out) {
                       kernels::reflectance_dielectric(in[0], glass, out, n);
                     });
  add_schlick(p, f0);
  add_generalised_schlick(p, f0, 4.9145);
  add_rational<2>(p, {{0.996223561, -1.81069967, 1.28287966}, {3.74569531, 6.92032234}});
  add_rational<3>(p, {{1.00004237, -1.88162518, 1.38960353, 0.0148042478}, {3.93769003, 4.75494468, 3.37854343}});
  add_rational<4>(p, {{0.999999894, -1.51848011, 0.923739349, 0.119895764, 0.305014954},
                      {4.29527614, 6.49619353, 5.42035591, 3.5424186}});
  add_fresnel_tables(p, [](double c) { return dielectric_reflectance(c, glass); });
  return p;
}

Problem fresnel_conductor() {
  Problem p = fresnel_problem("fresnel_conductor", "Fresnel's reflectance of chromium at 550 nm",
                              "Born and Wolf 1999, section 14.2; eta = 3.116, k = 4.423", exact_conductor);
  const double f0 = conductor_reflectance(1, chromium_eta, chromium_k);
  const double f82 = conductor_reflectance(1.0 / 7, chromium_eta, chromium_k) / schlick_reflectance(1.0 / 7, f0, 1, 5);
  add_formula(p, "complex", "with the complex cosine of the refracted ray", "Born and Wolf 1999, section 14.2",
              Kind::printed, ComplexConductor{}, fresnel_examples);
  add_formula(p, "real", "the same in real numbers", "Born and Wolf 1999, section 14.2", Kind::rewritten,
              RealConductor{}, fresnel_examples);
  add_kernel<double>(p, {"kernel", "the kernel of this program", "Born and Wolf 1999", Kind::kernel, 0},
                     operations_of(p, "real"), [](std::size_t n, const double* const* in, double* out) {
                       kernels::reflectance_conductor(in[0], chromium_eta, chromium_k, out, n);
                     });
  add_schlick(p, f0);
  add_formula(p, "f82", "Schlick's minus a c (1 - c)^6, exact at c = 1/7", "Hoffman 2019", Kind::approximation,
              F82Formula{f0, F82Fresnel::coefficient(f0, f82)}, fresnel_examples);
  add_generalised_schlick(p, f0, 31.676);
  add_rational<2>(p, {{0.993209566, -1.51510263, 52.2443434}, {3.79854437, 73.2092382}});
  add_rational<3>(p, {{1.00000283, 0.0309483569, 27.5788051, 0.957550959}, {6.57237972, 30.3772448, 6.94730315}});
  add_rational<4>(
      p, {{1, -0.0884702772, 27.6053063, -2.44143505, 0.117036447}, {6.45225706, 29.6466618, 3.1486595, -0.475385719}});
  add_fresnel_tables(p, [](double c) { return conductor_reflectance(c, chromium_eta, chromium_k); });
  return p;
}

} // namespace brdfplot::choice
