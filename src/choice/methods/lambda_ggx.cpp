#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"
#include "math/kernels/kernels.hpp"

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

Exact exact_ggx(std::span<const double> x) {
  const Real a = x[0];
  return exact_of(Real(1 / (2 * a * (a + sqrt(Real(a * a + 1))))));
}

} // namespace

Problem lambda_ggx() {
  Problem p{.name = "lambda_ggx",
            .doc = "Smith's Lambda of GGX",
            .source = "Heitz 2014, Eq. 72",
            .inputs = {{"a", "cot(theta) / alpha", 1e-4, 1e8, Scale::logarithmic}},
            .exact = exact_ggx,
            .methods = {},
            .least = 0,
            .monotone = {-1},
            .seen = [](double lambda) { return 1 / (1 + lambda); }};
  const std::vector<std::array<double, 1>> examples = {{1.0}};
  p.methods.push_back(
      method_of<double>("printed", "Eq. 72", "Heitz 2014, Eq. 72", Kind::printed, PrintedGgx{}, examples));
  p.methods.push_back(method_of<float>("printed_float", "Eq. 72 in float", "Heitz 2014, Eq. 72", Kind::printed,
                                       PrintedGgx{}, examples));
  p.methods.push_back(method_of<double>("rewritten", "1 / (2 a (a + sqrt(1 + a^2)))", "Heitz 2014, Eq. 72, rewritten",
                                        Kind::rewritten, RewrittenGgx{}, examples));
  p.methods.push_back({.name = "kernel",
                       .doc = "the kernel of this program",
                       .source = "Heitz 2014, Eq. 72, rewritten",
                       .kind = Kind::kernel,
                       .run = Run<double>([](std::size_t n, const double* const* in, double* out) {
                         kernels::lambda_ggx(in[0], out, n);
                       }),
                       .operations = p.methods.back().operations,
                       .bound = 4 * 0x1p-52});
  return p;
}

} // namespace brdfplot::choice
