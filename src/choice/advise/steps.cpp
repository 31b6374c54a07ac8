#include "choice/advise/advise.hpp"

#include <algorithm>

namespace brdfplot::choice {

std::vector<std::string> simplifications(const MaterialAdvice& advice, const Model& model) {
  std::vector<std::string> out;
  const std::vector<std::size_t>& levels = advice.ladder.rungs[model.rung].levels;
  for (std::size_t k = 0; k < levels.size(); ++k)
    if (levels[k] > 0) out.push_back(advice.ladder.options[k].steps[levels[k] - 1].label);
  if (advice.ladder.lights.size() > 1) out.push_back(advice.ladder.light_labels[model.light]);
  return out;
}

std::vector<FurtherStep> further_steps(const MaterialAdvice& advice, std::size_t from) {
  const Model& start = advice.models[from];
  const std::vector<std::size_t>& levels = advice.ladder.rungs[start.rung].levels;
  std::vector<FurtherStep> out;
  for (std::size_t k = 0; k < advice.models.size(); ++k) {
    const Model& model = advice.models[k];
    if (!(model.cost < start.cost)) continue;
    const std::vector<std::size_t>& other = advice.ladder.rungs[model.rung].levels;
    std::size_t changed = 0, last = 0;
    for (std::size_t i = 0; i < levels.size(); ++i)
      if (other[i] != levels[i]) {
        ++changed;
        last = i;
      }
    const bool light = model.light != start.light;
    if (changed + (light ? 1 : 0) != 1) continue;
    const std::string label = light             ? advice.ladder.light_labels[model.light]
                              : other[last] > 0 ? advice.ladder.options[last].steps[other[last] - 1].label
                                                : advice.ladder.options[last].name + ": as in full";
    out.push_back({label, k});
  }
  std::ranges::stable_sort(out, [&](const FurtherStep& a, const FurtherStep& b) {
    return advice.models[a.model].cost > advice.models[b.model].cost;
  });
  return out;
}

} // namespace brdfplot::choice
