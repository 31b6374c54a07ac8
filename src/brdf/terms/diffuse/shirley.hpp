/// \file
/// A flat diffuse surface under a mirror, reciprocal.
#pragma once

#include "brdf/terms/diffuse/flat.hpp"

#include <numbers>

namespace brdfplot {

/// rho = 21 / (20 pi) albedo (1 - F0) (1 - (1 - n.l)^5) (1 - (1 - n.v)^5): what enters a Fresnel mirror leaves through
/// it. The factor makes the mean albedo that of what enters.
struct Shirley {
  Colour albedo, f0;

  static constexpr bool is_flat = true;
  static ModelSpec spec() {
    return {.type = "shirley",
            .doc = "diffuse light through a Fresnel mirror, both ways",
            .source = "Shirley et al. 1997; Akenine-Moller et al. 2018, Eq. 9.64",
            .parameters = {Colour::parameter("albedo", "of each channel"), f0_parameter()}};
  }
  static Shirley from(const TermDescription& description) {
    const Values values = completed_values<Shirley>(description);
    return {Colour::from(values, "albedo"), Colour::from(values, "f0")};
  }

  int channels() const { return channels_of(albedo, f0); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
    const auto factors = [this](std::size_t c) {
      return std::array{21.0 / 20 * std::numbers::inv_pi * albedo.value[c] * (1 - f0.value[c]), 0.0, 0.0};
    };
    evaluate_flat(block, kernels::FlatTerm::through_both, flat_parameters({}, factors), channels(), out);
  }
  Shirley white() const { return {{}, f0}; }
};

} // namespace brdfplot
