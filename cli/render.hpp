/// \file
/// Work of several threads with progress, and figures as they are written.
#pragma once

#include "command.hpp"
#include "plot/description.hpp"

namespace brdfplot::cli {

/// Something to compute, by name.
struct Task {
  std::string name;
  std::function<void()> run;
};

/// All of them, on the threads that the settings say, with progress on stderr. The first failure in the order of the
/// tasks is thrown.
void run_tasks(const std::vector<Task>& tasks, const Settings& settings);

/// A figure as the texts of its files.
struct RenderedFigure {
  std::string svg;
  std::string csv;
  double seconds = 0;
};

RenderedFigure render(const plot::FigureDescription& description);

/// Seconds that `work` takes.
double timed(const std::function<void()>& work);

/// `folder/name`.
std::string in_folder(const std::string& folder, const std::string& name);

} // namespace brdfplot::cli
