/// \file
/// Random normals of a distribution, as facets cover the ground and as they are seen.
#pragma once

#include "brdf/term.hpp"
#include "math/kernels/sampling.hpp"
#include "sampling/radial_slopes.hpp"

#include <array>
#include <optional>
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
  /// Whether all components are GGX.
  bool ggx() const;
  const Distribution& distribution() const { return distribution_; }
  const std::vector<Component>& components() const { return components_; }

  /// A normal with the density D(m) (m.g) (1/sr).
  Direction normal(const SamplePoint& point) const;
  /// The area that the facets project towards v, c (1 + Lambda), c > 0 (Heitz 2014, Eq. 41).
  double visible_area(const Direction& v) const;
  /// The same of n directions.
  void visible_areas(const kernels::Vectors<double>& v, double* areas, std::size_t n) const;

  /// Normals with the density <v, m> D(m) / visible_area(v), c of v > 0 (Eq. 16).
  class Viewer {
  public:
    /// `on_disc`: all components are GGX, and drawn by Heitz's map of 2018.
    Viewer(const Facets& facets, const Direction& v, bool on_disc = false);
    Direction normal(const SamplePoint& point) const;

    std::size_t components() const { return shares_.size(); }
    /// The component that the number u in [0, 1) falls to; see chosen().
    std::size_t component(double& u) const { return chosen(shares_, u); }
    /// A normal of a component, from the point (u1, u2) of the unit square.
    Direction normal(std::size_t component, double u1, double u2) const;
    /// Whether there is a kernel that mirrors at a component's normals.
    bool has_kernel(std::size_t component) const { return kernels_[component].has_value(); }
    /// v mirrored at normal(component, u1, u2) of each pair, with its density where the component is the only one.
    void mirror(std::size_t component, const double* u1, const double* u2, const kernels::MirroredAtNormals& out,
                std::size_t n) const;

  private:
    const Facets* facets_;
    Direction v_;
    std::vector<double> shares_; ///< of the visible area
    std::vector<RadialSlopes::Viewer> viewers_;
    std::vector<std::optional<kernels::Distribution>> kernels_;
    std::vector<kernels::SeenFrom> seen_;
  };

private:
  Distribution distribution_;
  std::vector<Component> components_;
  std::vector<double> shares_; ///< of the ground
  std::vector<RadialSlopes> slopes_;
};

} // namespace brdfplot
