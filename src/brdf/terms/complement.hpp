/// \file
/// What a matte part reflects of the light that a specular part leaves.
#pragma once

#include "brdf/integrals/term_albedo.hpp"
#include "brdf/terms/diffuse/flat.hpp"

namespace brdfplot {

/// rho(o, i) = color (1 - E(o)) (1 - E(i)) / (pi (1 - mean E)) for each channel, E the directional albedo of another
/// term with its weight and mean E = 2 int E mu dmu (Kelemen and Szirmay-Kalos 2001, Eqs. 6, 7; Shirley et al. 1997).
/// Its albedo is color (1 - E(o)), so that both together reflect E + color (1 - E): all where color is 1.
///
/// E is a table (albedo_table.hpp) with an error of about 1e-8 (term_albedo.hpp), which is that of the albedo of the
/// sum; where no more than that is left on average, the term is 0.
struct Complement {
  Colour color;
  TermAlbedo of;

  static constexpr bool of_another = true;
  static ModelSpec spec() {
    return {.type = "complement",
            .doc = "a matte part that reflects what another term leaves: color (1 - E_o)(1 - E_i) / (pi (1 - mean E))",
            .source = "Kelemen and Szirmay-Kalos 2001, Eqs. 6-7; Akenine-Moller et al. 2018, Eq. 9.65",
            .parameters = {Colour::parameter("color", "part of what is left that it reflects, of each channel")}};
  }
  static Complement from(const TermDescription& description);

  int channels() const { return color.is_rgb || of.channels() > 1 ? 3 : 1; }
  bool isotropic() const { return of.is_isotropic(); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const;
  Complement white() const { return {{}, of}; }
};

/// Writes scale[c] (1 - E_c(o)) (1 - E_c(i)) into the channels; 0 where a direction is at or below the horizon.
void evaluate_losses(const AlbedoTable& table, const Rgb& scale, const PairBlock& block, int channels,
                     const ChannelRows& out);

} // namespace brdfplot
