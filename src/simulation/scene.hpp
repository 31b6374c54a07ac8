/// \file
/// What is simulated, as data: a surface, what is measured on it, with how many rays and from which seed.
#pragma once

#include "base/errors.hpp"
#include "models/parameters.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace brdfplot::simulation {

/// One thing measured. Which of the keys a type reads, and what its table holds, is told by `measure_specs()`.
struct MeasureDescription {
  std::string id;                  ///< names its table and files
  std::string type;                ///< one of measure_specs()
  std::vector<double> theta_o{0};  ///< rad
  std::vector<double> phi_o{0};    ///< rad
  std::vector<double> theta_i{};   ///< g2 (rad); empty: theta_o
  std::vector<double> delta_phi{}; ///< g2: azimuths between omega_o and omega_i (rad)
  double half_width = 0.0873;      ///< lobe: how far from the plane of incidence a direction may be (rad)
  int bins = 0;                    ///< of tables that have bins; 0: the type's own number
  int bounces = 32;                ///< of paths: the energy left after so many is counted as `left`
  double rays = 1e6;               ///< points, or paths, for every direction, over all realisations
};

struct SceneDescription {
  std::string name;
  ModelChoice surface; ///< one of surface.hpp's list
  std::uint64_t seed = 1;
  int realisations = 8; ///< independent surfaces over which everything is averaged, with errors of their scatter
  std::vector<MeasureDescription> measures;
};

/// A text that is equal for two scenes when they define the same results: surface with all defaults, seed,
/// realisations, measures, and of a height map the digest of its file. Names are not part of it. For keys of caches.
/// \throws SceneError, FileError
std::string canonical_text(const SceneDescription& scene);

/// What is wrong with a scene, at a JSON pointer within it ("/surface/alpha").
class SceneError : public InputError {
public:
  SceneError(std::string pointer, std::string what)
      : InputError("scene: " + pointer, what), pointer_(std::move(pointer)), what_(std::move(what)) {}
  const std::string& pointer() const { return pointer_; }
  const std::string& reason() const { return what_; }

private:
  std::string pointer_;
  std::string what_;
};

/// Checks a scene without simulating it. \throws SceneError
void check(const SceneDescription& scene);

/// What there is to know of a type of measure.
struct MeasureSpec {
  std::string type;
  std::string doc;
  std::string source;
  std::vector<std::string> keys{}; ///< of MeasureDescription beside id, type, theta_o, phi_o and rays
  int bins = 0;                    ///< default
};

/// Of the measures in their order (simulation/measures.hpp).
std::vector<MeasureSpec> measure_specs();

} // namespace brdfplot::simulation
