/// \file
/// brdfplot fit: Smith's Lambda of a material, or its albedo, as the cheapest rational that is accurate enough, for
/// shaders.

#include "analysis/fit/albedo.hpp"
#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text_files.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "figure/fit_figure.hpp"
#include "render.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace brdfplot::cli {

namespace {

struct FitFlags {
  std::string material;
  std::string quantity = "lambda";
  std::string tolerance;
  bool fixed = false;
  std::string output;
};

double fit_tolerance(const std::string& text, double by_default) {
  if (text.empty()) return by_default;
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

/// Calls `fit`; what the material has that cannot be fitted, or not so well, is said of the file.
template <class Fit>
auto named_by_file(const std::string& file, const Fit& fit) {
  try {
    return fit();
  } catch (const MaterialError& error) {
    throw InputError(file + ": " + error.pointer(), error.reason());
  } catch (const AccuracyError& error) {
    throw AccuracyError(file, error.what());
  }
}

std::string as_text(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

int run_albedo(const FitFlags& flags, const Settings& settings) {
  const Integral quantity = flags.quantity == "furnace" ? Integral::furnace : Integral::albedo;
  const double tolerance = fit_tolerance(flags.tolerance, AlbedoFitOptions{}.tolerance);
  const MaterialDescription material = config::material_of_argument(flags.material);
  AlbedoFit fit;
  run_tasks({{material.name,
              [&] {
                fit = named_by_file(config::name_of_argument(flags.material), [&] {
                  return fit_albedo(material, {quantity, tolerance, flags.fixed, settings.threads});
                });
              }}},
            settings);
  if (flags.output.empty()) {
    print(fit_code(fit, FitLanguage::cpp));
    return 0;
  }
  const std::string id = fit_identifier(material.name) + "_" + flags.quantity;
  create_folders(flags.output);
  write_text_files({{in_folder(flags.output, id + ".hpp"), fit_code(fit, FitLanguage::cpp)},
                    {in_folder(flags.output, id + ".glsl"), fit_code(fit, FitLanguage::glsl)},
                    {in_folder(flags.output, id + ".hlsl"), fit_code(fit, FitLanguage::hlsl)}});
  print(as_text(describe(fit)));
  return 0;
}

int run(const FitFlags& flags, const Settings& settings) {
  require_argument(!flags.material.empty(), "fit", "MATERIAL.json");
  const std::vector<std::string> quantities = {"lambda", "albedo", "furnace"};
  if (std::ranges::find(quantities, flags.quantity) == quantities.end())
    throw InputError("--quantity", unknown_name("quantity", flags.quantity, quantities));
  if (flags.quantity != "lambda") return run_albedo(flags, settings);
  const double tolerance = fit_tolerance(flags.tolerance, FitOptions{}.tolerance);
  const MaterialDescription material = config::material_of_argument(flags.material);
  FitResult result;
  run_tasks({{material.name,
              [&] {
                result = named_by_file(config::name_of_argument(flags.material), [&] {
                  return fit_lambda(material, {tolerance, flags.fixed, settings.threads});
                });
              }}},
            settings);
  if (flags.output.empty()) {
    print(fit_code(result, tolerance, FitLanguage::cpp));
    return 0;
  }
  write_files(result, tolerance, flags.output);
  print(as_text(describe(result, tolerance)));
  return 0;
}

} // namespace

Command add_fit(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<FitFlags>();
  CLI::App* command = app.add_subcommand("fit", "Smith's masking of a material, or its albedo, as code for shaders");
  set_usage(*command, {"MATERIAL.json"});
  add_material(*command, flags->material, "The material");
  command
      ->add_option(
          "-q,--quantity", flags->quantity,
          "lambda: Smith's masking; albedo: what a grey material reflects of a white surround, over the cosine "
          "and alpha; furnace: the same with F = 1; default: lambda")
      ->type_name("NAME");
  command
      ->add_option("--tolerance", flags->tolerance,
                   "Largest relative error of G1, default: 1e-4; or absolute of an albedo, default: 1e-3")
      ->type_name("NUMBER");
  command->add_flag("--fixed", flags->fixed,
                    "The parameters exponent (phong), alpha (gtr) and gamma (student_t), and alpha of an "
                    "albedo, as constants, not as arguments");
  command
      ->add_option(
          "-o,--output", flags->output,
          "Folder of NAME.hpp, NAME.glsl, NAME.hlsl, and of Lambda NAME_error.svg and NAME_error.csv; default: C++ on "
          "stdout")
      ->type_name("DIR");
  command->footer(footer("brdfplot fit configs/materials/beckmann.json --tolerance 1e-3"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
