/// \file
/// The fits of Oren and Nayar as terms.
#pragma once

#include "brdf/oren_nayar.hpp"
#include "brdf/terms/diffuse/flat.hpp"

namespace brdfplot {

/// The closed forms of Oren and Nayar (1994) for V-cavities of diffuse facets (see brdf/oren_nayar.hpp); with an albedo
/// A, `direct` and the first part of `full` are proportional to it, the light that `full` has reflected twice to its
/// square.
struct OrenNayarFits {
  Colour albedo;
  double sigma = 0;
  OrenNayarFit form = OrenNayarFit::full;

  static constexpr bool is_flat = true;
  static ModelSpec spec();
  static OrenNayarFits from(const TermDescription& description);

  int channels() const { return albedo.channels(); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const;
  OrenNayarFits white() const { return {{}, sigma, form}; }
};

} // namespace brdfplot
