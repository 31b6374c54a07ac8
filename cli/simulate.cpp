/// \file
/// brdfplot simulate: rays on a generated surface, as tables and CSV.

#include "simulation/simulate.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text_files.hpp"
#include "base/threads/interrupt.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "render.hpp"
#include "simulation/store.hpp"
#include "simulation_tables.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>

#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>

namespace brdfplot::cli {

namespace {

struct SimulateFlags {
  std::string scene;
  std::string output;
  std::optional<std::string> pieces;
};

/// Rays and seconds of processor time as a rate of all threads together.
std::string rate(std::uint64_t rays, double seconds, int threads) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(1) << static_cast<double>(rays) * 1e-6 << " million";
  if (seconds > 0) out << " (" << static_cast<double>(rays) / seconds * threads * 1e-6 << " million/s)";
  return out.str();
}

std::string summary(const simulation::TraceCounts& counts, int threads) {
  return "coherent rays: " + rate(counts.coherent, counts.coherent_seconds, threads) +
         ", incoherent: " + rate(counts.incoherent, counts.incoherent_seconds, threads) +
         ", lost paths: " + std::to_string(counts.lost);
}

simulation::SimulationResult trace(const simulation::SceneDescription& scene, simulation::SimulationOptions options,
                                   const Settings& settings) {
  Progress progress(settings);
  options.keep_partial = true;
  options.progress = [&](const simulation::Progress& now) { progress.set(now.done, now.total, now.what); };
  auto result = simulation::simulate(scene, options);
  progress.note(summary(result.counts, options.team == nullptr ? options.threads : options.team->threads()));
  return result;
}

/// A file that is not whole has another name: one that is stays as it was.
void write(const simulation::SimulationResult& result, const std::string& folder) {
  const std::string partial = result.traced < 1 ? ".partial" : "";
  create_folders(folder);
  std::vector<NamedText> files;
  for (const auto& table : all_tables(result)) {
    files.push_back({in_folder(folder, table.id + partial + ".csv"), table_csv(table)});
    files.push_back({in_folder(folder, table.id + partial + ".md"), table_markdown(table, result.traced)});
  }
  write_text_files(files);
}

int run(const SimulateFlags& flags, const Settings& settings) {
  require_argument(!flags.scene.empty(), "simulate", "SCENE.json");
  const auto scene = config::load_scene(flags.scene);
  simulation::SimulationOptions options;
  options.threads = settings.threads;
  options.team = team_for(settings, flags.pieces, [&] {
    return "simulate " + std::to_string(simulation::results_version) + "\n" + simulation::canonical_text(scene);
  });
  if (options.team != nullptr && !options.team->leads()) {
    simulation::help_to_simulate(scene, options);
    return 0;
  }
  if (!flags.output.empty()) create_folders(flags.output);
  const auto result = trace(scene, options, settings);
  const bool stopped = result.traced < 1;
  if (stopped && result.traced == 0) throw Interrupted();
  // Ctrl-C has done what it is for; a second one stops the writing.
  if (stopped) forget_interrupt();
  if (flags.output.empty()) {
    std::string text;
    for (const auto& table : all_tables(result))
      text += (text.empty() ? "" : "\n") + table_markdown(table, result.traced);
    print(text);
  } else {
    write(result, flags.output);
  }
  if (stopped) throw Interrupted();
  if (options.team != nullptr) options.team->forget();
  return 0;
}

} // namespace

Command add_simulate(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<SimulateFlags>();
  CLI::App* command = app.add_subcommand("simulate", "Rays on a generated surface: masking, shadowing and lobes");
  set_usage(*command, {"SCENE.json"});
  command->add_option("scene", flags->scene, "The surface, and what is measured on it")->type_name("SCENE.json");
  command
      ->add_option("-o,--output", flags->output,
                   "Folder of ID.csv and ID.md; without it tables go to stdout. After Ctrl-C what was traced so far is "
                   "written, as ID.partial.csv and ID.partial.md")
      ->type_name("DIR");
  add_pieces_flag(*command, flags->pieces);
  command->footer(footer("brdfplot simulate configs/scenes/v_cavity.json"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
