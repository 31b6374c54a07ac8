/// \file
/// Runs a scene: surfaces are made, rays traced, and tables filled.
#pragma once

#include "base/threads/team.hpp"
#include "simulation/scene.hpp"
#include "simulation/tracer.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot::simulation {

/// A table of numbers. A measured column `y` has its standard error in the column after it, `y_stderr`.
struct Table {
  std::string id;
  std::string type; ///< of the measure; "surface" for the statistics of the surface
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows; ///< a NaN is a value that there is not

  /// Index of a column. \throws std::out_of_range
  std::size_t column(const std::string& name) const;
};

/// How far a simulation is.
struct Progress {
  std::string what;      ///< the realisation being traced
  std::size_t done = 0;  ///< pieces of work
  std::size_t total = 0; ///< in all
};

struct SimulationOptions {
  int threads = 1;
  /// Called from any thread, one at a time, after every piece of work; may be empty.
  std::function<void(const Progress&)> progress;
  /// After Ctrl-C: true returns what has been traced so far, false throws Interrupted.
  bool keep_partial = false;
  /// That has begun; none: this process traces all. With one, Ctrl-C throws Interrupted: the team keeps what is done.
  Team* team = nullptr;
};

struct SimulationResult {
  Table surface;             ///< statistics of the slopes that the surfaces have, beside those asked
  std::vector<Table> tables; ///< one for each measure, in order
  double traced = 1;         ///< the part of the work that was done; below 1 after Ctrl-C
  TraceCounts counts;
};

/// The same result, to the last bit, for any number of threads. \throws SceneError, FileError, Interrupted
SimulationResult simulate(const SceneDescription& scene, const SimulationOptions& options);

/// What every rank but 0 does while that simulates.
void help_to_simulate(const SceneDescription& scene, const SimulationOptions& options);

} // namespace brdfplot::simulation
