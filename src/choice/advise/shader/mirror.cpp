#include "choice/advise/shader/mirror.hpp"

#include "choice/advise/shader/mirror_forms.hpp"

#include <algorithm>

namespace brdfplot::choice::forms {

namespace {

using N = Counted;

bool is_round(const ModelChoice& d) { return !d.values.has("alpha_x") && !d.values.has("correlation"); }

Stretch<N> stretch_of(const ModelChoice& d) {
  return {N(2),
          N(3),
          N(0.1),
          N(1.1),
          N(0.1),
          N(0.2),
          N(1.5),
          is_round(d),
          d.values.has("correlation"),
          d.values.has("mean_slope")};
}

Roughness<N> roughness_of(const ModelChoice& d) {
  return {N(0.5), N(0.3), N(0.1), N(0.9), is_round(d), d.values.has("correlation")};
}

/// With the constants that are for counting.
Lobe<N> lobe_of(const ModelChoice& d) {
  Lobe<N> lobe;
  lobe.type = d.type;
  lobe.stretch = stretch_of(d);
  lobe.roughness = roughness_of(d);
  if (d.type == "sheen") lobe.exponent = N(2);
  if (d.type != "mixture") return lobe;
  for (const WeightedChoice& one : d.values.components("components")) {
    lobe.components.push_back(lobe_of(one.model));
    lobe.weights.emplace_back(one.weight);
    lobe.stretch.sheared = lobe.stretch.sheared || lobe.components.back().stretch.sheared;
  }
  return lobe;
}

void count_visibility(const TermDescription& term) {
  if (term.masking.type == "kelemen") (void)(N(1) / (N(0.8) * N(0.8)));
  if (!has_masked_area(term)) return;
  (void)visibility(term, lobe_of(term.distribution), viewer(), light(), {viewer().z, N(0.2), N(0.9), N(1.2)});
}

} // namespace

int channels_of(const ModelChoice& fresnel) {
  const auto& map = fresnel.values.map();
  return std::ranges::any_of(map, [](const auto& entry) { return std::holds_alternative<Rgb>(entry.second); }) ? 3 : 1;
}

bool is_constant(const ModelChoice& fresnel) {
  return fresnel.type == "schlick" && fresnel.values.has("f90") &&
         fresnel.values.rgb("f90") == fresnel.values.rgb("f0");
}

void fresnel(const ModelChoice& of) {
  if (is_constant(of)) return;
  const N c(0.6);
  const int channels = channels_of(of);
  const auto each = [&](const auto& channel) {
    for (int k = 0; k < channels; ++k) channel();
  };
  if (of.type == "conductor") each([&] { (void)conductor(c, N(2), N(5)); });
  if (of.type == "dielectric") each([&] { (void)dielectric(c, N(1.25)); });
  if (of.type == "schlick") {
    const bool fifth = !of.values.has("exponent") || of.values.number("exponent") == 5;
    const N x5 = fifth ? fifth_power(c) : pow(N(1) - c, N(4));
    each([&] { (void)schlick(x5, N(0.04), N(0.96)); });
  }
  if (of.type == "f82") {
    const N x5 = fifth_power(c), dip = c * (N(1) - c) * x5;
    each([&] { (void)f82(x5, dip, N(0.5), N(0.5), N(0.1)); });
  }
}

void mirror_view(const TermDescription& term) {
  if (term.type == "kelemen" || !has_masked_area(term)) return;
  const Lobe<N> lobe = lobe_of(term.distribution);
  const N c = cosine(lobe, viewer()), t = masked(term, lobe, viewer(), c);
  const std::string how = shadowing_of(term);
  if (how == "separable" || how == "direction_correlated") (void)(N(1) / (c + t));
}

void mirror_light(const TermDescription& term) {
  // The half vector is counted once for all terms.
  const N d = density(lobe_of(term.distribution), {N(0.1), N(0.7), N(0.7)});
  if (term.type == "kelemen") {
    (void)(d / (N(1) + dot(viewer(), light())));
  } else if (term.masking.type != "implicit") {
    count_visibility(term);
    (void)(d * N(0.5));
  }
  fresnel(term.fresnel);
  if (term.fresnel.type != "none")
    for (int k = 0; k < channels_of(term.fresnel); ++k) (void)(N(0.5) * N(0.5));
}

} // namespace brdfplot::choice::forms
