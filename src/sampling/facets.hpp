/// \file
/// Random normals of a distribution, as facets cover the ground and as they are seen.
#pragma once

#include "brdf/term.hpp"
#include "sampling/radial_slopes.hpp"

#include <array>
#include <vector>

namespace brdfplot {

/// Three numbers in [0, 1): two for a place, the third for what there is to choose among.
using SamplePoint = std::array<double, 3>;

/// Which of the shares the number u in [0, 1) falls to, and where within it: it becomes that, in [0, 1).
std::size_t chosen(const std::vector<double>& shares, double& u);

/// The facets of a distribution: a sum of components, each in its frame of slopes.
class Facets {
public:
  explicit Facets(const Distribution& distribution);

  /// Whether normals can be drawn as they are seen (see RadialSlopes::visible()).
  bool visible() const;
  const Distribution& distribution() const { return distribution_; }
  const std::vector<Component>& components() const { return components_; }

  /// A normal with the density D(m) (m.g) (1/sr).
  Direction normal(const SamplePoint& point) const;
  /// The area that the facets project towards v, c (1 + Lambda), c > 0 (Heitz 2014, Eq. 41).
  double visible_area(const Direction& v) const;

  /// Normals with the density <v, m> D(m) / visible_area(v), c of v > 0 (Eq. 16).
  class Viewer {
  public:
    Viewer(const Facets& facets, const Direction& v);
    Direction normal(const SamplePoint& point) const;

  private:
    const Facets* facets_;
    Direction v_;
    std::vector<double> shares_; ///< of the visible area
    std::vector<RadialSlopes::Viewer> viewers_;
  };

private:
  Distribution distribution_;
  std::vector<Component> components_;
  std::vector<double> shares_; ///< of the ground
  std::vector<RadialSlopes> slopes_;
};

} // namespace brdfplot
