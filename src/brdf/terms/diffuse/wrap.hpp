/// \file
/// Wrap lighting.
#pragma once

#include "brdf/terms/diffuse/flat.hpp"

namespace brdfplot {

/// What stands for rho (n.l)^+ (Akenine-Moller et al. 2018, Eq. 9.71), clamp(x) = min(max(x, 0), 1):
///   printed     albedo / pi clamp(scatter + (n.l)^+) clamp(n.l + w) / (1 + w)
///   ratio       the same with clamp((n.l + w) / (1 + w)), which is 1 at the normal
///   conserving  the same with (n.l + w)^+ / (1 + w)^2, whose integral over all light is at most the albedo
/// Light reaches it from below the horizon, down to n.l = -w. There rho c_i (`brdf_cos`) is what stands above, and rho,
/// which would be that over n.l, is 0; above, rho is that over n.l, without bound at the horizon. Its integrals are
/// over all light. A function of the light alone: not reciprocal.
///
/// In the equation scatter is a colour that tints what is turned away from the light; 1, the default, leaves it out.
struct Wrap {
  enum class Form { printed, ratio, conserving };

  Colour albedo;
  Colour scatter;
  double w = 0;
  Form form = Form::printed;

  static constexpr bool is_flat = true;
  static ModelSpec spec();
  static Wrap from(const TermDescription& description);

  int channels() const { return channels_of(albedo, scatter); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const;
  /// The cosines at which it bends, from the lowest one that light has up.
  std::vector<double> bends() const;
  Wrap white() const { return {{}, scatter, w, form}; }
};

} // namespace brdfplot
