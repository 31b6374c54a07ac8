#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"
#include "math/kernels/kernels.hpp"

#include <boost/math/constants/constants.hpp>

#include <numbers>

namespace brdfplot::choice {

namespace {

/// The denominator as shaders have it.
struct PrintedGgxDensity {
  template <class T>
  T operator()(const std::array<T, 2>& x) const {
    const T alpha2 = x[0] * x[0];
    const T d = T(1) + x[1] * x[1] * (alpha2 - T(1));
    return alpha2 / (T(std::numbers::pi) * d * d);
  }
};

/// The same as a sum of two squares, sin^2 + (alpha cos)^2.
struct RewrittenGgxDensity {
  template <class T>
  T operator()(const std::array<T, 2>& x) const {
    const T ac = x[0] * x[1];
    const T d = ((T(1) - x[1]) * (T(1) + x[1]) + ac * ac) / x[0];
    return T(1) / (T(std::numbers::pi) * d * d);
  }
};

Exact exact_ggx_density(std::span<const double> x) {
  const Real alpha = x[0], mu = x[1];
  const Real d = (1 - mu * mu + alpha * alpha * mu * mu) / alpha;
  return exact_of(Real(1 / (boost::math::constants::pi<Real>() * d * d)));
}

/// The kernel at the unit normal of a cosine.
template <class T>
Run<T> ggx_density_kernel() {
  return [](std::size_t n, const T* const* in, T* out) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto alpha = static_cast<double>(in[0][i]);
      const T z = in[1][i], x = std::sqrt((T(1) - z) * (T(1) + z)), y = T(0);
      kernels::d_ggx({alpha, alpha}, kernels::Vectors<T>{&x, &y, &z}, out + i, 1);
    }
  };
}

} // namespace

Problem d_ggx() {
  Problem p{.name = "d_ggx",
            .doc = "Distribution of normals of GGX",
            .source = "Walter et al. 2007, Eq. 33",
            .inputs = {{"alpha", "roughness", 1e-6, 1, Scale::logarithmic},
                       {"cos_theta", "cosine of the normal to the geometric one", 1e-30, 1}},
            .exact = exact_ggx_density,
            .methods = {},
            .least = 0,
            .monotone = {0, 1},
            .seen = {}};
  const std::string printed = "alpha^2 / (pi (1 + mu^2 (alpha^2 - 1))^2)",
                    rewritten = "1 / (pi (((1 - mu) (1 + mu) + (alpha mu)^2) / alpha)^2)",
                    source = "Walter et al. 2007, Eq. 33";
  const std::vector<std::array<double, 2>> examples = {{0.5, 0.5}};
  p.methods.push_back(method_of<double>("printed", printed, source, Kind::printed, PrintedGgxDensity{}, examples));
  p.methods.push_back(
      method_of<float>("printed_float", printed + " in float", source, Kind::printed, PrintedGgxDensity{}, examples));
  p.methods.push_back(method_of<double>("rewritten", rewritten, source + ", rewritten", Kind::rewritten,
                                        RewrittenGgxDensity{}, examples));
  p.methods.push_back(method_of<float>("rewritten_float", rewritten + " in float", source + ", rewritten",
                                       Kind::rewritten, RewrittenGgxDensity{}, examples));
  p.methods.push_back({.name = "kernel",
                       .doc = "the kernel of this program",
                       .source = "Heitz 2014, Eqs. 64, 95",
                       .kind = Kind::kernel,
                       .run = ggx_density_kernel<double>()});
  p.methods.push_back({.name = "kernel_float",
                       .doc = "the kernel of this program, in double and rounded once",
                       .source = "Heitz 2014, Eqs. 64, 95",
                       .kind = Kind::kernel,
                       .run = ggx_density_kernel<float>()});
  return p;
}

} // namespace brdfplot::choice
