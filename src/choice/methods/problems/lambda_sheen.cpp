#include "choice/methods/add.hpp"
#include "choice/methods/problems.hpp"
#include "microfacet/distributions/isotropic/sheen.hpp"

namespace brdfplot::choice {

namespace {

/// The fit of the paper: L(x) = a / (1 + b x^c) + d x + e, its parameters between those of r = 0 and r = 1 by
/// (1 - r)^2; Lambda = exp(L(c)) for c < 1/2, else exp(2 L(1/2) - L(1 - c)).
struct ImageworksFit {
  template <class T>
  T operator()(const std::array<T, 2>& in) const {
    using std::exp, std::pow;
    const T r = in[0], c = in[1];
    constexpr double rough[] = {21.5473, 3.82987, 0.19823, -1.97760, -4.32054};
    constexpr double smooth[] = {25.3245, 3.32435, 0.16801, -1.27393, -4.85967};
    const T u = T(1) - r, weight = u * u;
    std::array<T, 5> p;
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = T(rough[k]) + weight * T(smooth[k] - rough[k]);
    const auto l = [&](const T& x) { return p[0] / (T(1) + p[1] * pow(x, p[2])) + p[3] * x + p[4]; };
    if (c < T(0.5)) return exp(l(c));
    return exp(T(2) * l(T(0.5)) - l(T(1) - c));
  }
};

double sheen_lambda(double r, double c) {
  const SheenProfile profile{r};
  const double mu = c / std::sqrt((1 - c) * (1 + c)), a = mu / profile.width();
  return c < 1 ? profile.a_lambda(a) / a : 0;
}

void run_sheen(std::size_t n, const double* const* in, double* out) {
  for (std::size_t i = 0; i < n; ++i) out[i] = sheen_lambda(in[0][i], in[1][i]);
}

} // namespace

Problem lambda_sheen() {
  Problem p{.name = "lambda_sheen",
            .doc = "Smith's Lambda of Imageworks' sheen",
            .source = "Estevez and Kulla 2017; exact: 2F1(-1/2, -1/(2 r); 1; sin^2)",
            .inputs = {{"r", "roughness", 0.01, 1, Scale::logarithmic}, {"cos_theta", "cosine", 1e-3, 1}},
            .exact =
                [](std::span<const double> x) {
                  return Exact{sheen_lambda(x[0], x[1]), 0};
                },
            .methods = {},
            .least = 0,
            .monotone = {0, -1},
            .seen = [](double lambda) { return 1 / (1 + lambda); },
            .seen_as = "G1",
            .exact_error = 1e-12,
            .samples = 4096};
  add_formula<2>(p, "imageworks_2017", "the fit of the paper", "Estevez and Kulla 2017; RTR4, section 9.14",
                 Kind::approximation, ImageworksFit{}, {{{0.3, 0.3}}, {{0.3, 0.7}}});
  p.methods.push_back({.name = "exact",
                       .doc = "the hypergeometric function by its integral; what errors are measured against",
                       .source = "derived; tests/microfacet",
                       .kind = Kind::kernel,
                       .run = Run<double>(run_sheen),
                       .operations = {},
                       .bound = 1e-12});
  return p;
}

} // namespace brdfplot::choice
