#include "sampling/facets.hpp"

#include "microfacet/visible_normals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

std::size_t chosen(const std::vector<double>& shares, double& u) {
  double below = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const bool last = std::all_of(shares.begin() + static_cast<std::ptrdiff_t>(k) + 1, shares.end(),
                                  [](double share) { return share == 0; });
    if (u < below + shares[k] || last) {
      u = std::clamp((u - below) / shares[k], 0.0, 1 - 0x1p-53);
      return k;
    }
    below += shares[k];
  }
  return 0;
}

Facets::Facets(const Distribution& distribution)
    : distribution_(distribution), components_(brdfplot::components(distribution)) {
  for (const Component& component : components_) {
    shares_.push_back(component.weight);
    slopes_.emplace_back(component);
  }
}

bool Facets::visible() const {
  return std::ranges::all_of(slopes_, [](const auto& s) { return s.visible(); });
}

bool Facets::ggx() const {
  return std::ranges::all_of(slopes_, [](const auto& s) { return s.kernel() == kernels::Distribution::ggx; });
}

Direction Facets::normal(const SamplePoint& point) const {
  double rest = point[2];
  const std::size_t k = chosen(shares_, rest);
  const double r = slopes_[k].within(point[0]);
  const double phi = 2 * std::numbers::pi * point[1];
  const auto [x, y] = components_[k].frame.slope(r * std::cos(phi), r * std::sin(phi));
  return normalized({-x, -y, 1});
}

double Facets::visible_area(const Direction& v) const {
  double sum = 0;
  for (const Component& component : components_)
    sum += component.weight * brdfplot::visible_area(component, component.frame.project(v));
  return sum;
}

void Facets::visible_areas(const kernels::Vectors<double>& v, double* areas, std::size_t n) const {
  std::vector<double> c(n), s(n), own(n);
  std::fill_n(areas, n, 0.0);
  for (const Component& component : components_) {
    kernels::project(component.frame.stretch(), v, c.data(), s.data(), n);
    brdfplot::visible_areas(component, c.data(), s.data(), own.data(), n);
    for (std::size_t k = 0; k < n; ++k) areas[k] += component.weight * own[k];
  }
}

namespace {

/// As visible_normal() sees v.
kernels::SeenFrom seen_from(const Component& component, const Direction& v) {
  const auto [x, y] = component.frame.on_unit_surface(v);
  const Projection p = component.frame.project(v);
  const double norm = std::hypot(p.c, p.s);
  return {v.x,
          v.y,
          v.z,
          brdfplot::visible_area(component, p),
          p.c / norm,
          p.s / norm,
          p.s > 0 ? x / p.s : 1,
          p.s > 0 ? y / p.s : 0};
}

} // namespace

Facets::Viewer::Viewer(const Facets& facets, const Direction& v, bool on_disc) : facets_(&facets), v_(v) {
  const double whole = facets.visible_area(v);
  for (std::size_t k = 0; k < facets.components_.size(); ++k) {
    const Component& component = facets.components_[k];
    seen_.push_back(seen_from(component, v));
    shares_.push_back(component.weight * seen_.back().visible_area / whole);
    kernels_.push_back(on_disc ? std::nullopt : facets.slopes_[k].kernel());
    viewers_.emplace_back(facets.slopes_[k], seen_.back().c, seen_.back().s, on_disc);
  }
}

Direction Facets::Viewer::normal(const SamplePoint& point) const {
  double rest = point[2];
  return normal(component(rest), point[0], point[1]);
}

Direction Facets::Viewer::normal(std::size_t component, double u1, double u2) const {
  return visible_normal(facets_->components_[component].frame, v_,
                        [&](double, double) { return viewers_[component](u1, u2); });
}

void Facets::Viewer::mirror(std::size_t component, const double* u1, const double* u2,
                            const kernels::MirroredAtNormals& out, std::size_t n) const {
  kernels::mirror_at_visible_normals(*kernels_[component], facets_->components_[component].frame.stretch(),
                                     seen_[component], u1, u2, out, n);
}

} // namespace brdfplot
