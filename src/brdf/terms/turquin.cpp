#include "brdf/terms/turquin.hpp"

#include "microfacet/fresnel.hpp"

namespace brdfplot {

Turquin Turquin::from(const TermDescription& description) {
  const TermDescription& other = another_of(description);
  if (other.type != Mirror::spec().type)
    throw MaterialError("/of/type", "found \"" + other.type + "\"; accepted: mirror");
  TermDescription white = other;
  white.fresnel = {.type = "none"};
  white.weight = 1.0;
  Turquin made{Mirror::from(other), TermAlbedo(white), {}};
  made.f0.is_rgb = made.first.channels() > 1;
  const double normal = 1;
  for (std::size_t c = 0; c < made.f0.value.size(); ++c)
    std::visit([&](const auto& f) { f.reflectances(&normal, c, &made.f0.value[c], 1); }, made.first.fresnel);
  return made;
}

void Turquin::evaluate(const PairBlock& pairs, SurfaceBlock& work, const ChannelRows& out) const {
  first.evaluate(pairs, work, out);
  const AlbedoTable& table = white_albedo.table();
  for (std::size_t k = 0; k < pairs.n; ++k) {
    const Direction o = pairs.o[k];
    const double further = o.z > 0 ? table.loss(0, o) / table.albedo(0, o) : 0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels()); ++c)
      if (out.rho[c][k] != 0) out.rho[c][k] *= f0.value[c] * further;
  }
}

} // namespace brdfplot
