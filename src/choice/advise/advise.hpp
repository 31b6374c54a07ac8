/// \file
/// The cheapest model of a material that a scene does not tell from the one in full.
#pragma once

#include "choice/advise/examination.hpp"
#include "choice/advise/images/reference.hpp"
#include "choice/advise/ladder.hpp"

#include <functional>
#include <optional>

namespace brdfplot::choice {

/// A model: a simpler material under simpler lights.
struct Model {
  std::size_t rung = 0, light = 0;            ///< of the ladder
  double cost = 0;                            ///< shader_cost()
  std::vector<MaterialDescription> materials; ///< of each variant, its free parameters fitted
  PictureErrors errors;                       ///< of the variant that is farthest off
  std::optional<PictureErrors> dense{};       ///< on more places, where it was asked
};

/// What the lights of a scene reach on the lit part that is seen (radians).
struct ReachedAngles {
  double least_view = 0, largest_view = 0;           ///< theta_o
  double least_light = 0, largest_light = 0;         ///< theta_i
  std::vector<std::pair<double, double>> difference; ///< theta_d, of each light
};

struct MaterialAdvice {
  std::string name;
  Ladder ladder;
  std::size_t ladder_size = 0; ///< so many models there are
  /// By ascending cost: those up to the answer and some more, of which none is cheaper; and the material in full with
  /// each single simplification of it.
  std::vector<Model> models;
  std::size_t full = 0;                    ///< the material in full, with the most directions for each disc
  std::optional<std::size_t> answer;       ///< the cheapest within the tolerance
  std::optional<std::size_t> next_cheaper; ///< of the models that cost less, the dearest, or the cheapest if no answer
  std::optional<std::size_t> best_cheaper; ///< of the models that cost less, the one with the least error
  std::optional<std::size_t> best_in_budget;
  std::size_t places = 0, dense_places = 0;
  std::size_t rings = 0; ///< of directions of each disc, in what models are held against
  ReachedAngles reached;
  std::optional<Examination> examined{}; ///< of the answer, where it was asked for (examine.hpp)

  bool within_budget(const AdviceScene& scene) const {
    return answer && (!scene.budget || models[*answer].cost <= *scene.budget);
  }
};

struct AdviceOptions {
  int threads = 1;
  /// So many of so many models are evaluated; may be called from several threads, one at a time.
  std::function<void(std::size_t done, std::size_t total)> progress{};
};

/// Models are evaluated at some hundred places, from the cheapest on; those whose decisive error is at most `doubt`
/// times the tolerance are at some ten times as many. The first that is within the tolerance there is the answer: all
/// that cost less have been seen to fail. Errors depend on no tolerance, so a smaller one never has a cheaper answer.
/// `doubt` is how far the two errors may differ: a model that is off by more at few places is not looked at again.
/// \throws InputError, MaterialError, AccuracyError
MaterialAdvice advise(const AdviceScene& scene, const AdvisedMaterial& material, const AdviceOptions& options);

inline constexpr double doubt = 1.25;

/// Of the models that differ from one by the next level of a single option and cost less, each with what it changes.
struct FurtherStep {
  std::string label;
  std::size_t model;
};
std::vector<FurtherStep> further_steps(const MaterialAdvice& advice, std::size_t from);

/// The labels of the levels of a model that are not those in full.
std::vector<std::string> simplifications(const MaterialAdvice& advice, const Model& model);

/// The error that is held against the tolerance: at most places where it is known.
double decisive(const Model& model);

/// How the pictures of a model are made.
Drawing drawing_of(const MaterialAdvice& advice, const Model& model);

} // namespace brdfplot::choice
