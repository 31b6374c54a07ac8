#include "microfacet/masking/published_fit.hpp"

#include "microfacet/masking/sheen_fit_coefficients.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <array>
#include <numbers>

namespace brdfplot {

namespace {

using Cubic = std::array<double, 4>; ///< ascending powers

double ratio(const Cubic& above, const Cubic& below, double x) {
  const auto value = [x](const Cubic& k) { return k[0] + x * (k[1] + x * (k[2] + x * k[3])); };
  return value(above) / value(below);
}

/// z 2F1(1/2, gamma - 1/2; 3/2; -z^2 / (gamma - 1)) as F21(z) (F22(gamma) + F23(gamma) F24(z)).
double student_t_s2(double gamma, double z) {
  const double f21 = ratio({0, 1.066, 2.655, 4.892}, {1.038, 2.969, 4.305, 4.418}, z);
  const double f22 = ratio({14.402, -27.145, 20.574, -2.745}, {-30.612, 86.567, -84.341, 29.938}, gamma);
  const double f23 = ratio({-129.404, 324.987, -299.305, 93.268}, {-92.609, 256.006, -245.663, 86.064}, gamma);
  const double f24 = ratio({6.537, 6.074, -0.623, 5.223}, {6.538, 6.103, -3.218, 6.347}, z);
  return f21 * (f22 + f23 * f24);
}

} // namespace

ModelSpec SheenFit::spec() {
  return {.type = "sheen_fit",
          .doc = "published fit of Lambda of `sheen`, for it alone; off by up to 0.33 in G1",
          .source = "Estevez and Kulla 2017"};
}

double SheenFit::masked_area(const Sheen& sheen, const Projection& p) {
  const SheenFitCoefficients k(sheen.profile.alpha);
  const auto l = [&](double x) { return k.a / (1 + k.b * std::pow(x, k.power)) + k.d * x + k.e; };
  const double c = std::fabs(p.c);
  const double below = p.c < 0 ? c : 0;
  return below + c * std::exp(c < 0.5 ? l(c) : 2 * l(0.5) - l(std::max(0.0, 1 - c)));
}

ModelSpec StudentTFit::spec() {
  return {.type = "student_t_fit",
          .doc = "published fit of Lambda of `student_t`, for it alone; off by up to 0.7 % in G1",
          .source = "Ribardiere et al. 2017, Eqs. 13-15, 22-23"};
}

double StudentTFit::masked_area(const StudentT& distribution, const Projection& p) {
  const double gamma = distribution.shape.gamma;
  const double g = gamma - 1;
  const double c = std::fabs(p.c);
  const double z = p.s > 0 ? std::min(c / p.s, 1e50) : 1e50; // where the cubics have their limits
  // (gamma - 1)^gamma (gamma - 1 + z^2)^(3/2 - gamma) as one power: apart they overflow from gamma = 30 on.
  const double s1 = std::sqrt(g) * g / (2 * gamma - 3) * std::exp((1.5 - gamma) * std::log1p(z * z / g));
  const double factor = boost::math::tgamma_delta_ratio(gamma - 0.5, 0.5) * std::numbers::inv_sqrtpi;
  const double below = p.c < 0 ? c : 0;
  return below + factor * (s1 * p.s + std::sqrt(g) * student_t_s2(gamma, z) * c) - 0.5 * c;
}

} // namespace brdfplot
