/// \file
/// Measured reflectance of the RGL material database.
#pragma once

#include "brdf/integrals/kinks.hpp"
#include "brdf/term.hpp"

#include <functional>
#include <memory>

namespace brdfplot {

class RglTable;

/// rho of three channels (linear sRGB) from a .bsdf file (see RglTable). The direction that is tabulated, which the
/// file calls incident, is that of the viewer, as renderers have it (Mitsuba, pbrt). A reciprocal BRDF gives the same
/// either way; what is measured and interpolated is reciprocal within its accuracy only.
struct Rgl {
  std::shared_ptr<const RglTable> table;

  static ModelSpec spec();
  static Rgl from(const TermDescription& description);

  int channels() const { return 3; }
  bool isotropic() const;
  void evaluate(const PairBlock& block, SurfaceBlock& work, const ChannelRows& out) const;
  Rgl white() const { return *this; } ///< what of it absorbs is not known
  /// int rho c_i w di over the places of half vectors in the unit square, in which the files resolve what they hold, as
  /// far as the light is above the horizon. The kinks of what is bilinear are where they are, so that it converges
  /// slowly from about 1e-4 on, and says so.
  ColourEstimate reflected_light(const Direction& omega_o, double tolerance, const ChannelRange& channels,
                                 const std::function<double(const Direction& omega_i)>& weight) const;
};

} // namespace brdfplot
