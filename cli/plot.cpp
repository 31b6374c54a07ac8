/// \file
/// brdfplot plot: figures from their descriptions.

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/text_files.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "render.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>
#include <memory>

namespace brdfplot::cli {

namespace {

struct PlotFlags {
  std::vector<std::string> files;
  std::string output;
  std::string cache;
};

std::vector<plot::FigureDescription> load(const std::vector<std::string>& files) {
  std::vector<plot::FigureDescription> figures;
  std::map<std::string, std::string> file_of;
  for (const auto& file : files) {
    figures.push_back(config::load_figure(file).figure);
    const auto [other, is_new] = file_of.try_emplace(figures.back().id, file);
    if (!is_new)
      throw InputError(file + ": /id",
                       "found \"" + echo(other->first) + "\", which is the id of " + other->second + " too");
  }
  return figures;
}

/// Nothing is written before everything is computed: a figure that fails leaves the folder as it was.
int run(const PlotFlags& flags, const Settings& settings) {
  require_argument(!flags.files.empty(), "plot", "FIGURE.json...");
  require_argument(!flags.output.empty(), "plot", "-o DIR");
  const auto figures = load(flags.files);
  create_folders(flags.output);
  std::vector<RenderedFigure> rendered(figures.size());
  simulation::Store store(flags.cache);
  std::vector<Task> tasks;
  std::vector<const plot::FigureDescription*> described;
  for (const auto& figure : figures) described.push_back(&figure);
  append_simulations(described, settings, store, tasks);
  const int threads = std::max(1, settings.threads / static_cast<int>(figures.size()));
  for (std::size_t k = 0; k < figures.size(); ++k)
    tasks.push_back({figures[k].id, [&, k] { rendered[k] = render(figures[k], store, threads); }});
  run_tasks(tasks, settings);
  std::vector<NamedText> files;
  for (std::size_t k = 0; k < figures.size(); ++k) {
    files.push_back({in_folder(flags.output, figures[k].id + ".svg"), std::move(rendered[k].svg)});
    files.push_back({in_folder(flags.output, figures[k].id + ".csv"), std::move(rendered[k].csv)});
  }
  write_text_files(files);
  return 0;
}

} // namespace

Command add_plot(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<PlotFlags>();
  CLI::App* command = app.add_subcommand("plot", "Figures as SVG and CSV");
  command->add_option("figures", flags->files, "The figures")->type_name("FIGURE.json");
  command->add_option("-o,--output", flags->output, "Folder of ID.svg and ID.csv; made where it is missing")
      ->type_name("DIR");
  add_cache_flag(*command, flags->cache);
  command->footer(footer("brdfplot plot configs/figures/fig15_shear.json -o build/figures"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
