/// \file
/// A flat diffuse surface under what a mirror leaves, once.
#pragma once

#include "brdf/terms/diffuse/flat.hpp"

#include <numbers>

namespace brdfplot {

/// rho = albedo / pi (1 - F(n.l)) or albedo / pi (1 - F(h.l)), F Schlick's. With the normal it is not reciprocal.
struct FresnelLambert {
  Colour albedo, f0;
  bool at_normal = true;

  static constexpr bool is_flat = true;
  static ModelSpec spec() {
    return {.type = "fresnel_lambert",
            .doc = "albedo / pi times 1 - F at the normal or at the half vector",
            .source = "Akenine-Moller et al. 2018, Eqs. 9.62, 9.63",
            .parameters = {Colour::parameter("albedo", "of each channel"),
                           f0_parameter(),
                           {.key = "at",
                            .kind = ParameterKind::choice,
                            .fallback = std::string("normal"),
                            .doc = "normal: F of n.l, which is not reciprocal; half: F of h.l",
                            .choices = {"normal", "half"}}}};
  }
  static FresnelLambert from(const TermDescription& description) {
    const Values values = completed_values<FresnelLambert>(description);
    return {Colour::from(values, "albedo"), Colour::from(values, "f0"), values.text("at") == "normal"};
  }

  int channels() const { return channels_of(albedo, f0); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
    const auto factors = [this](std::size_t c) {
      return std::array{albedo.value[c] * std::numbers::inv_pi * (1 - f0.value[c]), 0.0, 0.0};
    };
    const auto term = at_normal ? kernels::FlatTerm::through_normal : kernels::FlatTerm::through_half;
    evaluate_flat(block, term, flat_parameters({}, factors), channels(), out);
  }
  FresnelLambert white() const { return {{}, f0, at_normal}; }
};

} // namespace brdfplot
