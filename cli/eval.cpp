/// \file
/// brdfplot eval: quantities of a material for a stream of directions.

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/split.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "models/parameters.hpp"
#include "stream/grid.hpp"
#include "stream/stream.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace brdfplot::cli {

namespace {

struct EvalFlags {
  std::string material;
  std::vector<std::string> quantities;
  std::string input;
  std::vector<std::string> grid;
  std::string output = "-";
  std::string tolerance;
  std::string precision = "double";
  std::string strategy;
};

std::vector<std::string> names_in(const std::vector<std::string>& lists) {
  std::vector<std::string> names;
  for (const auto& list : lists)
    for (const auto& name : split(list, ',')) names.push_back(name);
  return names;
}

bool is_single(const std::string& precision) {
  const std::vector<std::string> accepted = {"double", "single"};
  if (std::ranges::find(accepted, precision) == accepted.end())
    throw InputError("--precision", unknown_name("precision", precision, accepted));
  return precision == "single";
}

int run(const EvalFlags& flags, const Settings& settings) {
  require_argument(!flags.material.empty(), "eval", "MATERIAL.json");
  require_argument(!flags.quantities.empty(), "eval", "-q Q[,Q...]");
  StreamOptions options{select_quantities(names_in(flags.quantities), "-q"),
                        read_tolerance(flags.tolerance, default_tolerance), settings.threads,
                        is_single(flags.precision)};
  const bool density = std::ranges::any_of(options.quantities, [](const auto& q) { return q.is_density(); });
  if (!flags.strategy.empty() && !density)
    throw InputError("--strategy",
                     "found \"" + echo(flags.strategy) + "\" without the quantity \"pdf\"; accepted: none");
  if (!flags.strategy.empty()) options.strategy = flags.strategy;
  Material material = build(config::material_of_argument(flags.material));
  material.name = config::name_of_argument(flags.material); // errors name the material by its file
  if (!flags.grid.empty() && !flags.input.empty())
    throw InputError("--grid", "found beside -i; accepted: one of the two");
  std::optional<InputFile> file;
  std::unique_ptr<RowSource> in;
  if (flags.grid.empty())
    in = std::make_unique<FileRows>(file.emplace(flags.input.empty() ? "-" : flags.input));
  else
    in = std::make_unique<GridRows>(flags.grid, "--grid");
  OutputFile out(flags.output);
  evaluate_stream(material, options, *in, out);
  out.commit();
  return 0;
}

} // namespace

Command add_eval(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<EvalFlags>();
  CLI::App* command = app.add_subcommand("eval", "Quantities of a material for the directions of a CSV or a grid");
  set_usage(*command, {"MATERIAL.json -q Q[,Q...]"});
  add_material(*command, flags->material, "The material");
  command
      ->add_option("-q,--quantities", flags->quantities,
                   "What to compute, separated by commas (brdfplot list quantities)")
      ->type_name("Q[,Q...]")
      ->allow_extra_args(false);
  command
      ->add_option(
          "-i,--input", flags->input,
          "Directions: columns theta_o phi_o theta_i ..., or x_o y_o z_o ...; default: stdin. At and below the "
          "horizon G1 and the BRDF are 0; 90deg is above it, by the 6e-17 that its cosine is in doubles. "
          "phi at the normal means nothing: what depends on a difference of azimuths takes 0")
      ->type_name("FILE|-");
  command
      ->add_option("--grid", flags->grid,
                   "Directions instead of a CSV: theta_o=0:90deg:1deg, or theta_o=60deg; of several --grid every "
                   "combination, the last the fastest. Written in radians")
      ->type_name("NAME=FROM:TO:STEP")
      ->allow_extra_args(false);
  command->add_option("-o,--output", flags->output, "Every input column, then one per quantity; default: stdout")
      ->type_name("FILE|-");
  command->add_option("--tolerance", flags->tolerance, "Largest error accepted of integrals; default: 1e-9")
      ->type_name("NUMBER");
  command
      ->add_option("--precision", flags->precision,
                   "double, or single: the kernels in float, values in the shortest form that reads back to a float. "
                   "Directions are rounded to float first, which changes the BRDF of Beckmann and GGX by up to "
                   "2.4e-7 / (alpha cos theta): 6 % for alpha = 8e-4 at 89.9deg, more than tenfold for 2e-6 there")
      ->type_name("double|single");
  command
      ->add_option("--strategy", flags->strategy,
                   "How the directions are drawn whose density is pdf (brdfplot sample --help); default: default")
      ->type_name("NAME");
  command->footer(footer("brdfplot eval configs/materials/ggx.json -q lambda,g1 -i configs/points/theta_o.csv"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
