#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"
#include "math/kernels/kernels.hpp"

#include <cmath>

namespace brdfplot::choice {

namespace {

/// What stands in its place in some renderers.
struct ProductOfRoughnesses {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    using std::sqrt;
    return sqrt(x[0] * x[1]);
  }
};

/// Heitz 2014, Eq. 80.
struct ProjectedRoughness {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    using std::cos, std::sin, std::sqrt;
    const T u = cos(x[2]) * x[0], v = sin(x[2]) * x[1];
    return sqrt(u * u + v * v);
  }
};

Exact exact_alpha_o(std::span<const double> x) {
  const Real u = cos(Real(x[2])) * x[0], v = sin(Real(x[2])) * x[1];
  return exact_of(Real(sqrt(Real(u * u + v * v))));
}

/// s of a horizontal direction.
void alpha_o_kernel(std::size_t n, const double* const* in, double* out) {
  for (std::size_t i = 0; i < n; ++i) {
    const double x = std::cos(in[2][i]), y = std::sin(in[2][i]), z = 0;
    double c = 0;
    kernels::project({in[0][i], in[1][i]}, kernels::Vectors<double>{&x, &y, &z}, &c, out + i, 1);
  }
}

} // namespace

Problem alpha_o() {
  Problem p{.name = "alpha_o",
            .doc = "Roughness projected onto a direction",
            .source = "Heitz 2014, Eq. 80",
            .inputs = {{"alpha_x", "roughness along x", 1e-3, 1, Scale::logarithmic},
                       {"alpha_y", "roughness along y", 1e-3, 1, Scale::logarithmic},
                       {"phi", "azimuth of the direction", 0, 1.5707963267948966}},
            .exact = exact_alpha_o,
            .least = 0};
  add_formula<3>(p, "product", "sqrt(alpha_x alpha_y)", "found in renderers", Kind::printed, ProductOfRoughnesses{},
                 {{0.5, 0.25, 0.5}});
  add_formula<3>(p, "printed", "sqrt((cos phi alpha_x)^2 + (sin phi alpha_y)^2)", "Heitz 2014, Eq. 80", Kind::printed,
                 ProjectedRoughness{}, {{0.5, 0.25, 0.5}});
  p.methods.push_back({.name = "kernel",
                       .doc = "the kernel of this program",
                       .source = "Heitz 2014, Eq. 97",
                       .kind = Kind::kernel,
                       .run = Run<double>(alpha_o_kernel)});
  return p;
}

} // namespace brdfplot::choice
