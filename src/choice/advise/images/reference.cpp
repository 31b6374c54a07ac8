#include "choice/advise/images/reference.hpp"

#include <algorithm>

namespace brdfplot::choice {

namespace {

/// The roughest and the smoothest lobe of a material.
Fineness fineness_of(const MaterialDescription& material, double scale) {
  Fineness out{scale, 1, 0};
  for (const WeightedTerm& term : build(material).terms) {
    if (term.facets() == nullptr) continue;
    const SlopeMap map = std::visit([](const auto& d) { return d.slopes; }, *term.facets());
    out.least_alpha = std::min({out.least_alpha, map.alpha_x, map.alpha_y});
    out.largest_alpha = std::max({out.largest_alpha, std::min(1.0, map.alpha_x), std::min(1.0, map.alpha_y)});
  }
  out.largest_alpha = std::max(out.largest_alpha, out.least_alpha);
  return out;
}

} // namespace

Reference::Reference(const MaterialDescription& of, const AdviceScene& scene, double scale, std::size_t with_rings,
                     int threads)
    : material(of), renderer(std::make_unique<Renderer>(
                        scene.lights, places_on_sphere(scene.view, scene.lights, fineness_of(of, scale)), threads)) {
  rings = with_rings > 0 ? with_rings : rings_for(*renderer, material, scene);
  picture = renderer->picture(material, {LightModel::Kind::points, rings}, false, threads);
}

PictureErrors Reference::errors(const MaterialDescription& other, const Drawing& how, const AdviceScene& scene,
                                bool remember) const {
  return compare(picture, renderer->picture(other, how.light, remember, 1, how.precision), renderer->places(),
                 scene.tolerance.metric, scene.exposure);
}

PictureErrors largest_errors(const std::vector<Reference>& references,
                             const std::vector<MaterialDescription>& materials, const Drawing& how,
                             const AdviceScene& scene, bool remember) {
  PictureErrors most;
  for (std::size_t v = 0; v < references.size(); ++v) {
    const PictureErrors errors = references[v].errors(materials[v], how, scene, remember);
    if (v == 0 || errors.decisive() > most.decisive()) most = errors;
  }
  return most;
}

} // namespace brdfplot::choice
