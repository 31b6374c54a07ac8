/// \file
/// A diffuse surface that is flat.
#pragma once

#include "brdf/terms/diffuse/flat.hpp"

#include <numbers>

namespace brdfplot {

/// rho = albedo / pi (1/sr).
struct Lambert {
  Colour albedo;

  static constexpr bool is_flat = true;
  static ModelSpec spec() {
    return {.type = "lambert",
            .doc = "albedo / pi",
            .source = "Lambert 1760; Akenine-Moller et al. 2018, Eq. 9.61",
            .parameters = {Colour::parameter("albedo", "of each channel")}};
  }
  static Lambert from(const TermDescription& description) {
    return {Colour::from(completed_values<Lambert>(description), "albedo")};
  }

  int channels() const { return albedo.channels(); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
    const auto factors = [this](std::size_t c) { return std::array{albedo.value[c] * std::numbers::inv_pi, 0.0, 0.0}; };
    evaluate_flat(block, kernels::FlatTerm::constant, flat_parameters({}, factors), channels(), out);
  }
  Lambert white() const { return {}; }
};

} // namespace brdfplot
