/// \file
/// The diffuse term of Hammon.
#pragma once

#include "brdf/terms/diffuse/flat.hpp"

#include <numbers>

namespace brdfplot {

/// rho = albedo / pi ((1 - alpha) f_smooth + alpha f_rough + albedo f_multi): a fit to two bounces on GGX with
/// Shirley's term on each facet. f_smooth is Shirley's; with k = (1 + l.v) / 2 = (l.h)^2, f_rough = k (0.9 - 0.4 k)
/// (0.5 + n.h) / n.h = (0.9 - 0.4 k) (k + (l.h)^3 / (n.l + n.v)), which has no n.h to divide by; f_multi = 0.3641
/// alpha. It reflects more than it gets at grazing.
struct HammonDiffuse {
  Colour albedo, f0;
  double alpha = 0;

  static constexpr bool is_flat = true;
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
    const auto factors = [this](std::size_t c) {
      const double a = albedo.value[c], over_pi = a * std::numbers::inv_pi;
      return std::array{over_pi * (1 - alpha) * (21.0 / 20) * (1 - f0.value[c]), over_pi * alpha,
                        over_pi * a * (0.3641 * alpha)};
    };
    evaluate_flat(block, kernels::FlatTerm::hammon, flat_parameters({}, factors), channels(), out);
  }
  HammonDiffuse white() const { return {{}, f0, alpha}; }
};

} // namespace brdfplot
