#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"
#include "math/direction.hpp"

#include <cmath>

namespace brdfplot::choice {

namespace {

/// The horizontal part of the sum of two directions in one plane with the normal, on opposite sides of it: s_o - s_i
/// without a difference of rounded numbers. What the rounding of a direction's own components costs is not asked here.
template <class T>
T across_sum(const T& o, const T& i) {
  using std::sqrt;
  const T sines = sqrt((T(1) - o) * (T(1) + o)) + sqrt((T(1) - i) * (T(1) + i));
  return sines > T(0) ? (i - o) * (i + o) / sines : T(0);
}

/// The sum of both directions over its length.
struct PrintedHalfVector {
  template <class T>
  T operator()(const std::array<T, 2>& c) const {
    using std::sqrt;
    const T x = across_sum(c[0], c[1]), z = c[0] + c[1];
    return z / sqrt(x * x + z * z);
  }
};

/// tan theta_h = (s_o - s_i) / (c_o + c_i), and s_o - s_i = (c_i - c_o) (c_i + c_o) / (s_o + s_i). Of opposite
/// directions, which have none, 0, as half_vector() has it.
Exact exact_half_vector(std::span<const double> c) {
  const Real o = c[0], i = c[1];
  if (o + i == 0) return {};
  const Real sines = sqrt(Real(1 - o * o)) + sqrt(Real(1 - i * i));
  const Real tangent = sines == 0 ? Real(0) : Real((i - o) / sines);
  return exact_of(Real(1 / sqrt(Real(1 + tangent * tangent))));
}

void half_vector_kernel(std::size_t n, const double* const* in, double* out) {
  for (std::size_t k = 0; k < n; ++k) {
    const Direction sum{across_sum(in[0][k], in[1][k]), 0, in[0][k] + in[1][k]};
    out[k] = normalized(sum).z;
  }
}

} // namespace

Problem half_vector() {
  Problem p{.name = "half_vector",
            .doc = "Cosine of the half vector of two directions on opposite sides of the normal",
            .source = "Heitz 2014, Table 1",
            .inputs = {{"cos_o", "cosine of the viewer's direction", 0, 1}, {"cos_i", "of the light's", 0, 1}},
            .exact = exact_half_vector,
            .least = 0,
            .most = 1};
  add_formula<2>(p, "printed", "(o + i) / |o + i|", "Heitz 2014, Table 1", Kind::printed, PrintedHalfVector{},
                 {{0.5, 0.25}});
  p.methods.push_back({.name = "kernel",
                       .doc = "the sum scaled by its largest component before it is squared; 0 where it is 0",
                       .source = "Heitz 2014, Table 1",
                       .kind = Kind::kernel,
                       .run = Run<double>(half_vector_kernel)});
  return p;
}

} // namespace brdfplot::choice
