/// \file
/// All models that the simplifications of a material make together: their product, each model once.
#pragma once

#include "choice/advise/draft.hpp"
#include "choice/advise/images/render.hpp"
#include "choice/advise/images/scene.hpp"

#include <vector>

namespace brdfplot::choice {

/// A material made simpler in a certain way, for each of its variants.
struct Rung {
  std::vector<std::size_t> levels; ///< of each option
  std::vector<Draft> drafts;       ///< of each variant
};

struct Ladder {
  std::vector<MaterialDescription> variants; ///< in full, canonical
  std::vector<Option> options;               ///< of the material
  std::vector<Rung> rungs;                   ///< the first is the material in full
  std::vector<LightModel> lights;            ///< from the dearest on
  std::vector<std::string> light_labels;
};

/// So many combinations of options are tried, and so many models are evaluated, at most.
inline constexpr std::size_t most_combinations = 100000, most_models = 8000;

/// \throws InputError at the place of the material where there are more, or where the target is of single precision
/// and has no form of a term; MaterialError where a range cannot be set
Ladder ladder_of(const AdvisedMaterial& material, const std::vector<AdviceLight>& lights, Target target);

} // namespace brdfplot::choice
