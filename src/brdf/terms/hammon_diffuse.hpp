/// \file
/// The diffuse term of Hammon.
#pragma once

#include "brdf/terms/flat.hpp"

#include <numbers>

namespace brdfplot {

/// rho = albedo / pi ((1 - alpha) f_smooth + alpha f_rough + albedo f_multi): a fit to two bounces on GGX with
/// Shirley's term on each facet. f_smooth is Shirley's; with k = (1 + l.v) / 2 = (l.h)^2, f_rough = k (0.9 - 0.4 k)
/// (0.5 + n.h) / n.h = (0.9 - 0.4 k) (k + (l.h)^3 / (n.l + n.v)), which has no n.h to divide by; f_multi = 0.3641
/// alpha. It reflects more than it gets at grazing.
struct HammonDiffuse {
  Colour albedo, f0;
  double alpha = 0;

  static ModelSpec spec() {
    return {.type = "hammon_diffuse",
            .doc = "rough diffuse surface, fitted to two bounces on GGX",
            .source = "Hammon 2017; Akenine-Moller et al. 2018, Eqs. 9.68, 9.69",
            .parameters = {Colour::parameter("albedo", "of each channel"),
                           f0_parameter(),
                           {.key = "alpha", .bounds = {.min = 0, .max = 1}, .doc = "roughness of the facets, GGX"}}};
  }
  static HammonDiffuse from(const TermDescription& description) {
    const Values values = completed_values<HammonDiffuse>(description);
    return {Colour::from(values, "albedo"), Colour::from(values, "f0"), values.number("alpha")};
  }

  int channels() const { return channels_of(albedo, f0); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
    evaluate_channels(block, channels(), out, [&](std::size_t c, const PairCosines& pair) {
      const double smooth =
          21.0 / 20 * (1 - f0.value[c]) * one_less_fifth(1 - pair.l, pair.l) * one_less_fifth(1 - pair.v, pair.v);
      const double k = pair.lh * pair.lh;
      const double rough = (0.9 - 0.4 * k) * (k + k * pair.lh / (pair.l + pair.v));
      const double a = albedo.value[c];
      return a * std::numbers::inv_pi * ((1 - alpha) * smooth + alpha * rough + a * (0.3641 * alpha));
    });
  }
  HammonDiffuse white() const { return {{}, f0, alpha}; }
};

} // namespace brdfplot
