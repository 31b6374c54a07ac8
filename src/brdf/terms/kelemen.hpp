/// \file
/// The specular part of Kelemen and Szirmay-Kalos.
#pragma once

#include "brdf/integrals/kinks.hpp"
#include "brdf/terms/diffuse/flat.hpp"

namespace brdfplot {

/// rho(o, i) = P(h) F(o.h) / (2 (1 + o.i)) = P F / (4 (o.h)^2) (Kelemen and Szirmay-Kalos 2001, Eq. 3): Cook and
/// Torrance's BRDF with the V-cavities' G2 / (c_o c_i) approximated by 1 / (o.h)^2. A closed form.
///
/// P is the density of the half vector in solid angle, for which the paper takes Beckmann's or Ward's. What it prints
/// for Ward, exp(-tan^2 / m^2) / (pi m^2 cos^3), is `projected`: D(h) (h.g), whose integral is 1. Two more readings
/// are in use: `normalised`, D(h) divided by its integral over solid angle, and `d`, D(h) itself, which renderers take
/// (Unreal's V_Kelemen). Mean albedos differ by up to a quarter.
struct Kelemen2001 {
  Distribution distribution;
  Fresnel fresnel;
  bool with_cosine = true; ///< of the half vector, as a factor of P
  double scale = 1;        ///< of P

  static constexpr bool about_half_vector = true;
  static ModelSpec spec();
  static Kelemen2001 from(const TermDescription& description);

  const Distribution& facets() const { return distribution; }
  HalfVectorKinks kinks(const Direction& omega_o, const ChannelRange& of) const {
    return {fresnel_kinks(fresnel, omega_o, of), false, is_mirrored(distribution, omega_o)};
  }
  int channels() const;
  void evaluate(const PairBlock& pairs, SurfaceBlock& work, const ChannelRows& out) const;
  Kelemen2001 white() const { return {distribution, NoFresnel{}, with_cosine, scale}; }
};

} // namespace brdfplot
