#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/fitted.hpp"
#include "choice/methods/problems.hpp"
#include "math/kernels/kernels.hpp"

#include <memory>

namespace brdfplot::choice {

namespace {

/// Eq. 72 of a = c / (alpha s), as it is printed.
struct PrintedGgx {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::sqrt;
    return (T(-1) + sqrt(T(1) + T(1) / (x[0] * x[0]))) * T(0.5);
  }
};

/// The same without the difference: 1 / (2 a (a + sqrt(1 + a^2))).
struct RewrittenGgx {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::sqrt;
    const T a = x[0];
    return T(0.5) / (a * (a + sqrt(a * a + T(1))));
  }
};

/// The same of t = 1 / a^2 = alpha^2 tan^2: t / (2 (1 + sqrt(1 + t))).
struct SquaredTangentGgx {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::sqrt;
    const T t = T(1) / (x[0] * x[0]);
    return T(0.5) * t / (T(1) + sqrt(T(1) + t));
  }
};

/// Karis's G1 = 2 c / (c (2 - alpha) + alpha) for small alpha, where it is worst: Lambda = 1 / (2 a).
struct KarisLimit {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    return T(0.5) / x[0];
  }
};

/// Lambda = q(x) / (a (1 + a)), x = a / (1 + a), where q falls from 1/2 to 1/4.
struct TabulatedGgx {
  std::shared_ptr<const Table> table;
  bool cubic;

  template <class T>
  T operator()(const std::array<T, 1>& in) const {
    const T a = in[0];
    const T r = T(1) / (a * (T(1) + a));
    const T x = a * a * r;
    return r * (cubic ? table->cubic(x) : table->linear(x));
  }
};

/// q = a (1 + a) Lambda = (1 + a) / (2 (a + sqrt(1 + a^2))), written in x.
double scaled_ggx(double x) { return 0.5 / (x + std::sqrt((1 - x) * (1 - x) + x * x)); }

Exact exact_ggx(std::span<const double> x) {
  const Real a = x[0];
  return exact_of(Real(1 / (2 * a * (a + sqrt(Real(a * a + 1))))));
}

const std::vector<std::array<double, 1>> ggx_examples = {{1.0}};

void add_ggx_tables(Problem& p) {
  for (const std::size_t steps : {16U, 64U, 256U, 1024U})
    for (const bool cubic : {false, true}) {
      const auto table = std::make_shared<const Table>(steps, scaled_ggx);
      Method method = method_of<double>(std::string(cubic ? "cubic_" : "linear_") + std::to_string(steps),
                                        "a (1 + a) Lambda at " + std::to_string(steps) + " equal steps of a / (1 + a)",
                                        "table", choice::Kind::table, TabulatedGgx{table, cubic}, ggx_examples);
      method.bytes = table->bytes();
      p.methods.push_back(std::move(method));
    }
}

} // namespace

Problem lambda_ggx() {
  Problem p = lambda_of_a("lambda_ggx", "Smith's Lambda of GGX", "Heitz 2014, Eq. 72", 1e8, exact_ggx);
  add_formula(p, "printed", "Eq. 72", "Heitz 2014, Eq. 72", Kind::printed, PrintedGgx{}, ggx_examples);
  const std::string rewritten = "Heitz 2014, Eq. 72, rewritten";
  add_formula(p, "rewritten", "1 / (2 a (a + sqrt(1 + a^2)))", rewritten, Kind::rewritten, RewrittenGgx{},
              ggx_examples);
  add_formula(p, "squared_tangent", "t / (2 (1 + sqrt(1 + t))), t = 1 / a^2", rewritten, Kind::rewritten,
              SquaredTangentGgx{}, ggx_examples);
  const auto like = operations_of(p, "rewritten");
  add_kernel<double>(p, {"kernel", "the kernel of this program", rewritten, Kind::kernel, 4 * 0x1p-52}, like,
                     [](std::size_t n, const double* const* in, double* out) { kernels::lambda_ggx(in[0], out, n); });
  add_kernel<float>(p, {"kernel_float", "the kernel of this program in float", rewritten, Kind::kernel, 4 * 0x1p-23},
                    like,
                    [](std::size_t n, const float* const* in, float* out) { kernels::lambda_ggx(in[0], out, n); });
  add_formula(p, "karis_2013", "1 / (2 a): G1 = 2 c / (c (2 - alpha) + alpha) for small alpha, where it is worst",
              "Karis 2013; RTR4, Eq. 9.44", Kind::approximation, KarisLimit{}, ggx_examples);
  add_lambda_fits(p, "ggx", {1e-3, 1e-4});
  add_ggx_tables(p);
  return p;
}

} // namespace brdfplot::choice
