#include "sampling/sphere/cap_points.hpp"

#include <boost/math/special_functions/legendre.hpp>

#include <cmath>
#include <numbers>

namespace brdfplot::sphere {

namespace {

constexpr double pi = std::numbers::pi;

/// Nodes and weights of Gauss and Legendre on [0, 1].
struct UnitRule {
  std::vector<double> x, weight;
};

UnitRule gauss_legendre(std::size_t n) {
  if (n == 1) return {{0.5}, {1}};
  UnitRule rule;
  const auto degree = static_cast<int>(n);
  for (const double zero : boost::math::legendre_p_zeros<double>(degree)) {
    const double slope = boost::math::legendre_p_prime(degree, zero);
    for (const double x : {-zero, zero}) {
      rule.x.push_back(0.5 * (1 + x));
      rule.weight.push_back(1 / ((1 - x) * (1 + x) * slope * slope)); // n is even: no node is 0
    }
  }
  return rule;
}

} // namespace

std::vector<LightPoint> cap_points(double theta, double phi, double radius, std::size_t rings) {
  const Direction middle = from_angles(theta, phi);
  const Direction down = from_angles(theta + pi / 2, phi), side{-std::sin(phi), std::cos(phi), 0};
  const double height = 2 * std::pow(std::sin(radius / 2), 2); // 1 - cos(radius)
  const UnitRule rule = gauss_legendre(rings);
  const std::size_t around = 4 * rings;
  std::vector<LightPoint> out;
  for (std::size_t j = 0; j < rings; ++j) {
    const double drop = rule.x[j] * height; // 1 - cos(angle from the middle)
    const double sine = std::sqrt(drop * (2 - drop));
    for (std::size_t k = 0; k < around; ++k) {
      const double azimuth = 2 * pi * (static_cast<double>(k) + 0.5) / static_cast<double>(around);
      out.push_back({(1 - drop) * middle + (sine * std::cos(azimuth)) * down + (sine * std::sin(azimuth)) * side,
                     2 * pi * height * rule.weight[j] / static_cast<double>(around)});
    }
  }
  return out;
}

} // namespace brdfplot::sphere
