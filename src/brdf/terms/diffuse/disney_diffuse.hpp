/// \file
/// The diffuse term of Disney.
#pragma once

#include "brdf/terms/diffuse/flat.hpp"

#include <numbers>

namespace brdfplot {

/// rho = albedo / pi ((1 - k) f_d + 1.25 k f_ss), k the share of subsurface, each a product of Schlick's interpolation
/// from 1 to its value at grazing, 0.5 + 2 sqrt(alpha) (h.l)^2 for f_d and sqrt(alpha) (h.l)^2 for F_ss.
/// f_ss = (1 / (n.l + n.v) - 0.5) F_ss + 0.5, as Burley has it; `printed`: the product of the cosines in place of their
/// sum, as Eq. 9.67 is printed, which grows without bound at grazing. It reflects more than it gets at grazing: 1.5 for
/// alpha = 1, k = 0 at 89 degrees.
struct DisneyDiffuse {
  Colour albedo;
  double roughness = 0; ///< sqrt(alpha)
  double subsurface = 0;
  bool printed = false;

  static constexpr bool is_flat = true;
  static ModelSpec spec() {
    return {
        .type = "disney_diffuse",
        .doc = "rough diffuse surface, with a rim at grazing",
        .source = "Burley 2012; Akenine-Moller et al. 2018, Eqs. 9.66, 9.67",
        .parameters =
            {Colour::parameter("albedo", "of each channel"),
             {.key = "alpha", .bounds = {.min = 0, .max = 1}, .doc = "roughness of the mirror above"},
             {.key = "roughness", .bounds = {.min = 0, .max = 1}, .doc = "r of alpha = r^2 (Burley 2012)"},
             {.key = "subsurface", .bounds = {.min = 0, .max = 1}, .fallback = 0.0, .doc = "k_ss, the share of f_ss"},
             {.key = "printed",
              .kind = ParameterKind::boolean,
              .fallback = false,
              .doc = "f_ss with 1 / ((n.l)(n.v)), as Eq. 9.67 is printed, for 1 / (n.l + n.v)"}},
        .alternatives = {{"alpha"}, {"roughness"}}};
  }
  static DisneyDiffuse from(const TermDescription& description) {
    const Values values = completed_values<DisneyDiffuse>(description);
    return {Colour::from(values, "albedo"),
            values.has("roughness") ? values.number("roughness") : std::sqrt(values.number("alpha")),
            values.number("subsurface"), values.flag("printed")};
  }

  int channels() const { return albedo.channels(); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
    const auto factors = [this](std::size_t c) { return std::array{albedo.value[c] * std::numbers::inv_pi, 0.0, 0.0}; };
    const auto term = printed ? kernels::FlatTerm::disney_printed : kernels::FlatTerm::disney;
    evaluate_flat(block, term, flat_parameters({roughness, subsurface}, factors), channels(), out);
  }
  DisneyDiffuse white() const { return {{}, roughness, subsurface, printed}; }
};

} // namespace brdfplot
