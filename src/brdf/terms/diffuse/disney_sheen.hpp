/// \file
/// Light scattered by the fibres that stand out of cloth.
#pragma once

#include "brdf/terms/diffuse/flat.hpp"

namespace brdfplot {

/// rho = color (1 - h.l)^5.
struct DisneySheen {
  Colour color;

  static constexpr bool is_flat = true;
  static ModelSpec spec() {
    return {.type = "disney_sheen",
            .doc = "color (1 - h.l)^5",
            .source = "Burley 2012; Akenine-Moller et al. 2018, Eq. 9.72",
            .parameters = {Colour::parameter("color", "k_sheen times its colour, of each channel")}};
  }
  static DisneySheen from(const TermDescription& description) {
    const Values values = completed_values<DisneySheen>(description);
    return {Colour::from(values, "color")};
  }

  int channels() const { return color.channels(); }
  void evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
    const auto factors = [this](std::size_t c) { return std::array{color.value[c], 0.0, 0.0}; };
    evaluate_flat(block, kernels::FlatTerm::sheen, flat_parameters({}, factors), channels(), out);
  }
  DisneySheen white() const { return {}; }
};

} // namespace brdfplot
