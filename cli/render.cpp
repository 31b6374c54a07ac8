#include "render.hpp"

#include "math/parallel.hpp"
#include "terminal.hpp"

#include <chrono>
#include <filesystem>

namespace brdfplot::cli {

void run_tasks(const std::vector<Task>& tasks, const Settings& settings) {
  Progress progress(settings, tasks.size());
  parallel_for(tasks.size(), settings.threads, [&](std::size_t index) {
    progress.start(tasks[index].name);
    tasks[index].run();
    progress.finish(tasks[index].name);
  });
}

RenderedFigure render(const plot::FigureDescription& description) {
  RenderedFigure rendered;
  rendered.seconds = timed([&] {
    const plot::Figure figure = plot::compute(description);
    rendered.svg = plot::to_svg(figure);
    rendered.csv = plot::to_csv(figure);
  });
  return rendered;
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
