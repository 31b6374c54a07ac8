/// \file
/// The picture of a lit sphere of a material, by the lights as a model has them.
#pragma once

#include "choice/advise/images/errors.hpp"
#include "choice/advise/shader/cost.hpp"
#include "sampling/sphere/frames.hpp"

#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace brdfplot::choice {

/// Pictures of many materials at the same places under the same lights. A picture is the sum of those of the terms,
/// each of which is computed once (`remember`). Any number of threads; results do not depend on it.
class Renderer {
public:
  Renderer(std::vector<AdviceLight> lights, Places places, int threads)
      : lights_(std::move(lights)), places_(std::move(places)), threads_(threads) {}

  const Places& places() const { return places_; }

  /// The radiance towards the viewer of a canonical material:
  ///   points    each disc by rings x 4 rings directions (sampling/sphere/cap_points.hpp)
  ///   nearest   mirror facets by the direction in the disc that is nearest to the mirrored viewer, times (alpha /
  ///             alpha')^2, alpha' = alpha + sin(radius) / 2 (Karis 2013); other terms by the middle of the disc
  ///   punctual  each disc as its middle
  /// In single precision each term is what SingleForm makes of it. \throws MaterialError, AccuracyError
  Picture picture(const MaterialDescription& material, const LightModel& model, bool remember = true, int threads = 1,
                  Precision precision = Precision::full);

  int threads() const { return threads_; }

private:
  Picture term_picture(const MaterialDescription& material, const TermDescription& term, const LightModel& model,
                       int threads, Precision precision) const;

  std::vector<AdviceLight> lights_;
  Places places_;
  int threads_;
  std::mutex mutex_;
  std::map<std::string, Picture> known_; ///< by what a term is, with what it depends on, and the light model
};

/// How many rings of directions a disc needs: twice as many as 4, 8, ... until doubling has a decisive error below a
/// tenth of what is just noticeable (1 of Delta E, 1 % of radiance); the rule converges faster than any power from
/// there on. 4 where there are no discs. \throws AccuracyError beyond 64
std::size_t rings_for(Renderer& renderer, const MaterialDescription& material, const AdviceScene& scene);

} // namespace brdfplot::choice
