#include "brdf/components.hpp"

namespace brdfplot {

const SlopeMap& Component::slopes() const {
  return std::visit([](const auto& d) -> const SlopeMap& { return d.slopes; }, distribution);
}

double Component::density(const Direction& omega_m) const {
  return weight * std::visit([&](const auto& d) { return d.density(omega_m); }, distribution);
}

void Component::densities(const std::vector<Direction>& omega_m, std::vector<double>& out) const {
  const std::size_t n = omega_m.size();
  std::vector<double> x(n), y(n), z(n);
  for (std::size_t k = 0; k < n; ++k) {
    x[k] = omega_m[k].x;
    y[k] = omega_m[k].y;
    z[k] = omega_m[k].z;
  }
  out.resize(n);
  std::visit([&](const auto& d) { d.densities({x.data(), y.data(), z.data()}, out.data(), n); }, distribution);
  for (double& value : out) value *= weight;
}

std::vector<Component> components(const Distribution& distribution) {
  return std::visit(
      []<class D>(const D& d) {
        std::vector<Component> all;
        if constexpr (requires { d.parts; }) {
          for (const auto& part : d.parts)
            for (const Component& one : std::visit([](const auto& of) { return components(of); }, part.distribution))
              all.push_back({part.weight * one.weight, one.distribution});
        } else if constexpr (requires { d.profile.parts(); }) {
          for (const auto& [weight, profile] : d.profile.parts())
            if (weight > 0)
              all.push_back({weight, D{{.alpha_x = profile.width(), .alpha_y = profile.width()}, profile}});
        } else if constexpr (requires { d.profile.typical_slope(); }) {
          const double slope = d.profile.typical_slope();
          all.push_back({1, D{{.alpha_x = slope, .alpha_y = slope}, d.profile}});
        } else {
          all.push_back({1, d});
        }
        return all;
      },
      distribution);
}

} // namespace brdfplot
