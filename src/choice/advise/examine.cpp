#include "choice/advise/examine.hpp"

#include "choice/advise/breaks.hpp"
#include "choice/advise/images/against_walk.hpp"
#include "choice/advise/single.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

namespace {

/// The least number of rings with five times the directions; an even one, as the rule has them.
std::size_t finer_rings(std::size_t rings) {
  const auto at_least = static_cast<std::size_t>(std::ceil(std::sqrt(5.0) * static_cast<double>(rings)));
  return at_least + at_least % 2;
}

bool has_discs(const AdviceScene& scene) {
  return std::ranges::any_of(scene.lights, [](const AdviceLight& light) { return light.radius > 0; });
}

std::vector<Reference> references_of(const AdviceScene& scene, const MaterialAdvice& advice, std::size_t rings,
                                     int threads) {
  std::vector<Reference> out;
  for (const MaterialDescription& variant : advice.ladder.variants)
    out.emplace_back(variant, scene, 1.0, rings, threads);
  return out;
}

} // namespace

Examination examine(const AdviceScene& scene, const MaterialAdvice& advice, int threads) {
  Examination out;
  if (!advice.answer) return out;
  const Model& answer = advice.models[*advice.answer];
  const bool discs = has_discs(scene);
  const std::size_t rings = discs ? finer_rings(advice.rings) : advice.rings;
  const std::vector<Reference> references = references_of(scene, advice, rings, threads);
  const auto error = [&](const Model& model) {
    return largest_errors(references, model.materials, drawing_of(advice, model), scene);
  };
  if (discs) {
    out.finer = {4 * rings * rings, error(answer).decisive(), 0};
    if (advice.next_cheaper) out.finer->next_cheaper = error(advice.models[*advice.next_cheaper]).decisive();
  }
  if (scene.target == Target::shader && std::ranges::all_of(answer.materials[0].terms, has_single_form)) {
    const Drawing single = {advice.ladder.lights[answer.light], Precision::single};
    out.single = largest_errors(references, answer.materials, single, scene);
  }
  out.irradiance = luminance(brightest(scene).irradiance.value);
  out.breaks = breaks_of(scene, advice);
  out.walk = against_walk(scene, advice.ladder.variants[0], references[0], threads);
  return out;
}

} // namespace brdfplot::choice
