/// \file
/// Light that a microsurface reflects more than once.
#pragma once

#include "brdf/integrals/term_albedo.hpp"
#include "brdf/terms/diffuse/flat.hpp"

namespace brdfplot {

/// rho(o, i) = F_ms (1 - R(o)) (1 - R(i)) / (pi (1 - mean R)) for each channel, R the directional albedo of another
/// term with F = 1 (Kulla and Conty 2017; Akenine-Moller et al. 2018, Eqs. 9.56-9.57). With mean F the mean of the
/// other term's Fresnel term (fresnel.hpp),
///   energy   F_ms = mean F^2 mean R / (1 - mean F (1 - mean R)), the series of light that is reflected twice and more,
///            each time by mean F;
///   printed  mean F in the place of its square, as the equation is printed: too bright where F < 1.
/// With F = 1 both are 1, and the term and the other one together reflect all light.
///
/// R is a table (albedo_table.hpp) with an error of about 1e-8; where no more than that is lost on average, the term
/// is 0.
struct MultipleBounce {
  TermAlbedo of;
  Colour mean_fresnel;
  bool printed = false;

  static constexpr bool of_another = true;
  static ModelSpec spec();
  static MultipleBounce from(const TermDescription& description);

  int channels() const { return mean_fresnel.channels(); }
  bool isotropic() const { return of.is_isotropic(); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const;
  MultipleBounce white() const { return {of, {}, printed}; }
};

} // namespace brdfplot
