#include "brdf/terms/diffuse/oren_nayar.hpp"

#include <algorithm>

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
  evaluate_flat(block, oren_nayar_term(form), oren_nayar_parameters(form, sigma, albedo.value), channels(), out);
}

} // namespace brdfplot
