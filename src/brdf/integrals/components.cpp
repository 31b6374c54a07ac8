#include "brdf/integrals/components.hpp"

#include <algorithm>
#include <array>

namespace brdfplot {

double Component::density(const Direction& omega_m) const {
  return weight * std::visit([&](const auto& d) { return d.density(omega_m); }, distribution);
}

void Component::densities(const std::vector<Direction>& omega_m, std::vector<double>& out) const {
  constexpr std::size_t capacity = 64;
  std::array<double, capacity> x, y, z;
  out.resize(omega_m.size());
  for (std::size_t first = 0; first < omega_m.size(); first += capacity) {
    const std::size_t n = std::min(capacity, omega_m.size() - first);
    for (std::size_t k = 0; k < n; ++k) {
      x[k] = omega_m[first + k].x;
      y[k] = omega_m[first + k].y;
      z[k] = omega_m[first + k].z;
    }
    std::visit([&](const auto& d) { d.densities({x.data(), y.data(), z.data()}, &out[first], n); }, distribution);
  }
  for (double& value : out) value *= weight;
}

namespace {

/// The slopes of a distribution, by the factor that its shape or profile says they are wider where it is far from 1.
template <class D>
SlopeMap frame_of(const D& d) {
  SlopeMap frame = d.slopes;
  double factor = 1;
  if constexpr (requires { d.profile.typical_slope(); }) factor = d.profile.typical_slope() / d.slopes.alpha_x;
  if constexpr (requires { d.shape.typical_slope(); }) factor = d.shape.typical_slope();
  frame.alpha_x *= factor;
  frame.alpha_y *= factor;
  return frame;
}

} // namespace

std::vector<Component> components(const Distribution& distribution) {
  return std::visit(
      []<class D>(const D& d) {
        std::vector<Component> all;
        if constexpr (requires { d.parts; }) {
          for (const auto& part : d.parts)
            for (const Component& one : std::visit([](const auto& of) { return components(of); }, part.distribution))
              all.push_back({part.weight * one.weight, one.distribution, one.frame, {}, one.radii});
        } else if constexpr (requires { d.profile.parts(); }) {
          for (const auto& [weight, profile] : d.profile.parts()) {
            const SlopeMap frame{.alpha_x = profile.width(), .alpha_y = profile.width()};
            if (weight > 0) all.push_back({weight, D{frame, profile}, frame, {}});
          }
        } else {
          all.push_back({1, d, frame_of(d), {}});
          if constexpr (requires { d.shape.radii; }) all.back().radii = d.shape.radii;
        }
        for (Component& one : all) one.mesosurface = {d.slopes.mean_x, d.slopes.mean_y};
        return all;
      },
      distribution);
}

bool has_one_mesosurface(const Distribution& distribution) {
  return std::ranges::all_of(components(distribution), &Component::on_mesosurface);
}

} // namespace brdfplot
