/// \file
/// Light of further bounces as a multiple of the first.
#pragma once

#include "brdf/integrals/term_albedo.hpp"
#include "brdf/terms/diffuse/flat.hpp"
#include "brdf/terms/mirror.hpp"

namespace brdfplot {

/// rho = rho_1 f0 (1 - E(o)) / E(o) for each channel, rho_1 a term `mirror`, E its directional albedo with F = 1 and f0
/// its Fresnel term at normal incidence (Turquin 2019, Eqs. 14, 16, with f0 for the mean of F). Beside rho_1 it stands
/// for what the microsurface reflects more than once: of the shape of the first bounce, where multiple_bounce is flat.
/// With F = 1 both together have an albedo of 1. Not reciprocal.
///
/// E is a table with an error of about 1e-8, anisotropic 3e-7 (term_albedo.hpp).
struct Turquin {
  Mirror first;
  TermAlbedo white_albedo;
  Colour f0;

  static constexpr bool of_another = true;
  static constexpr bool about_half_vector = true;
  static ModelSpec spec() {
    return {.type = "turquin",
            .doc = "what another term's microsurface reflects more than once: rho f0 (1 - E_o) / E_o",
            .source = "Turquin 2019, Eqs. 14, 16"};
  }
  static Turquin from(const TermDescription& description);

  const Distribution& facets() const { return first.facets(); }
  HalfVectorKinks kinks(const Direction& omega_o, const ChannelRange& of) const { return first.kinks(omega_o, of); }
  int channels() const { return first.channels(); }
  void evaluate(const PairBlock& pairs, SurfaceBlock& work, const ChannelRows& out) const;
  Turquin white() const { return {first.white(), white_albedo, {}}; }
};

} // namespace brdfplot
