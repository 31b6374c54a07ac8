#include "sampling/direct_lobe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

/// The matrix ((a, 0, b), (0, c, 0), (d, 0, 1)) from Lambert's lobe, in axes of which x points towards the viewer; and
/// what is left of the lobe, (1 + v) / 2, where the plane of the horizon cuts it.
struct Sheared {
  double a, b, c, d, left;

  Sheared(double mu, double r) {
    a = 1 + r * (0.303392 + (-0.518982 + 0.111709 * mu) * mu + (-0.276266 + 0.335918 * mu) * r);
    b = r * (-1.16407 + 1.15859 * mu + (0.150815 - 0.150105 * mu) * r) / (mu * mu * mu - 1.43545);
    c = 1 + (0.20013 + (-0.506373 + 0.261777 * mu) * mu) * r;
    d = (0.540852 + (-1.01625 + 0.475392 * mu) * mu) * r / (-1.0743 + mu * (0.0725628 + mu));
    left = 0.5 * (1 + 1 / std::sqrt(d * d + 1));
  }

  double determinant() const { return c * (a - b * d); }

  Direction sample(double u1, double u2) const {
    const double radius = std::sqrt(u1), phi = 2 * std::numbers::pi * u2, y = radius * std::sin(phi);
    const double x = -((1 - left) * std::sqrt(1 - y * y) + left * radius * std::cos(phi));
    const double z = std::sqrt(std::fmax(1 - x * x - y * y, 0));
    return {a * x + b * z, c * y, d * x + z};
  }

  double density(const Direction& w) const {
    const Direction h{c * (w.x - b * w.z), (a - b * d) * w.y, -c * (d * w.x - a * w.z)};
    const double ratio = determinant() / dot(h, h);
    return ratio * ratio * std::fmax(h.z, 0) * std::numbers::inv_pi / left;
  }
};

class EonLobe : public DirectLobe {
public:
  explicit EonLobe(double roughness) : roughness_(roughness) {}

  Direction sample(const Direction& omega_o, const SamplePoint& point) const override {
    double choice = point[2];
    if (chosen({uniform_share(omega_o.z), 1 - uniform_share(omega_o.z)}, choice) == 0) {
      const double radius = std::sqrt((1 - point[0]) * (1 + point[0])), phi = 2 * std::numbers::pi * point[1];
      return {radius * std::cos(phi), radius * std::sin(phi), point[0]};
    }
    const auto [x, y] = azimuth(omega_o);
    const Direction w = normalized(Sheared(omega_o.z, roughness_).sample(point[0], point[1]));
    // Rounding may put the rim of the lobe, which is the horizon, below it.
    return {x * w.x - y * w.y, y * w.x + x * w.y, std::fmax(w.z, 0)};
  }

  double density(const Direction& omega_o, const Direction& omega_i) const override {
    if (!(omega_o.z > 0 && omega_i.z >= 0)) return 0;
    const auto [x, y] = azimuth(omega_o);
    const Direction w{x * omega_i.x + y * omega_i.y, x * omega_i.y - y * omega_i.x, omega_i.z};
    const double uniform = uniform_share(omega_o.z);
    return uniform * 0.5 * std::numbers::inv_pi + (1 - uniform) * Sheared(omega_o.z, roughness_).density(w);
  }

private:
  static Vec2 azimuth(const Direction& o) {
    const double s = std::hypot(o.x, o.y);
    return s > 0 ? Vec2{o.x / s, o.y / s} : Vec2{1, 0};
  }
  double uniform_share(double mu) const {
    return std::pow(roughness_, 0.1) * (0.162925 + mu * (-0.372058 + (0.538233 - 0.290822 * mu) * mu));
  }

  double roughness_;
};

} // namespace

std::shared_ptr<const DirectLobe> eon_lobe(double roughness) { return std::make_shared<const EonLobe>(roughness); }

} // namespace brdfplot
