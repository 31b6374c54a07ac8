/// \file
/// Slopes of one component of a distribution, by their norm: random ones, as facets cover the ground, and as they are
/// seen.
#pragma once

#include "brdf/integrals/components.hpp"
#include "math/kernels/kernels.hpp"
#include "microfacet/visible_slopes.hpp"
#include "sampling/piecewise_density.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace brdfplot {

/// The area that the facets of a component project towards a direction, c (1 + Lambda) without the weight, from the
/// direction as the component's frame sees it.
double visible_area(const Component& component, const Projection& in_frame);
/// The same of n directions, of which the frame sees c and s; s is changed.
void visible_areas(const Component& component, const double* c, double* s, double* areas, std::size_t n);

/// The slopes of a component in its frame, where their density f(r) depends on the norm r alone, 2 pi int f r dr = 1.
/// Where the distribution has no closed form for what is asked, the integrals are taken over ln r in pieces that
/// resolve f r^2 to 1e-14 of the whole (Gauss, 8 nodes). The share of slopes up to any r has an error below 1e-10 on
/// the ground (of a formula, what its own normalisation has), and below 1e-7 as it is seen.
class RadialSlopes {
public:
  explicit RadialSlopes(const Component& component);

  /// Whether slopes as they are seen can be told: their mean is finite, and what lies beyond 1e100 does not matter.
  bool visible() const { return visible_; }

  /// The kernel that mirrors at slopes as they are seen, where there is one.
  const std::optional<kernels::Distribution>& kernel() const { return kernel_; }

  /// The norm of the slopes within which a share u of the ground lies, u in [0, 1).
  double within(double u) const;

  /// Random slopes, seen from a direction of cosine c and sine s in the frame, c > 0: density (c + s x)+ f, x along the
  /// azimuth of the direction. Of the norm by inversion of its own distribution,
  ///   r f(r) h(r), h = int (c + s r cos psi)+ dpsi = 2 (c psi_0 + s r sin psi_0), cos psi_0 = -c / (s r), or 2 pi c;
  /// then of psi by Newton's rule.
  class Viewer {
  public:
    /// `on_disc`: GGX's by Heitz's map of 2018 instead.
    Viewer(const RadialSlopes& slopes, double c, double s, bool on_disc = false);
    UnitSlope operator()(double u1, double u2) const;

  private:
    double c_, s_;
    std::function<UnitSlope(double, double, double, double)> closed_; ///< of c, s, u1, u2
    PiecewiseDensity norms_;                                          ///< over ln r
  };

private:
  std::function<double(double r)> density_;
  std::function<double(double u)> within_;
  std::function<UnitSlope(double, double, double, double)> visible_slope_;
  std::vector<PiecewiseDensity::Piece> pieces_; ///< of f r^2 over ln r
  PiecewiseDensity ground_;
  std::optional<kernels::Distribution> kernel_;
  bool visible_ = true;
};

} // namespace brdfplot
