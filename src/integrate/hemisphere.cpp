#include "integrate/hemisphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace brdfplot {

namespace {

using std::numbers::pi;

/// The mean normal, and the azimuth of the viewer about it.
struct Basis {
  Basis(const SlopeMap& map, const Direction& omega_o) : n(normalized({-map.mean_x, -map.mean_y, 1})) {
    const double along = dot(omega_o, n);
    t = omega_o + -along * n;
    const double across = std::sqrt(dot(t, t));
    theta_o = std::atan2(across, along);
    // At the normal any azimuth will do.
    t = across > 1e-8 ? normalized(t) : normalized(Direction{1, 0, 0} + -n.x * n);
    b = {n.y * t.z - n.z * t.y, n.z * t.x - n.x * t.z, n.x * t.y - n.y * t.x};
  }

  Direction direction(double theta, double phi) const {
    return std::cos(theta) * n + (std::sin(theta) * std::cos(phi)) * t + (std::sin(theta) * std::sin(phi)) * b;
  }

  Direction n, t{}, b{};
  double theta_o = 0;
};

} // namespace

Estimate integrate_hemisphere(const SlopeMap& map, bool symmetric, const PairFunction& rho, const Direction& omega_o,
                              double tolerance, const std::function<double(const Direction& omega_i)>& weight) {
  const Basis basis(map, omega_o);
  const std::array<double, 5> turn = {-pi, -0.5 * pi, 0, 0.5 * pi, pi};
  const auto phi_cuts = std::span(turn).subspan(symmetric ? 2 : 0);
  const double copies = symmetric ? 2 : 1;
  // Values are of order 1 / pi over an area of 2 pi: errors of rho c_i add up to less than 2 pi times the largest.
  const Tolerance of_rho{.absolute = 0.01 * tolerance, .relative = std::max(1e-11, 0.02 * tolerance)};
  std::size_t evaluations = 0;
  double worst_rho = 0;
  double worst_ring = 0;
  const auto ring = [&](double theta) {
    const auto along_phi = [&](const double* phi, double* y, std::size_t n) {
      for (std::size_t k = 0; k < n; ++k) {
        const Direction i = basis.direction(theta, phi[k]);
        const double c_i = std::max(0.0, map.project(i).c);
        const double scale = c_i * weight(i) * std::sin(theta);
        const Estimate here = rho(i, of_rho);
        y[k] = here.value * scale;
        worst_rho = std::max(worst_rho, here.error * std::fabs(scale));
        evaluations += here.evaluations;
      }
    };
    return integrate(along_phi, phi_cuts, {.absolute = 0.1 * tolerance / copies});
  };
  const auto along_theta = [&](const double* theta, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      const Estimate estimate = ring(theta[k]);
      y[k] = estimate.value;
      worst_ring = std::max(worst_ring, estimate.error);
    }
  };
  std::vector<double> theta_cuts = {0, 0.5 * pi};
  if (basis.theta_o > 1e-8) theta_cuts.insert(theta_cuts.begin() + 1, basis.theta_o);
  Estimate estimate = integrate(along_theta, theta_cuts, {.absolute = 0.5 * tolerance / copies});
  estimate.value *= copies;
  estimate.error = copies * (estimate.error + 0.5 * pi * worst_ring) + pi * pi * worst_rho;
  estimate.evaluations = evaluations;
  return estimate;
}

} // namespace brdfplot
