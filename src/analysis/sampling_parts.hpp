/// \file
/// What a sampler draws by, one by one, and the cells in which its samples are counted.
#pragma once

#include "brdf/integrals/components.hpp"
#include "integrate/slope_domain.hpp"
#include "math/quadrature.hpp"
#include "sampling/radial_slopes.hpp"
#include "sampling/sampler.hpp"

#include <functional>
#include <vector>

namespace brdfplot {

/// Densities (1/sr) of directions of the light at a fixed viewer.
using LightDensity = std::function<void(const std::vector<Direction>& omega_i, std::vector<double>& out)>;

/// A term of a sampler, or one component of the distribution that a term draws from.
class SamplingPart {
public:
  SamplingPart(const Sampler& sampler, std::size_t lobe, std::size_t component, const Direction& omega_o);

  /// What it adds to the sampler's density.
  void densities(const std::vector<Direction>& omega_i, std::vector<double>& out) const;

  /// The integral of f over the sphere, f about as wide as this part. `tolerance` is absolute.
  Estimate integral(const LightDensity& f, double tolerance) const;

  /// The same where f is 0 below the horizon of the light, and may bend there.
  Estimate lit_integral(const LightDensity& f, double tolerance) const;

  /// Cells of the unit square of the part, wherever omega_i is in it.
  std::size_t cell_count() const;
  std::size_t cell_of(const Direction& omega_i) const;
  /// The integral of f over each cell, by the midpoint rule; its error is how much half as many points differ.
  std::vector<Estimate> integrals_over_cells(const LightDensity& f) const;

private:
  struct Place {
    Direction omega_i;
    double area; ///< solid angle of omega_i for each unit of the square
  };
  /// Where the point of the unit square is; `norm` is that of slopes at u.
  Place place(double u, double norm, double azimuth) const;
  Estimate over_hemisphere(const LightDensity& f, double tolerance) const;
  /// f for each solid angle of the normal that mirrors.
  NormalIntegrand over_normals(const LightDensity& f) const;
  std::vector<double> midpoint_sums(const LightDensity& f, std::size_t midpoints) const;
  const Component* component() const;

  const Sampler& sampler_;
  const Sampler::Lobe& lobe_;
  std::size_t component_;
  Direction omega_o_;
  double share_; ///< of the term
  Direction mean_normal_;
  std::vector<RadialSlopes> slopes_; ///< of the component; none: Lambert's lobe
  std::vector<double> edges_;        ///< of the cells, along u
  std::vector<double> norms_;        ///< of the slopes there
};

std::vector<SamplingPart> parts_of(const Sampler& sampler, const Direction& omega_o);

} // namespace brdfplot
