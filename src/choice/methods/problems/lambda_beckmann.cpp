#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/fitted.hpp"
#include "choice/methods/problems.hpp"
#include "math/kernels/kernels.hpp"
#include "microfacet/beckmann_lambda.hpp"

#include <algorithm>
#include <memory>
#include <numbers>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/erf.hpp>

namespace brdfplot::choice {

namespace {

constexpr double half_over_root_pi = 0.5 * std::numbers::inv_sqrtpi;

/// Eq. 69 as it is printed.
struct PrintedBeckmann {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::erf, std::exp;
    const T a = x[0];
    return T(0.5) * (erf(a) - T(1)) + T(half_over_root_pi) * exp(-(a * a)) / a;
  }
};

/// With erfc in place of erf - 1: one cancellation less.
struct ErfcBeckmann {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::erfc, std::exp;
    const T a = x[0];
    return T(half_over_root_pi) * exp(-(a * a)) / a - T(0.5) * erfc(a);
  }
};

/// e^(-a^2) R(a) / (2 sqrt(pi) a), R = 1 / (1 + 2 a^2 + a N(a) / M(a)): nothing cancels. What the kernel computes,
/// without what that carries of the rounding of a^2.
struct RewrittenBeckmann {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::exp;
    const T a = x[0], square = a * a;
    const T m = polynomial(BeckmannLambdaFit<double>::denominator, a);
    const T n = polynomial(BeckmannLambdaFit<double>::numerator, a);
    return T(half_over_root_pi) * exp(-square) * m / (a * ((T(1) + T(2) * square) * m + a * n));
  }

  template <class T, std::size_t size>
  static T polynomial(const double (&c)[size], const T& x) {
    T value = T(c[size - 1]);
    for (std::size_t i = size - 1; i-- > 0;) value = value * x + T(c[i]);
    return value;
  }
};

/// Walter et al. 2007: G1 = (3.535 a + 2.181 a^2) / (1 + 2.276 a + 2.577 a^2) below 1.6, else 1.
struct WalterBeckmann {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    const T a = x[0];
    if (!(a < T(1.6))) return T(0);
    return (T(1) - T(1.259) * a + T(0.396) * (a * a)) / (T(3.535) * a + T(2.181) * (a * a));
  }
};

/// Lambda = q(x) / a, where q is a table over x = a / 4 and 0 beyond.
struct TabulatedBeckmann {
  static constexpr double end = 4;
  std::shared_ptr<const Table> table;
  bool cubic;

  template <class T>
  T operator()(const std::array<T, 1>& in) const {
    using std::max;
    const T a = in[0];
    if (!(a < T(end))) return T(0);
    const T x = a * T(1 / end);
    return max(cubic ? table->cubic(x) : table->linear(x), T(0)) / a;
  }
};

/// 0.5 erfc and the exponential agree to 1 / (2 a^2): of 50 digits 46 are left at a = 26.
Exact exact_beckmann(std::span<const double> x) {
  const Real a = x[0];
  const Real& root_pi = boost::math::constants::root_pi<Real>();
  return exact_of(Real(exp(Real(-a * a)) / (2 * a * root_pi) - boost::math::erfc(a) / 2));
}

const std::vector<std::array<double, 1>> beckmann_examples = {{1.0}};

void add_beckmann_tables(Problem& p) {
  for (const std::size_t steps : {16U, 64U, 256U, 1024U})
    for (const bool cubic : {false, true}) {
      const auto table =
          std::make_shared<const Table>(steps, [](double x) { return beckmann_a_lambda(TabulatedBeckmann::end * x); });
      Method method = method_of<double>(std::string(cubic ? "cubic_" : "linear_") + std::to_string(steps),
                                        "a Lambda at " + std::to_string(steps) + " equal steps of a up to 4", "table",
                                        choice::Kind::table, TabulatedBeckmann{table, cubic}, beckmann_examples);
      method.bytes = table->bytes();
      p.methods.push_back(std::move(method));
    }
}

/// Walter's kernel is one of c and s: a and 1.
template <class T>
Run<T> walter_run() {
  return [](std::size_t n, const T* const* in, T* out) {
    static const std::vector<T> ones(1024, T(1));
    for (std::size_t i = 0; i < n; i += ones.size())
      kernels::lambda_beckmann_walter(in[0] + i, ones.data(), out + i, std::min(ones.size(), n - i));
  };
}

void add_beckmann_kernels(Problem& p) {
  const auto like = operations_of(p, "rewritten"), like_walter = operations_of(p, "walter_2007");
  const std::string source = "Heitz 2014, Eq. 69, rewritten", walter = "Walter et al. 2007; Heitz 2014, section 5.3";
  add_kernel<double>(
      p, {"kernel", "the kernel of this program", source, Kind::kernel, 4 * 0x1p-52}, like,
      [](std::size_t n, const double* const* in, double* out) { kernels::lambda_beckmann(in[0], out, n); });
  add_kernel<float>(p, {"kernel_float", "the kernel of this program in float", source, Kind::kernel, 4 * 0x1p-23}, like,
                    [](std::size_t n, const float* const* in, float* out) { kernels::lambda_beckmann(in[0], out, n); });
  add_kernel<double>(p, {"walter_kernel", "Walter's rational, the kernel of this program", walter, Kind::approximation},
                     like_walter, walter_run<double>());
  add_kernel<float>(
      p, {"walter_kernel_float", "Walter's rational, the kernel of this program in float", walter, Kind::approximation},
      like_walter, walter_run<float>());
}

} // namespace

Problem lambda_beckmann() {
  Problem p = lambda_of_a("lambda_beckmann", "Smith's Lambda of Beckmann", "Heitz 2014, Eq. 69", 26, exact_beckmann);
  const std::string source = "Heitz 2014, Eq. 69";
  add_formula(p, "printed", "Eq. 69, with erf", source, Kind::printed, PrintedBeckmann{}, beckmann_examples);
  add_formula(p, "erfc", "Eq. 69 with erfc for 1 - erf", source, Kind::rewritten, ErfcBeckmann{}, beckmann_examples);
  add_formula(p, "rewritten", "e^(-a^2) / (2 sqrt(pi) a (1 + 2 a^2 + a U)), U a rational", source + ", rewritten",
              Kind::rewritten, RewrittenBeckmann{}, beckmann_examples);
  add_formula(p, "walter_2007", "a rational below a = 1.6", "Walter et al. 2007; Heitz 2014, section 5.3",
              Kind::approximation, WalterBeckmann{}, beckmann_examples);
  add_beckmann_kernels(p);
  add_lambda_fits(p, "beckmann", {1e-2, 1e-3, 1e-4, 1e-6});
  add_beckmann_tables(p);
  return p;
}

} // namespace brdfplot::choice
