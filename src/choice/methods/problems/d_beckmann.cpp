#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"
#include "math/kernels/kernels.hpp"

#include <boost/math/constants/constants.hpp>

#include <numbers>

namespace brdfplot::choice {

namespace {

/// Heitz 2014, Eq. 68, with the tangent from the cosine, as shaders have it.
struct PrintedBeckmannDensity {
  template <class T>
  T operator()(const std::array<T, 2>& x) const {
    using std::exp;
    const T alpha2 = x[0] * x[0], mu2 = x[1] * x[1];
    return exp((mu2 - T(1)) / (alpha2 * mu2)) / (T(std::numbers::pi) * alpha2 * mu2 * mu2);
  }
};

Exact exact_beckmann_density(std::span<const double> x) {
  const Real alpha = x[0], mu2 = Real(x[1]) * x[1];
  const Real exponent = (1 - mu2) / (alpha * alpha * mu2);
  return exact_of(Real(exp(Real(-exponent)) / (boost::math::constants::pi<Real>() * alpha * alpha * mu2 * mu2)));
}

/// The kernel at the unit normal of a cosine.
template <class T>
Run<T> beckmann_density_kernel() {
  return [](std::size_t n, const T* const* in, T* out) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto alpha = static_cast<double>(in[0][i]);
      const T z = in[1][i], x = std::sqrt((T(1) - z) * (T(1) + z)), y = T(0);
      kernels::d_beckmann({alpha, alpha}, kernels::Vectors<T>{&x, &y, &z}, out + i, 1);
    }
  };
}

} // namespace

Problem d_beckmann() {
  Problem p{.name = "d_beckmann",
            .doc = "Distribution of normals of Beckmann",
            .source = "Heitz 2014, Eq. 68",
            .inputs = {{"alpha", "roughness", 1e-4, 1, Scale::logarithmic},
                       {"cos_theta", "cosine of the normal to the geometric one", 1e-100, 1}},
            .exact = exact_beckmann_density,
            .least = 0};
  add_formula<2>(p, "printed", "exp((mu^2 - 1) / (alpha^2 mu^2)) / (pi alpha^2 mu^4)", "Heitz 2014, Eq. 68",
                 Kind::printed, PrintedBeckmannDensity{}, {{0.5, 0.5}});
  p.methods.push_back({.name = "kernel",
                       .doc = "the powers of 1 / mu^2 and the exponential only where that is not as good as 0",
                       .source = "Heitz 2014, Eqs. 64, 95",
                       .kind = Kind::kernel,
                       .run = beckmann_density_kernel<double>()});
  p.methods.push_back({.name = "kernel_float",
                       .doc = "the same in double, rounded once",
                       .source = "Heitz 2014, Eqs. 64, 95",
                       .kind = Kind::kernel,
                       .run = beckmann_density_kernel<float>()});
  return p;
}

} // namespace brdfplot::choice
