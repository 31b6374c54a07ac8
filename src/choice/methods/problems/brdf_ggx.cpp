#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"
#include "math/kernels/kernels.hpp"

#include <numbers>

#include <boost/math/constants/constants.hpp>

namespace brdfplot::choice {

namespace {

constexpr double brdf_alpha = 0.1;

/// The pair of directions of inputs cos_o, cos_i and cos_phi, the azimuth between them; omega_o lies at y = 0.
template <class T>
struct Pair {
  T o_x, o_z, i_x, i_y, i_z;
};

template <class T>
Pair<T> pair_of(const std::array<T, 3>& x) {
  using std::sqrt;
  const auto sine = [](const T& c) { return sqrt((T(1) - c) * (T(1) + c)); };
  const T s = sine(x[1]);
  return {sine(x[0]), x[0], s * x[2], s * sine(x[2]), x[1]};
}

/// As textbooks write it, and pbrt: the half vector normalised, D and Lambda by tan^2.
struct PrintedBrdf {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    using std::sqrt;
    const Pair<T> p = pair_of(x);
    const T a2 = T(brdf_alpha * brdf_alpha);
    const T hx = p.o_x + p.i_x, hz = p.o_z + p.i_z;
    const T length = sqrt(hx * hx + p.i_y * p.i_y + hz * hz);
    const T c = hz / length, c2 = c * c, tan2 = (T(1) - c2) / c2;
    const T factor = T(1) + tan2 / a2;
    const T d = T(1) / (T(std::numbers::pi) * a2 * (c2 * c2) * (factor * factor));
    const auto lambda = [&](const T& z) {
      const T z2 = z * z;
      return (sqrt(T(1) + a2 * ((T(1) - z2) / z2)) - T(1)) * T(0.5);
    };
    const T g2 = T(1) / (T(1) + lambda(p.o_z) + lambda(p.i_z));
    return d * g2 / (T(4) * p.o_z * p.i_z);
  }
};

/// Without the half vector's length, and with one division: D = alpha^2 h^4 / (pi ((h_x^2 + h_y^2) + alpha^2 h_z^2)^2)
/// for the half vector of length h, and G2 / (c_o c_i) = 2 / (c_i root(c_o) + c_o root(c_i)).
struct OneDivisionBrdf {
  template <class T>
  T operator()(const std::array<T, 3>& x) const {
    using std::sqrt;
    const Pair<T> p = pair_of(x);
    const T a2 = T(brdf_alpha * brdf_alpha);
    const T hx = p.o_x + p.i_x, hz = p.o_z + p.i_z;
    const T across = hx * hx + p.i_y * p.i_y, along = hz * hz;
    const T h2 = across + along, width = across + a2 * along;
    const auto root = [&](const T& c) { return sqrt(a2 + T(1 - brdf_alpha * brdf_alpha) * (c * c)); };
    const T sum = p.i_z * root(p.o_z) + p.o_z * root(p.i_z);
    return T(brdf_alpha * brdf_alpha / (2 * std::numbers::pi)) * (h2 * h2) / (width * width * sum);
  }
};

Exact exact_brdf(std::span<const double> in) {
  const std::array<Real, 3> x = {Real(in[0]), Real(in[1]), Real(in[2])};
  const Pair<Real> p = pair_of(x);
  const Real a2 = Real(brdf_alpha) * brdf_alpha;
  const Real hx = p.o_x + p.i_x, hz = p.o_z + p.i_z;
  const Real across = hx * hx + p.i_y * p.i_y, along = hz * hz;
  const Real h2 = across + along, width = across + a2 * along;
  const auto root = [&](const Real& c) { return Real(sqrt(Real(a2 + (1 - a2) * c * c))); };
  const Real sum = p.i_z * root(p.o_z) + p.o_z * root(p.i_z);
  return exact_of(Real(a2 * h2 * h2 / (2 * boost::math::constants::pi<Real>() * width * width * sum)));
}

/// The directions as vectors, block by block, then the kernel.
template <class T>
void run_brdf_kernel(std::size_t n, const T* const* in, T* out) {
  constexpr std::size_t block = 256;
  std::array<std::array<T, block>, 6> v{};
  for (std::size_t first = 0; first < n; first += block) {
    const std::size_t size = std::min(block, n - first);
    for (std::size_t k = 0; k < size; ++k) {
      const Pair<T> p = pair_of<T>({in[0][first + k], in[1][first + k], in[2][first + k]});
      v[0][k] = p.o_x, v[1][k] = 0, v[2][k] = p.o_z;
      v[3][k] = p.i_x, v[4][k] = p.i_y, v[5][k] = p.i_z;
    }
    kernels::brdf({.alpha_x = brdf_alpha, .alpha_y = brdf_alpha}, kernels::Distribution::ggx,
                  kernels::Shadowing::height_correlated, kernels::Vectors<T>{v[0].data(), v[1].data(), v[2].data()},
                  kernels::Vectors<T>{v[3].data(), v[4].data(), v[5].data()}, out + first, size);
  }
}

} // namespace

Problem brdf_ggx() {
  Problem p{.name = "brdf_ggx",
            .doc = "D G2 / (4 c_o c_i) of GGX, alpha = 0.1",
            .source = "Heitz 2014, Eqs. 29, 71, 72 and 99",
            .inputs = {{"cos_o", "cosine of the viewer", 1e-3, 1},
                       {"cos_i", "cosine of the light", 1e-3, 1},
                       {"cos_phi", "cosine of the azimuth between them", -1, 1}},
            .exact = exact_brdf,
            .methods = {},
            .least = 0,
            .seen = {},
            .samples = 16384};
  const std::vector<std::array<double, 3>> examples = {{0.7, 0.4, -0.3}};
  add_formula(p, "printed", "half vector normalised, D and Lambda by tan^2", "Heitz 2014; Pharr et al. 2023",
              Kind::printed, PrintedBrdf{}, examples);
  add_formula(p, "one_division", "half vector as it is, all divisions one", "Heitz 2014, rewritten", Kind::rewritten,
              OneDivisionBrdf{}, examples);
  const auto like = operations_of(p, "one_division");
  add_kernel<double>(p, {"kernel", "the kernel of this program", "Heitz 2014, rewritten", Kind::kernel, 0}, like,
                     run_brdf_kernel<double>);
  add_kernel<float>(p,
                    {"kernel_float", "the kernel of this program for floats", "Heitz 2014, rewritten", Kind::kernel, 0},
                    like, run_brdf_kernel<float>);
  return p;
}

} // namespace brdfplot::choice
