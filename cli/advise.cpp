/// \file
/// brdfplot advise: the least model that a scene needs.

#include "base/errors.hpp"
#include "base/text_files.hpp"
#include "choice/advise/text.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "render.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace brdfplot::cli {

namespace {

struct AdviseFlags {
  std::string scene;
  std::string output;
  bool json = false;
};

std::vector<choice::MaterialAdvice> advice_for(const choice::AdviceScene& scene, const Settings& settings) {
  std::vector<choice::MaterialAdvice> all;
  for (const choice::AdvisedMaterial& material : scene.materials) {
    Progress progress(settings);
    const auto show = [&](std::size_t done, std::size_t total) {
      progress.set(done, total, "models of " + material.material.name);
    };
    all.push_back(choice::advise(scene, material, {settings.threads, show}));
  }
  return all;
}

std::string text_of(const choice::AdviceScene& scene, const std::vector<choice::MaterialAdvice>& all) {
  std::string text;
  for (const choice::MaterialAdvice& one : all) text += (text.empty() ? "" : "\n") + choice::advice_text(scene, one);
  return text;
}

/// What no model can do, and the nearest that one can.
std::string shortfall(const choice::AdviceScene& scene, const choice::MaterialAdvice& advice) {
  const auto number = [](double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", x);
    return std::string(text);
  };
  const auto point = [&](std::size_t k) {
    const choice::Model& m = advice.models[k];
    return "cost " + number(m.cost) + " with an error of " + number(choice::decisive(m));
  };
  const std::string asked = "asked: " + (scene.budget ? "cost " + number(*scene.budget) + " with " : std::string()) +
                            "an error of " + number(scene.tolerance.value);
  std::string nearest;
  if (advice.answer) nearest = "the cheapest within the tolerance: " + point(*advice.answer);
  if (advice.best_in_budget)
    nearest += (nearest.empty() ? "" : "; ") + ("the best within the budget: " + point(*advice.best_in_budget));
  if (nearest.empty() && advice.best_cheaper) nearest = "the nearest: " + point(*advice.best_cheaper);
  return advice.name + ": no model does; " + asked + "; " + nearest;
}

int run(const AdviseFlags& flags, const Settings& settings) {
  require_argument(!flags.scene.empty(), "advise", "SCENE.json");
  const choice::AdviceScene scene = config::load_advice(flags.scene);
  const std::vector<choice::MaterialAdvice> all = advice_for(scene, settings);
  print(flags.json ? config::advice_record(scene, all) : text_of(scene, all));
  int code = 0;
  for (const choice::MaterialAdvice& one : all) {
    if (one.within_budget(scene)) continue;
    print_error(settings, shortfall(scene, one));
    code = 1;
  }
  return code;
}

} // namespace

Command add_advise(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<AdviseFlags>();
  CLI::App* command = app.add_subcommand("advise", "The least model of a material that a scene needs");
  command->add_option("scene", flags->scene, "Materials, lights and what is seen of them")->type_name("SCENE.json");
  command
      ->add_option("-o,--output", flags->output,
                   "Folder of advice.txt and, for each material, NAME.json, NAME_models.csv and NAME_ladder.svg")
      ->type_name("DIR");
  command->add_flag("--json", flags->json, "The answer as JSON");
  command->footer(footer("brdfplot advise configs/scenes/brushed_steel.json"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
