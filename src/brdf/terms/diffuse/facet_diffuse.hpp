/// \file
/// Facets that are diffuse.
#pragma once

#include "brdf/terms/diffuse/flat.hpp"

namespace brdfplot {

/// rho(o, i) = albedo / (pi c_o c_i) int <o,m> <i,m> G2(o, i, m) D(m) dm (Heitz 2014, Eq. 31), of light that is
/// reflected once. A quadrature, to a relative error of 1e-9.
struct FacetDiffuse {
  Microsurface surface;
  Colour albedo;

  static ModelSpec spec() {
    return {.type = "facet_diffuse",
            .doc = "facets that are diffuse, by quadrature over the normals",
            .source = "Heitz 2014, Eqs. 26, 30-31; Akenine-Moller et al. 2018, Eq. 9.26",
            .parameters = {Colour::parameter("albedo", "of a facet, of each channel")}};
  }
  static FacetDiffuse from(const TermDescription& description);

  int channels() const { return albedo.channels(); }
  /// \throws AccuracyError
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const;
  FacetDiffuse white() const { return {surface, {}}; }

  /// rho of albedo 1.
  Estimate brdf(const Direction& omega_o, const Direction& omega_i, const Tolerance& tolerance) const;
};

} // namespace brdfplot
