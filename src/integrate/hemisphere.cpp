#include "integrate/hemisphere.hpp"

#include "math/cubature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
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

ColourEstimate integrate_hemisphere(const SlopeMap& map, const HemisphereIntegrand& f, const Direction& omega_o,
                                    double tolerance, const std::function<double(const Direction& omega_i)>& weight) {
  const Basis basis(map, omega_o);
  // Values are of order 1 / pi over an area of 2 pi: errors of rho c_i add up to less than 2 pi times the largest.
  const Tolerance of_rho{.absolute = 0.01 * tolerance, .relative = std::max(1e-11, 0.02 * tolerance)};
  const double copies = f.symmetric ? 2 : 1;
  double worst = 0;
  std::vector<Direction> lights;
  std::vector<double> errors, values;
  const PlaneFunction integrand = [&](std::size_t, const double* theta, const double* phi, double* out, std::size_t n) {
    std::fill_n(out, f.channels * n, 0.0);
    if (std::isinf(worst)) return; // one rho without an end is enough
    lights.resize(n);
    for (std::size_t k = 0; k < n; ++k) lights[k] = basis.direction(theta[k], phi[k]);
    values.assign(f.channels * n, 0);
    errors.assign(f.channels * n, 0);
    f.rho(lights, of_rho, values, errors);
    for (std::size_t k = 0; k < n; ++k) {
      const Direction& i = lights[k];
      const double cosine = f.times_cosine ? 1 : std::max(0.0, map.project(i).c);
      const double scale = copies * cosine * weight(i) * std::sin(theta[k]);
      for (std::size_t c = 0; c < f.channels; ++c) {
        const double error = errors[c * n + k];
        worst = std::max(worst, std::isinf(error) ? error : error * std::fabs(scale));
        if (!std::isinf(error)) out[c * n + k] = values[c * n + k] * scale;
      }
    }
  };
  std::vector<double> thetas = {0};
  for (const double c : f.bends) thetas.push_back(std::acos(std::clamp(c, -1.0, 1.0)));
  if (f.bends.empty()) thetas.push_back(0.5 * pi);
  if (basis.theta_o > 1e-8) thetas.push_back(basis.theta_o);
  std::ranges::sort(thetas);
  const std::array<double, 5> turn = {-pi, -0.5 * pi, 0, 0.5 * pi, pi};
  const auto phis = std::span(turn).subspan(f.symmetric ? 2 : 0);
  std::vector<Rectangle> rectangles;
  for (std::size_t t = 0; t + 1 < thetas.size(); ++t)
    for (std::size_t p = 0; p + 1 < phis.size(); ++p)
      if (thetas[t] < thetas[t + 1]) rectangles.push_back({thetas[t], thetas[t + 1], phis[p], phis[p + 1]});
  ColourEstimate estimate = integrate_plane(integrand, f.channels, rectangles, {.absolute = 0.5 * tolerance});
  const double area = thetas.back() * (phis.back() - phis.front());
  for (std::size_t c = 0; c < f.channels; ++c) estimate.error[c] += area * worst;
  return estimate;
}

} // namespace brdfplot
