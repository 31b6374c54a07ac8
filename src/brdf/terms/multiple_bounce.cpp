#include "brdf/terms/multiple_bounce.hpp"

#include "brdf/material.hpp"
#include "brdf/terms/complement.hpp"
#include "microfacet/fresnel.hpp"

#include <numbers>

namespace brdfplot {

ModelSpec MultipleBounce::spec() {
  return {
      .type = "multiple_bounce",
      .doc = "what another term's microsurface reflects more than once: F_ms (1 - R_o)(1 - R_i) / (pi (1 - mean R)); R "
             "by a table of its own surface, over both angles where that is anisotropic: "
             "configs/figures/rtr_multiple_bounce_anisotropic.json has it beside the walk, and a mean roughness",
      .source = "Kulla and Conty 2017; Akenine-Moller et al. 2018, Eqs. 9.56-9.58",
      .parameters = {{.key = "mean_fresnel",
                      .kind = ParameterKind::choice,
                      .fallback = std::string("energy"),
                      .doc = "energy: the square of the mean of F; printed: the mean, as Eq. 9.56 has it",
                      .choices = {"energy", "printed"}}}};
}

MultipleBounce MultipleBounce::from(const TermDescription& description) {
  const Values values = completed_values<MultipleBounce>(description);
  const TermDescription& other = another_of(description);
  const WeightedTerm term = build_term(other);
  const Fresnel* fresnel = term.fresnel();
  if (fresnel == nullptr)
    throw MaterialError("/of/type",
                        "found \"" + other.type + "\"; accepted: a term with a Fresnel term: mirror, kelemen");
  TermDescription white = other;
  white.fresnel = {.type = "none"};
  white.weight = 1.0;
  MultipleBounce made{TermAlbedo(white), {}, values.text("mean_fresnel") == "printed"};
  made.mean_fresnel.is_rgb = std::visit([](const auto& f) { return f.coloured(); }, *fresnel);
  for (std::size_t c = 0; c < 3; ++c)
    made.mean_fresnel.value[c] = brdfplot::mean_fresnel(*fresnel, made.mean_fresnel.is_rgb ? c : 0);
  return made;
}

void MultipleBounce::evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
  const AlbedoTable& table = of.table();
  const double lost = table.mean_loss(0);
  Rgb scale{};
  for (std::size_t c = 0; c < scale.size(); ++c) {
    const double f = mean_fresnel.value[c];
    const double further = (printed ? f : f * f) * (1 - lost) / (1 - f * lost);
    scale[c] = lost > table.error() ? further * std::numbers::inv_pi / lost : 0;
  }
  evaluate_losses(table, scale, block, channels(), out);
}

} // namespace brdfplot
