#include "brdf/terms/merl.hpp"

#include "brdf/measured/measured_file.hpp"
#include "brdf/measured/merl_integral.hpp"
#include "brdf/measured/merl_table.hpp"
#include "brdf/terms/diffuse/flat.hpp"

namespace brdfplot {

ModelSpec Merl::spec() {
  return {.type = "merl",
          .doc = "measured, isotropic: the values of a MERL file, that of the nearest cell",
          .source = "Matusik, Pfister, Brand and McMillan 2003",
          .parameters = {{.key = "file",
                          .kind = ParameterKind::text,
                          .doc = "MERL .binary, relative to the file that names it (brdfplot convert writes one)"}}};
}

Merl Merl::from(const TermDescription& description) {
  return {measured_file<MerlTable>(completed_values<Merl>(description).text("file"), read_merl)};
}

void Merl::evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
  for (std::size_t k = 0; k < block.n; ++k) {
    const Direction o = block.o[k], i = block.i[k];
    if (!(o.z > 0 && i.z > 0)) {
      for (double* rho : out.rho) rho[k] = 0;
      continue;
    }
    const std::size_t cell = table->grid().cell_of(half_difference(o, i));
    const double factor = block.times_cosine ? i.z : 1;
    for (std::size_t c = 0; c < 3; ++c) out.rho[c][k] = factor * table->value(c, cell);
  }
}

ColourEstimate Merl::reflected_light(const Direction& omega_o, double tolerance, const ChannelRange& channels,
                                     const std::function<double(const Direction& omega_i)>& weight) const {
  return integrate_merl(*table, omega_o, tolerance, channels, weight);
}

} // namespace brdfplot
