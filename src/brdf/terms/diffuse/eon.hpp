/// \file
/// Rough diffuse surfaces after Oren and Nayar, by Fujii and by Portsmouth, Kutz and Hill.
#pragma once

#include "brdf/terms/diffuse/flat.hpp"

namespace brdfplot {

/// rho = albedo / pi A (1 + r s / t), s = l.v - (n.l)(n.v), t = max(n.l, n.v) where s > 0 and 1 elsewhere,
/// A = 1 / (1 + k1 r), k1 = 1/2 - 2/(3 pi).
struct FujiiOrenNayar {
  Colour albedo;
  double roughness = 0;

  static constexpr bool is_flat = true;
  static ModelSpec spec();
  static FujiiOrenNayar from(const TermDescription& description);

  int channels() const { return albedo.channels(); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const;
  FujiiOrenNayar white() const { return {{}, roughness}; }
};

/// FujiiOrenNayar and what it loses: + albedo_ms / pi (1 - E(n.l)) (1 - E(n.v)) / (1 - mean E), albedo_ms = albedo^2
/// mean E / (1 - albedo (1 - mean E)), where 1 - E(mu) = A r B(mu) / pi, with B a sum that does not cancel at grazing,
/// where it vanishes, nor for r = 0. With albedo 1 nothing is lost.
struct Eon {
  Colour albedo;
  double roughness = 0;

  static constexpr bool is_flat = true;
  static ModelSpec spec();
  static Eon from(const TermDescription& description);

  int channels() const { return albedo.channels(); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const;
  Eon white() const { return {{}, roughness}; }
};

} // namespace brdfplot
