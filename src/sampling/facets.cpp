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

Facets::Viewer::Viewer(const Facets& facets, const Direction& v) : facets_(&facets), v_(v) {
  const double whole = facets.visible_area(v);
  for (std::size_t k = 0; k < facets.components_.size(); ++k) {
    const Component& component = facets.components_[k];
    shares_.push_back(component.weight * brdfplot::visible_area(component, component.frame.project(v)) / whole);
    const Projection p = component.frame.project(v);
    const double norm = std::hypot(p.c, p.s);
    viewers_.emplace_back(facets.slopes_[k], p.c / norm, p.s / norm);
  }
}

Direction Facets::Viewer::normal(const SamplePoint& point) const {
  double rest = point[2];
  const std::size_t k = chosen(shares_, rest);
  return visible_normal(facets_->components_[k].frame, v_,
                        [&](double, double) { return viewers_[k](point[0], point[1]); });
}

} // namespace brdfplot
