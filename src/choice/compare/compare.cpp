#include "choice/compare/compare.hpp"

#include "analysis/integrals.hpp"
#include "base/errors.hpp"
#include "choice/advise/draft.hpp"
#include "choice/advise/images/render.hpp"
#include "choice/advise/refit.hpp"
#include "choice/compare/pairs.hpp"

#include <algorithm>
#include <numbers>

namespace brdfplot::choice {

namespace {

constexpr double albedo_tolerance = 1e-6;

void set_albedos(const MaterialPair& pair, MaterialDifference& out) {
  for (const double degrees : {0, 30, 60, 75, 85}) {
    const double theta = degrees * std::numbers::pi / 180;
    const Direction omega_o = from_angles(theta, 0);
    const auto of = [&](const Material& material) {
      return compute_channels_or_throw(Integral::albedo, material, omega_o, albedo_tolerance);
    };
    const auto grey = [](const Material& material, Rgb rgb) {
      if (channels_of(material, Quantity::brdf) == 1) rgb = {rgb[0], rgb[0], rgb[0]};
      return rgb;
    };
    out.albedo.push_back({theta, grey(pair.a, of(pair.a)), grey(pair.b, of(pair.b))});
  }
}

/// The least and largest roughness of a material, which say how wide its highlights are.
void widen_alphas(const Material& material, Fineness& fineness) {
  for (const WeightedTerm& term : material.terms) {
    const Distribution* facets = term.facets();
    if (facets == nullptr) continue;
    const SlopeMap map = std::visit([](const auto& d) { return d.slopes; }, *facets);
    fineness.least_alpha = std::min({fineness.least_alpha, map.alpha_x, map.alpha_y});
    fineness.largest_alpha = std::max({fineness.largest_alpha, map.alpha_x, map.alpha_y});
  }
}

Renderer renderer_for(const MaterialDescription& a, const MaterialDescription& b, int threads) {
  Fineness fineness{1, 1, 1e-3};
  widen_alphas(build(a), fineness);
  widen_alphas(build(b), fineness);
  const ViewRange whole{{0, std::numbers::pi / 2}, {}};
  return {comparison_lights(), places_on_sphere(whole, comparison_lights(), fineness), threads};
}

constexpr LightModel lit_by{LightModel::Kind::points, 8};

} // namespace

std::vector<AdviceLight> comparison_lights() {
  const auto light = [](double theta, double phi, double irradiance) {
    return AdviceLight{theta * std::numbers::pi / 180,
                       phi * std::numbers::pi / 180,
                       3 * std::numbers::pi / 180,
                       {{irradiance, irradiance, irradiance}, false}};
  };
  return {light(45, 135, 2), light(140, 60, 2), light(70, -20, 0.5)};
}

MaterialDifference difference_of(const MaterialDescription& a, const MaterialDescription& b,
                                 const CompareOptions& options) {
  MaterialDifference out;
  out.name = b.name;
  const MaterialPair pair(a, b);
  set_differences(pair, options, out);
  set_albedos(pair, out);
  const MaterialDescription first = canonical(a), second = canonical(b);
  Renderer renderer = renderer_for(first, second, options.threads);
  const Picture reference = renderer.picture(first, lit_by, false, options.threads);
  const Picture other = renderer.picture(second, lit_by, false, options.threads);
  out.sphere = compare(reference, other, renderer.places(), Metric::delta_e, 1);
  return out;
}

MaterialDescription refitted_to(const MaterialDescription& a, const MaterialDescription& b,
                                const std::vector<std::string>& free, int threads) {
  Draft draft{canonical(b)};
  for (const std::string& key : free) {
    bool found = false;
    for (const TermDescription& term : draft.material.terms) {
      const bool rough = term.distribution.values.has("alpha") || term.distribution.values.has("alpha_x");
      const bool has = key == "alpha"
                           ? rough
                           : key == "weight" || term.values.has(key) || (key == "f0" && term.fresnel.values.has(key));
      if (has) draft.set_free(term.name, key);
      found = found || has;
    }
    if (!found)
      throw InputError("--refit", "found \"" + key + "\", which no term of " + b.name +
                                      " has; accepted: alpha, weight, f0, or a colour of a term (albedo, color)");
  }
  const MaterialDescription reference = canonical(a);
  Renderer renderer = renderer_for(reference, draft.material, threads);
  const Picture picture = renderer.picture(reference, lit_by, false, threads);
  return refitted(draft, renderer, {picture, lit_by, 1});
}

} // namespace brdfplot::choice
