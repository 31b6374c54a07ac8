/// \file
/// brdfplot advise: the least model that a scene needs.

#include "analysis/fit/code.hpp"
#include "base/errors.hpp"
#include "base/text_files.hpp"
#include "choice/advise/examine.hpp"
#include "choice/advise/text.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "figure/advice_figure.hpp"
#include "render.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
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
    all.back().examined = choice::examine(scene, all.back(), settings.threads);
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

/// Smith's Lambda of the terms that have one as a rational, where `fit` has it.
void append_code(const MaterialDescription& material, const std::string& id, const std::string& folder, int threads,
                 std::vector<NamedText>& files) {
  for (const TermDescription& term : material.terms) {
    if (term.type != "mirror" || term.masking.type != "smith") continue;
    TermDescription alone = term;
    alone.layers.clear();
    const std::string name = material.terms.size() > 1 ? id + "_" + term.name : id;
    try {
      const FitOptions options{FitOptions{}.tolerance, false, threads};
      const FitResult fit = fit_lambda(MaterialDescription(name, {alone}, true), options);
      files.push_back(
          {in_folder(folder, fit_identifier(name) + ".glsl"), fit_code(fit, options.tolerance, FitLanguage::glsl)});
    } catch (const MaterialError&) {
      // fit_lambda says what it takes; the material file stands without it.
    }
  }
}

void write_files(const choice::AdviceScene& scene, const std::vector<choice::MaterialAdvice>& all,
                 const std::string& folder, const Settings& settings) {
  std::vector<NamedText> files = {{in_folder(folder, "advice.txt"), text_of(scene, all)}};
  for (const choice::MaterialAdvice& one : all) {
    const std::string id = fit_identifier(one.name);
    const plot::Figure figure = plot::advice_figure(scene, one, id + "_ladder");
    files.push_back({in_folder(folder, id + "_models.csv"), choice::models_csv(scene, one)});
    files.push_back({in_folder(folder, id + "_ladder.svg"), plot::to_svg(figure)});
    files.push_back({in_folder(folder, id + "_ladder.csv"), plot::to_csv(figure)});
    if (!one.answer) continue;
    const MaterialDescription& material = one.models[*one.answer].materials[0];
    files.push_back({in_folder(folder, id + ".json"), config::material_text(material)});
    append_code(material, id, folder, settings.threads, files);
  }
  write_text_files(files);
}

/// Files are named after materials: two names may be one as a file.
void require_distinct_files(const AdviseFlags& flags, const choice::AdviceScene& scene) {
  std::vector<std::string> ids;
  for (const choice::AdvisedMaterial& one : scene.materials) {
    const std::string id = fit_identifier(one.material.name);
    if (std::ranges::find(ids, id) != ids.end())
      throw InputError(flags.scene, "two materials would be written to \"" + id +
                                        ".json\"; accepted: names that differ in letters and digits");
    ids.push_back(id);
  }
}

int run(const AdviseFlags& flags, const Settings& settings) {
  require_argument(!flags.scene.empty(), "advise", "SCENE.json");
  const choice::AdviceScene scene = config::load_advice(flags.scene);
  if (!flags.output.empty()) {
    require_distinct_files(flags, scene);
    create_folders(flags.output);
  }
  const std::vector<choice::MaterialAdvice> all = advice_for(scene, settings);
  if (!flags.output.empty()) write_files(scene, all, flags.output, settings);
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
  set_usage(*command, {"SCENE.json"});
  command->add_option("scene", flags->scene, "Materials, lights and what is seen of them")->type_name("SCENE.json");
  command
      ->add_option(
          "-o,--output", flags->output,
          "Folder of advice.txt and, for each material, NAME.json, NAME_models.csv, NAME_ladder.svg and .csv, and GLSL "
          "of what `fit` can make")
      ->type_name("DIR");
  command->add_flag("--json", flags->json, "The answer as JSON");
  command->footer(footer("brdfplot advise configs/scenes/brushed_steel.json"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
