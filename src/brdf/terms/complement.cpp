#include "brdf/terms/complement.hpp"

#include <numbers>

namespace brdfplot {

Complement Complement::from(const TermDescription& description) {
  const Values values = completed_values<Complement>(description);
  return {Colour::from(values, "color"), TermAlbedo(another_of(description))};
}

void Complement::evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
  const AlbedoTable& table = of.table();
  Rgb scale{};
  for (std::size_t c = 0; c < scale.size(); ++c) {
    const double left = table.mean_loss(table.channels() > 1 ? c : 0);
    scale[c] = left > table.error() ? color.value[c] * std::numbers::inv_pi / left : 0;
  }
  evaluate_losses(table, scale, block, channels(), out);
}

void evaluate_losses(const AlbedoTable& table, const Rgb& scale, const PairBlock& block, int channels,
                     const ChannelRows& out) {
  for (std::size_t k = 0; k < block.n; ++k) {
    const Direction o = block.o[k], i = block.i[k];
    const bool lit = o.z > 0 && i.z > 0;
    double losses = 0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
      if (c < table.channels()) losses = lit ? table.loss(c, o) * table.loss(c, i) * (block.times_cosine ? i.z : 1) : 0;
      out.rho[c][k] = scale[c] * losses;
    }
  }
}

} // namespace brdfplot
