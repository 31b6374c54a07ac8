#include "render.hpp"

#include "base/threads/parallel.hpp"
#include "terminal.hpp"
#include "version.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>

namespace brdfplot::cli {

void run_tasks(const std::vector<Task>& tasks, const Settings& settings) {
  double work = 0;
  for (const Task& task : tasks) work += task.work;
  Progress progress(settings, tasks.size(), work);
  parallel_for(tasks.size(), settings.threads, [&](std::size_t index) {
    progress.start(tasks[index].name, tasks[index].work);
    tasks[index].run();
    progress.finish(tasks[index].name, tasks[index].work);
  });
}

RenderedFigure render(const plot::FigureDescription& description, simulation::Store& store, int threads,
                      const plot::Layout& layout) {
  RenderedFigure rendered;
  rendered.seconds = timed([&] {
    const plot::Figure figure = plot::compute(description, store, threads);
    rendered.svg = plot::to_svg(figure, layout);
    rendered.caption = figure.description;
    rendered.csv = plot::to_csv(figure);
  });
  return rendered;
}

void append_simulations(const std::vector<const plot::FigureDescription*>& figures, const Settings& settings,
                        simulation::Store& store, std::vector<Task>& tasks) {
  std::vector<plot::SimulationTask> simulations;
  std::set<std::string> keys;
  for (const auto* figure : figures)
    for (auto& task : plot::simulations(*figure))
      if (keys.insert(task.key).second) simulations.push_back(std::move(task));
  const int count = static_cast<int>(simulations.size());
  const int threads = std::max(1, count > 0 ? settings.threads / count : 1);
  for (auto& task : simulations)
    tasks.push_back({task.name, [run = std::move(task.run), &store, threads] { run(store, threads); },
                     std::filesystem::exists(store.path(task.key)) ? 0 : task.work});
}

void add_cache_flag(CLI::App& command, std::string& folder) {
  folder = simulation::default_store_folder();
  command
      .add_option("--cache", folder,
                  "Folder that keeps simulated results for the next time; \"\": none; default: brdfplot in "
                  "$XDG_CACHE_HOME or ~/.cache")
      ->type_name("DIR");
}

void add_pieces_flag(CLI::App& command, std::optional<std::string>& folder) {
  command
      .add_option("--cache", folder,
                  "Folder that keeps what a run has finished that does not end, for the next one; \"\": none; default: "
                  "under mpirun brdfplot in $XDG_CACHE_HOME or ~/.cache, else none")
      ->type_name("DIR");
}

Team* team_for(const Settings& settings, const std::optional<std::string>& folder,
               const std::function<std::string()>& key) {
  const std::string pieces = folder.value_or(launched().by_mpirun ? simulation::default_store_folder() : "");
  if (settings.team->count() == 1 && pieces.empty()) return nullptr;
  settings.team->begin("brdfplot " + std::string(version) + " " + key(), pieces, settings.threads);
  return settings.team;
}

double timed(const std::function<void()>& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

std::string in_folder(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

} // namespace brdfplot::cli
