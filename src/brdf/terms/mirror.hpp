/// \file
/// Facets that are mirrors.
#pragma once

#include "brdf/integrals/kinks.hpp"
#include "brdf/term.hpp"

namespace brdfplot {

/// rho(o, i) = F(o.h) D(h) G2(o, i, h) / (4 c_o c_i) (Heitz 2014, Eq. 29), h the half vector and c the projected area
/// of the mesosurface. A closed form, by whole kernels where there are.
struct Mirror {
  Microsurface surface;
  Fresnel fresnel;

  static constexpr bool about_half_vector = true;
  static ModelSpec spec() {
    return {.type = "mirror",
            .doc = "facets that are mirrors: F D G2 / (4 c_o c_i)",
            .source = "Cook and Torrance 1982; Heitz 2014, Eqs. 27-29; Kelemen and Szirmay-Kalos 2001, Eq. 1; "
                      "Akenine-Moller et al. 2018, Eq. 9.34"};
  }
  static Mirror from(const TermDescription& description);

  const Distribution& facets() const { return surface.distribution; }
  HalfVectorKinks kinks(const Direction& omega_o, const ChannelRange& of) const {
    return brdfplot::kinks(surface, fresnel, omega_o, of);
  }
  int channels() const;
  void evaluate(const PairBlock& pairs, SurfaceBlock& work, const ChannelRows& out) const;
  Mirror white() const { return {surface, NoFresnel{}}; }
};

} // namespace brdfplot
