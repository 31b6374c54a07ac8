/// \file
/// Work of several threads with progress, and figures as they are written.
#pragma once

#include "base/threads/team.hpp"
#include "command.hpp"
#include "draw/layout.hpp"
#include "figure/description.hpp"

#include <optional>

namespace brdfplot::cli {

/// Something to compute, by name.
struct Task {
  std::string name;
  std::function<void()> run;
  double work = 4e4; ///< how long it takes, roughly, in simulated paths (plot::SimulationTask); default: a figure's
};

/// All of them, on the threads that the settings say, with progress on stderr. The first failure in the order of the
/// tasks is thrown.
void run_tasks(const std::vector<Task>& tasks, const Settings& settings);

/// A figure as the texts of its files.
struct RenderedFigure {
  std::string svg;
  std::string csv;
  std::string caption; ///< with its numbers
  double seconds = 0;
};

/// On up to `threads` threads.
RenderedFigure render(const plot::FigureDescription& description, simulation::Store& store, int threads = 1,
                      const plot::Layout& layout = {});

/// The simulations of all the figures, once each, as the first of the tasks: figures that start later wait for theirs.
void append_simulations(const std::vector<const plot::FigureDescription*>& figures, const Settings& settings,
                        simulation::Store& store, std::vector<Task>& tasks);

/// The flag --cache of commands that simulate, set to its default.
void add_cache_flag(CLI::App& command, std::string& folder);

/// The flag --cache of commands whose work ranks share.
void add_pieces_flag(CLI::App& command, std::optional<std::string>& folder);

/// The team, which has begun, where the work is shared or kept; none where this process does it all. `key`, beside the
/// version, defines all numbers.
Team* team_for(const Settings& settings, const std::optional<std::string>& folder,
               const std::function<std::string()>& key);

/// Seconds that `work` takes.
double timed(const std::function<void()>& work);

/// `folder/name`.
std::string in_folder(const std::string& folder, const std::string& name);

} // namespace brdfplot::cli
