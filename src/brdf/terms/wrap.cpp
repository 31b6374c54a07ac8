#include "brdf/terms/wrap.hpp"

#include <algorithm>
#include <numbers>

namespace brdfplot {

namespace {

double clamped(double x) { return std::min(std::max(x, 0.0), 1.0); }

} // namespace

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
  const double most = form == Form::printed ? 1 : 1 + w;
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels()); ++c) {
    const double scale = albedo.value[c] * std::numbers::inv_pi * share, turned_away = scatter.value[c];
    for (std::size_t k = 0; k < block.n; ++k) {
      const double l = block.i.z[k];
      const double lit = std::min(std::max(l + w, 0.0), most);
      const double light = scale * clamped(turned_away + std::max(l, 0.0)) * lit;
      const double value = block.times_cosine ? light : light / l;
      out.rho[c][k] = block.o.z[k] > 0 && (block.times_cosine || l > 0) ? value : 0;
    }
  }
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
