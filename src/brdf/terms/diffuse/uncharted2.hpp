/// \file
/// The diffuse term of the cloth in Uncharted 2.
#pragma once

#include "brdf/terms/diffuse/flat.hpp"

#include <numbers>

namespace brdfplot {

/// rho = albedo / pi (k_rim (n.v)^p + k_inner (1 - n.v)^q + k_diff). A function of the viewer alone, so not reciprocal;
/// its albedo is that function times the albedo, above 1 where the factors say so.
struct Uncharted2 {
  Colour albedo;
  double rim = 0, rim_power = 1, inner = 0, inner_power = 1, diffuse = 1;

  static constexpr bool is_flat = true;
  static ModelSpec spec() {
    return {
        .type = "uncharted2",
        .doc = "cloth by factors of the viewer: rim, inner, diffuse",
        .source = "Akenine-Moller et al. 2018, Eq. 9.70",
        .parameters = {Colour::parameter("albedo", "of each channel"),
                       {.key = "rim", .bounds = {.min = 0, .max = 1e3}, .doc = "k_rim, of (n.v)^rim_power"},
                       {.key = "rim_power", .bounds = {.min = 0, .max = 1e3}, .doc = "alpha_rim"},
                       {.key = "inner", .bounds = {.min = 0, .max = 1e3}, .doc = "k_inner, of (1 - n.v)^inner_power"},
                       {.key = "inner_power", .bounds = {.min = 0, .max = 1e3}, .doc = "alpha_inner"},
                       {.key = "diffuse", .bounds = {.min = 0, .max = 1e3}, .doc = "k_diff"}}};
  }
  static Uncharted2 from(const TermDescription& description) {
    const Values values = completed_values<Uncharted2>(description);
    return {Colour::from(values, "albedo"), values.number("rim"),         values.number("rim_power"),
            values.number("inner"),         values.number("inner_power"), values.number("diffuse")};
  }

  int channels() const { return albedo.channels(); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
    const auto factors = [this](std::size_t c) { return std::array{albedo.value[c] * std::numbers::inv_pi, 0.0, 0.0}; };
    // x^0 is 1, at 0 too.
    const double constant = (rim_power == 0 ? rim : 0) + (inner_power == 0 ? inner : 0) + diffuse;
    const std::array<double, 5> p = {rim_power == 0 ? 0 : rim, rim_power, inner_power == 0 ? 0 : inner, inner_power,
                                     constant};
    evaluate_flat(block, kernels::FlatTerm::uncharted2, flat_parameters(p, factors), channels(), out);
  }
  Uncharted2 white() const { return {{}, rim, rim_power, inner, inner_power, diffuse}; }
};

} // namespace brdfplot
