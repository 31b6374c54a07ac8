#include "brdf/terms/diffuse/wrap.hpp"

#include "math/kernels/cloth.hpp"

#include <algorithm>
#include <numbers>

namespace brdfplot {

ModelSpec Wrap::spec() {
  return {
      .type = "wrap",
      .doc = "wrap lighting: light reaches it from below the horizon",
      .source = "Akenine-Moller et al. 2018, Eq. 9.71",
      .parameters = {Colour::parameter("albedo", "of each channel"),
                     {.key = "w", .bounds = {.min = 0, .max = 1}, .doc = "cosine below the horizon that light reaches"},
                     {.key = "form",
                      .kind = ParameterKind::choice,
                      .fallback = std::string("printed"),
                      .doc = "how Eq. 9.71 is read: clamp(n.l + w) / (1 + w), clamp((n.l + w) / (1 + w)), or "
                             "(n.l + w) / (1 + w)^2",
                      .choices = {"printed", "ratio", "conserving"}},
                     Colour::parameter("scatter", "c_scatter of each channel, added to n.l; 1 leaves it out")}};
}

Wrap Wrap::from(const TermDescription& description) {
  const Values values = completed_values<Wrap>(description);
  const std::string& form = values.text("form");
  return {Colour::from(values, "albedo"), Colour::from(values, "scatter"), values.number("w"),
          form == "printed" ? Form::printed
          : form == "ratio" ? Form::ratio
                            : Form::conserving};
}

void Wrap::evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
  const double share = form == Form::conserving ? 1 / ((1 + w) * (1 + w)) : 1 / (1 + w);
  kernels::WrapParameters parameters{w, form == Form::printed ? 1 : 1 + w, {}, {}};
  for (std::size_t c = 0; c < 3; ++c) {
    parameters.scale[c] = albedo.value[c] * std::numbers::inv_pi * share;
    parameters.scatter[c] = scatter.value[c];
  }
  kernels::wrap(parameters, block.o.z, block.i.z, block.times_cosine, channels(), out.rho, block.n);
}

std::vector<double> Wrap::bends() const {
  std::vector<double> cosines = {-w, 0};
  if (form == Form::printed) cosines.push_back(1 - w);
  for (const double s : scatter.value) cosines.push_back(1 - s);
  std::ranges::sort(cosines);
  cosines.erase(std::unique(cosines.begin(), cosines.end()), cosines.end());
  return cosines;
}

} // namespace brdfplot
