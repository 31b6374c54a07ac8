#include "choice/methods/fitted.hpp"

#include "analysis/fit/fit.hpp"
#include "choice/methods/add.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace brdfplot::choice {

namespace {

/// What the code of a fit computes: the projected area c = a at a projected roughness of 1.
struct FittedLambda {
  std::shared_ptr<const FitCode> code;

  template <class T>
  T operator()(const std::array<T, 1>& a) const {
    using std::max;
    const FitTerms<T> terms = code_terms(*code, a[0], T(code->scale), T(0.0));
    return terms.n / max(terms.d, T(1e-30));
  }
};

/// Numbers side by side: a fit whose degrees are not known to the compiler is fast in arrays, as its code would be.
template <class T>
struct Lanes {
  static constexpr std::size_t count = 256 / sizeof(T);
  std::array<T, count> values;

  Lanes() = default;
  explicit Lanes(double value) { values.fill(static_cast<T>(value)); }

  template <class F>
  static Lanes each(const F& f) {
    Lanes out;
    for (std::size_t k = 0; k < count; ++k) out.values[k] = f(k);
    return out;
  }
  friend Lanes operator+(const Lanes& u, const Lanes& v) {
    return each([&](std::size_t k) { return u.values[k] + v.values[k]; });
  }
  friend Lanes operator-(const Lanes& u, const Lanes& v) {
    return each([&](std::size_t k) { return u.values[k] - v.values[k]; });
  }
  friend Lanes operator*(const Lanes& u, const Lanes& v) {
    return each([&](std::size_t k) { return u.values[k] * v.values[k]; });
  }
  friend Lanes operator/(const Lanes& u, const Lanes& v) {
    return each([&](std::size_t k) { return u.values[k] / v.values[k]; });
  }
  friend Lanes max(const Lanes& u, const Lanes& v) {
    return each([&](std::size_t k) { return u.values[k] > v.values[k] ? u.values[k] : v.values[k]; });
  }
};

template <class T>
void run_fit(const FittedLambda& fit, std::size_t n, const T* const* in, T* out) {
  std::array<Lanes<T>, 1> a{Lanes<T>(1.0)};
  for (std::size_t first = 0; first < n; first += Lanes<T>::count) {
    const std::size_t size = std::min(Lanes<T>::count, n - first);
    std::copy_n(in[0] + first, size, a[0].values.begin());
    const Lanes<T> lambda = fit(a);
    std::copy_n(lambda.values.begin(), size, out + first);
  }
}

MaterialDescription material_of(const std::string& distribution) {
  TermDescription term;
  term.name = distribution;
  term.distribution.type = distribution;
  term.distribution.values.set("alpha", 1.0);
  return term;
}

} // namespace

void add_lambda_fits(Problem& problem, const std::string& distribution, const std::vector<double>& tolerances) {
  for (const double tolerance : tolerances) {
    const FitResult result = fit_lambda(material_of(distribution), {.tolerance = tolerance, .fixed = false});
    const std::string bound = "1e" + std::to_string(std::lround(std::log10(tolerance)));
    const FittedLambda fit{std::make_shared<const FitCode>(result.code)};
    add_formula<1>(problem, "fit_" + bound, "a rational within " + bound + " of G1", "brdfplot fit", Kind::fit, fit,
                   {{{1.0}}});
    Method& in_double = problem.methods[problem.methods.size() - 2];
    in_double.run =
        Run<double>([fit](std::size_t n, const double* const* in, double* out) { run_fit(fit, n, in, out); });
    problem.methods.back().run =
        Run<float>([fit](std::size_t n, const float* const* in, float* out) { run_fit(fit, n, in, out); });
  }
}

} // namespace brdfplot::choice
