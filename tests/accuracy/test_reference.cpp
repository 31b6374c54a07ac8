/// The choices that the arbiter of the errors rests on: 113 bits suffice, and erf a - 1 may be written -erfc a.
#include "accuracy/directions.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

namespace {

using namespace brdfplot;
using namespace brdfplot::accuracy;
/// Enough for 1 - erf a, a <= 28, by a series whose terms are as large as e^(a^2).
using Fine =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<2600, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;

template <class R>
reference::Stretch<R> convert(const kernels::Stretch& k) {
  return {R(k.alpha_x), R(k.alpha_y), R(k.correlation), R(k.mean_x), R(k.mean_y)};
}

template <class R>
reference::Vector<R> convert(const std::array<double, 3>& v) {
  return {R(v[0]), R(v[1]), R(v[2])};
}

/// Where c is more than rounding (elsewhere the tests do not look), and the series below converges.
bool in_range(const reference::Stretch<Quad>& k, const reference::Vector<Quad>& omega) {
  const Quad c = reference::mesosurface_area(k, omega), s = reference::projected_roughness(k, omega);
  return c > 1e-28 && c < 28 * s;
}

/// By how many ulp of a double the quad result differs from the fine one.
double difference(const Quad& quad, const Fine& fine) {
  if (fine == 0) return quad == 0 ? 0 : 1;
  return static_cast<double>(abs(Fine(Fine(quad) / fine - 1))) * 0x1p53;
}

} // namespace

namespace brdfplot::reference {

/// erf a - 1 itself, by the series of erf: it is independent of the erfc that the other types use.
template <>
Fine lambda_beckmann(const Fine& a) {
  Fine term = a, sum = a;
  for (int n = 1; abs(term) > abs(sum) * ldexp(Fine(1), -2600); ++n) {
    term *= -a * a / n;
    sum += term / (2 * n + 1);
  }
  const Fine root_pi = sqrt(pi<Fine>());
  return (2 * sum / root_pi - 1) / 2 + exp(Fine(-a * a)) / (2 * a * root_pi);
}

} // namespace brdfplot::reference

TEST_CASE("reference: 113 bits are enough for the inputs of the accuracy tests") {
  double largest = 0;
  std::size_t compared = 0;
  for (const char* domain : direction_domains) {
    for (const auto& in : draw_cases<double>(domain, 100)) {
      const auto quad = convert<Quad>(in.stretch);
      const auto fine = convert<Fine>(in.stretch);
      for (std::size_t k = 0; k < 10; ++k) {
        const auto o = convert<Quad>(in.pairs[k].o), i = convert<Quad>(in.pairs[k].i);
        for (const auto model : {reference::Model::beckmann, reference::Model::ggx}) {
          const Quad d = reference::d(model, quad, o);
          if (d < 1e-300) continue;
          largest = std::max(largest, difference(d, reference::d(model, fine, convert<Fine>(in.pairs[k].o))));
          const Quad value = reference::brdf(model, reference::G2Form::height_correlated, quad, o, i);
          const bool plain = in_range(quad, o) && in_range(quad, i);
          if (!plain || value < 1e-300) continue;
          largest = std::max(
              largest, difference(value, reference::brdf(model, reference::G2Form::height_correlated, fine,
                                                         convert<Fine>(in.pairs[k].o), convert<Fine>(in.pairs[k].i))));
          ++compared;
        }
      }
    }
  }
  CHECK(compared > 50);
  CHECK(largest < 0.01);
}

TEST_CASE("reference: known values") {
  const auto close = [](const Quad& x, double value) { return abs(Quad(x / value - 1)) < 1e-15; };
  // mpmath 1.3, 40 digits.
  CHECK(close(reference::lambda_beckmann(Quad(1)), 0.025127270830006111));
  CHECK(close(reference::lambda_beckmann(Quad(5)), 1.4813429336849340e-14));
  CHECK(close(reference::lambda_ggx(Quad(1)), 0.20710678118654752));
  CHECK(close(reference::dielectric(Quad(1), Quad(1.5)), 0.04));
  // At normal incidence ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2); a conductor with k = 0 is a dielectric.
  CHECK(close(reference::conductor(Quad(1), Quad(0.2), Quad(3)), (0.64 + 9) / (1.44 + 9)));
  CHECK(close(reference::conductor(Quad(0.3), Quad(1.5), Quad(0)),
              static_cast<double>(reference::dielectric(Quad(0.3), Quad(1.5)))));
  // atan2(3, -4)
  const Quad phi = reference::azimuth_difference<Quad>({Quad(1), Quad(0), Quad(0)}, {Quad(-4), Quad(3), Quad(0)});
  CHECK(close(phi, 2.4980915447965089));
  CHECK(abs(Quad(sin(phi) / cos(phi) + Quad(0.75))) < 1e-32);
  CHECK(reference::azimuth_difference<Quad>({Quad(0), Quad(0), Quad(1)}, {Quad(1), Quad(0), Quad(0)}) == 0);
}
