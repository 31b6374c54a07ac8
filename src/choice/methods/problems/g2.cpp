#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"

namespace brdfplot::choice {

namespace {

/// Inputs: alpha, cos_o, cos_i. The exact one is Smith's G2 of GGX whose heights are correlated (Heitz 2014, Eq. 99).
template <class T>
T lambda_of(const T& alpha, const T& c) {
  using std::sqrt;
  const T square = c * c;
  return (T(-1) + sqrt(T(1) + alpha * alpha * (T(1) - square) / square)) * T(0.5);
}

/// Eqs. 72 and 99 as they are printed.
struct PrintedG2 {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    return T(1) / (T(1) + lambda_of(x[0], x[1]) + lambda_of(x[0], x[2]));
  }
};

/// c (1 + 2 Lambda) = sqrt(alpha^2 + (1 - alpha^2) c^2), so that nothing is divided by c.
struct RootsG2 {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    using std::sqrt;
    const T square = x[0] * x[0], o = x[1], i = x[2];
    const auto root = [&](const T& c) { return sqrt(square + (T(1) - square) * (c * c)); };
    return T(2) * o * i / (i * root(o) + o * root(i));
  }
};

/// G2 = G1(o) G1(i).
struct SeparableG2 {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    using std::sqrt;
    const T square = x[0] * x[0];
    const auto g1 = [&](const T& c) { return T(2) * c / (c + sqrt(square + (T(1) - square) * (c * c))); };
    return g1(x[1]) * g1(x[2]);
  }
};

/// G2 = min(G1(o), G1(i)): both of the more grazing one.
struct MinimumG2 {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    using std::min, std::sqrt;
    const T square = x[0] * x[0], c = min(x[1], x[2]);
    return T(2) * c / (c + sqrt(square + (T(1) - square) * (c * c)));
  }
};

/// G1 = 2 c / (c (2 - alpha) + alpha) of both, multiplied.
struct KarisG2 {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    const T rest = T(2) - x[0];
    const auto g1 = [&](const T& c) { return T(2) * c / (c * rest + x[0]); };
    return g1(x[1]) * g1(x[2]);
  }
};

/// G2 / (4 c_o c_i) = 0.5 / lerp(2 c_o c_i, c_o + c_i, alpha).
struct HammonG2 {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    const T twice = T(2) * x[1] * x[2];
    return twice / (twice + x[0] * (x[1] + x[2] - twice));
  }
};

Exact exact_g2(std::span<const double> x) {
  const Real square = Real(x[0]) * x[0], o = x[1], i = x[2];
  const auto root = [&](const Real& c) { return Real(sqrt(Real(square + (1 - square) * c * c))); };
  return exact_of(Real(2 * o * i / (i * root(o) + o * root(i))));
}

} // namespace

Problem g2() {
  const std::array<double, 2> usual = {0.02, 1};
  Problem p{.name = "g2",
            .doc = "Smith's G2 of GGX, heights correlated",
            .source = "Heitz 2014, Eqs. 72 and 99",
            .inputs = {{"alpha", "roughness", 1e-4, 1, Scale::logarithmic, usual},
                       {"cos_o", "cosine of the viewer", 1e-5, 1, Scale::logarithmic, usual},
                       {"cos_i", "cosine of the light", 1e-5, 1, Scale::logarithmic, usual}},
            .exact = exact_g2,
            .methods = {},
            .least = 0,
            .most = 1,
            .monotone = {-1, 1, 1},
            .seen = {},
            .samples = 16384};
  const std::vector<std::array<double, 3>> examples = {{0.3, 0.7, 0.4}};
  add_formula(p, "printed", "1 / (1 + Lambda(o) + Lambda(i)), Eq. 72 as printed", "Heitz 2014, Eqs. 72 and 99",
              Kind::printed, PrintedG2{}, examples);
  add_formula(p, "roots", "2 c_o c_i / (c_i root(c_o) + c_o root(c_i)), root = sqrt(alpha^2 + (1 - alpha^2) c^2)",
              "Lagarde and de Rousiers 2014; RTR4, Eq. 9.43", Kind::rewritten, RootsG2{}, examples);
  add_formula(p, "separable", "G1(o) G1(i)", "Walter et al. 2007; Heitz 2014, Eq. 98", Kind::approximation,
              SeparableG2{}, examples);
  add_formula(p, "minimum", "min(G1(o), G1(i))", "Heitz 2014, section 6", Kind::approximation, MinimumG2{}, examples);
  add_formula(p, "karis_2013", "2 c / (c (2 - alpha) + alpha) of both, multiplied", "Karis 2013; RTR4, Eq. 9.44",
              Kind::approximation, KarisG2{}, examples);
  add_formula(p, "hammon_2017", "2 c_o c_i / lerp(2 c_o c_i, c_o + c_i, alpha)", "Hammon 2017; RTR4, Eq. 9.45",
              Kind::approximation, HammonG2{}, examples);
  return p;
}

} // namespace brdfplot::choice
