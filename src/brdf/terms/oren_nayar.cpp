#include "brdf/terms/oren_nayar.hpp"

#include <algorithm>
#include <numbers>

namespace brdfplot {

namespace {

const std::vector<std::string>& form_names() {
  static const std::vector<std::string> names = {"full", "direct", "qualitative"};
  return names;
}

} // namespace

ModelSpec OrenNayarFits::spec() {
  return {
      .type = "oren_nayar",
      .doc = "rough diffuse surface: the fits to V-cavities with diffuse facets",
      .source = "Oren and Nayar 1994, Eqs. 29, 30",
      .parameters = {Colour::parameter("albedo", "of a facet, of each channel"),
                     {.key = "sigma",
                      .bounds = {.min = 0, .max = 1e3},
                      .doc = "standard deviation of the facets' inclination, rad"},
                     {.key = "form",
                      .kind = ParameterKind::choice,
                      .fallback = std::string("full"),
                      .doc = "full: with the light reflected twice; direct: without; qualitative: their simpler fit",
                      .choices = form_names()}}};
}

OrenNayarFits OrenNayarFits::from(const TermDescription& description) {
  const Values values = completed_values<OrenNayarFits>(description);
  const auto& names = form_names();
  const auto form = std::ranges::find(names, values.text("form")) - names.begin();
  return {Colour::from(values, "albedo"), values.number("sigma"), static_cast<OrenNayarFit>(form)};
}

void OrenNayarFits::evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
  for (std::size_t k = 0; k < block.n; ++k) {
    const Direction o = block.o[k], i = block.i[k];
    const OrenNayarParts parts = oren_nayar_parts(form, sigma, o, i);
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels()); ++c) {
      const double a = albedo.value[c];
      out.rho[c][k] =
          (a * parts.once + a * a * parts.twice) * std::numbers::inv_pi * (block.times_cosine ? std::max(0.0, i.z) : 1);
    }
  }
}

} // namespace brdfplot
