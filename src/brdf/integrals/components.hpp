/// \file
/// The parts of a distribution, each with a frame of slopes of its own.
#pragma once

#include "integrate/slope_frame.hpp"
#include "microfacet/distributions.hpp"

#include <vector>

namespace brdfplot {

/// A distribution D_k in a sum of w_k D_k.
struct Component {
  double weight = 1;
  Distribution distribution;
  SlopeMap frame;              ///< slopes about as wide as those of D_k
  Vec2 mesosurface{};          ///< slope of that of the whole, which may be another than the frame's
  std::vector<double> radii{}; ///< norms in the frame, ascending, at which integrals are to be cut

  bool on_mesosurface() const { return frame.mean_x == mesosurface[0] && frame.mean_y == mesosurface[1]; }

  SlopeFrame seen_from(const Direction& omega_o) const { return {frame, omega_o, mesosurface, radii}; }

  /// w_k D_k (1/sr).
  double density(const Direction& omega_m) const;
  void densities(const std::vector<Direction>& omega_m, std::vector<double>& out) const;
};

/// What a distribution is a sum of: the parts of a mixture, the two of velvet, else itself; with slopes of the size
/// that it has. An integral over the normals is to be taken over each of them in its own frame: each is narrow in one
/// place only, which that frame knows, and no rule sees the peak of a smooth part from the frame of a rough one.
std::vector<Component> components(const Distribution& distribution);

/// Whether all components lie on the mesosurface of the whole.
bool has_one_mesosurface(const Distribution& distribution);

} // namespace brdfplot
