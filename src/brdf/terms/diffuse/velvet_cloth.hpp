/// \file
/// The cloth of The Order: 1886.
#pragma once

#include "brdf/terms/diffuse/flat.hpp"
#include "microfacet/distributions/isotropic/velvet.hpp"

#include <numbers>

namespace brdfplot {

/// rho = (1 - F) albedo / pi + F D / (4 (n.l + n.v - (n.l)(n.v))), F = F(h.l) Schlick's and D the velvet distribution
/// of h (velvet.hpp): without masking, and finite but where both directions graze.
struct VelvetCloth {
  Colour albedo, f0;
  VelvetProfile velvet;

  static constexpr bool is_flat = true;
  static ModelSpec spec();
  static VelvetCloth from(const TermDescription& description) {
    const Values values = completed_values<VelvetCloth>(description);
    return {Colour::from(values, "albedo"), Colour::from(values, "f0"), VelvetProfile::from(values)};
  }

  int channels() const { return channels_of(albedo, f0); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
    const auto factors = [this](std::size_t c) {
      return std::array{(1 - f0.value[c]) * albedo.value[c] * std::numbers::inv_pi, f0.value[c], 1 - f0.value[c]};
    };
    const double over_alpha2 = 1 / (velvet.alpha * velvet.alpha);
    const std::array<double, 5> density = {over_alpha2, velvet.base * std::numbers::inv_pi,
                                           velvet.inverted * std::numbers::inv_pi * over_alpha2};
    evaluate_flat(block, kernels::FlatTerm::velvet, flat_parameters(density, factors), channels(), out);
  }
  VelvetCloth white() const { return {{}, f0, velvet}; }
};

inline ModelSpec VelvetCloth::spec() {
  ModelSpec spec = VelvetProfile::spec();
  spec.type = "velvet_cloth";
  spec.doc = "velvet without masking on a diffuse base";
  spec.source = "Neubelt and Pettineo 2013; Akenine-Moller et al. 2018, Eq. 9.74";
  // A wider inverted Gaussian is a mirror's lobe about the normal, which integrals over the light would have to follow.
  for (ParameterSpec& parameter : spec.parameters) {
    if (parameter.key == "alpha") parameter.bounds = {.min = 0.01, .max = 1};
    if (parameter.key == "roughness") parameter.bounds = {.min = 0.1, .max = 1};
  }
  spec.parameters.push_back(Colour::parameter("albedo", "of the base, of each channel"));
  spec.parameters.push_back(f0_parameter());
  return spec;
}

} // namespace brdfplot
