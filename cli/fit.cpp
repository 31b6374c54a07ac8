/// \file
/// brdfplot fit: Smith's Lambda of a material as the cheapest rational that is accurate enough, for shaders.

#include "analysis/fit/code.hpp"
#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text_files.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "figure/fit_figure.hpp"
#include "render.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace brdfplot::cli {

namespace {

struct FitFlags {
  std::string material;
  std::string tolerance;
  bool fixed = false;
  std::string output;
};

double fit_tolerance(const std::string& text) {
  if (text.empty()) return FitOptions{}.tolerance;
  const auto value = parse_number(text);
  if (!value || !(*value > 0) || *value > 0.1)
    throw InputError("--tolerance", "found \"" + echo(text) + "\"; accepted: a number in (0, 0.1]");
  return *value;
}

void write_files(const FitResult& result, double tolerance, const std::string& folder) {
  const std::string id = fit_identifier(result.target.name);
  const plot::Figure figure = plot::fit_error_figure(result, tolerance, id + "_error");
  create_folders(folder);
  write_text_files({{in_folder(folder, id + ".hpp"), fit_code(result, tolerance, FitLanguage::cpp)},
                    {in_folder(folder, id + ".glsl"), fit_code(result, tolerance, FitLanguage::glsl)},
                    {in_folder(folder, id + ".hlsl"), fit_code(result, tolerance, FitLanguage::hlsl)},
                    {in_folder(folder, id + "_error.svg"), plot::to_svg(figure)},
                    {in_folder(folder, id + "_error.csv"), plot::to_csv(figure)}});
}

/// The fit; what the material has that cannot be fitted, or not so well, is said of the file.
FitResult fit_of(const FitFlags& flags, const MaterialDescription& material, const FitOptions& options) {
  try {
    return fit_lambda(material, options);
  } catch (const MaterialError& error) {
    throw InputError(config::name_of_argument(flags.material) + ": " + error.pointer(), error.reason());
  } catch (const AccuracyError& error) {
    throw AccuracyError(config::name_of_argument(flags.material), error.what());
  }
}

int run(const FitFlags& flags, const Settings& settings) {
  require_argument(!flags.material.empty(), "fit", "MATERIAL.json");
  const double tolerance = fit_tolerance(flags.tolerance);
  const MaterialDescription material = config::material_of_argument(flags.material);
  FitResult result;
  run_tasks({{material.name,
              [&] {
                result = fit_of(flags, material, {tolerance, flags.fixed, settings.threads});
              }}},
            settings);
  if (flags.output.empty()) {
    print(fit_code(result, tolerance, FitLanguage::cpp));
    return 0;
  }
  write_files(result, tolerance, flags.output);
  std::string text;
  for (const auto& line : describe(result, tolerance)) text += line + "\n";
  print(text);
  return 0;
}

} // namespace

Command add_fit(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<FitFlags>();
  CLI::App* command = app.add_subcommand("fit", "Smith's masking of a material as code for shaders");
  set_usage(*command, {"MATERIAL.json"});
  add_material(*command, flags->material, "The material");
  command->add_option("--tolerance", flags->tolerance, "Largest relative error of G1; default: 1e-4")
      ->type_name("NUMBER");
  command->add_flag(
      "--fixed", flags->fixed,
      "The parameters exponent (phong), alpha (gtr) and gamma (student_t) as constants, not as arguments");
  command
      ->add_option(
          "-o,--output", flags->output,
          "Folder of NAME.hpp, NAME.glsl, NAME.hlsl, NAME_error.svg and NAME_error.csv; default: C++ on stdout")
      ->type_name("DIR");
  command->footer(footer("brdfplot fit configs/materials/beckmann.json --tolerance 1e-3"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
