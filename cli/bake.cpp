/// \file
/// brdfplot bake: tables for renderers.

#include "bake/bake.hpp"
#include "bake/formats.hpp"
#include "bake/text.hpp"
#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/hash.hpp"
#include "base/number.hpp"
#include "base/text_files.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "config/records/bake_record.hpp"
#include "models/parameters.hpp"
#include "render.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace brdfplot::cli {

namespace {

struct BakeFlags {
  std::string material;
  std::string quantity = "albedo";
  std::vector<std::string> over;
  std::string error, tolerance;
  std::string type;
  std::string output;
  std::optional<std::string> pieces;
  bool json = false;
};

const std::vector<std::pair<std::string, bake::Stored>>& types() {
  static const std::vector<std::pair<std::string, bake::Stored>> all = {
      {"float", bake::Stored::float32}, {"half", bake::Stored::half}, {"double", bake::Stored::float64}};
  return all;
}

bake::Stored stored_as(const std::string& type, const bake::TableFormat& format) {
  if (type.empty()) return format.stored.front();
  std::vector<std::string> accepted;
  for (const auto& one : types())
    if (std::ranges::find(format.stored, one.second) != format.stored.end()) accepted.push_back(one.first);
  if (std::ranges::find(accepted, type) == accepted.end())
    throw InputError("--type", unknown_name("type of numbers of " + format.ending, type, accepted));
  return std::ranges::find(types(), type, &std::pair<std::string, bake::Stored>::first)->second;
}

/// What is baked where nothing is said: over cos theta_o and, where it has one, alpha.
std::vector<bake::Axis> default_axes(const MaterialDescription& material, const std::string& quantity) {
  std::vector<bake::Axis> axes;
  if (quantity.starts_with("inverse_"))
    axes.push_back(bake::parse_axis("u=0:1", "--over"));
  else if (!quantity.starts_with("mean_") || quantity == "mean_fresnel")
    axes.push_back(bake::parse_axis("cos_theta_o=0:1", "--over"));
  const std::vector<std::string> keys = parameter_keys(material);
  if (std::ranges::find(keys, "alpha") != keys.end()) axes.push_back(bake::parse_axis("alpha=0.01:1", "--over"));
  return axes;
}

/// The digests of the files that a material names.
std::string digests(const std::vector<TermDescription>& terms) {
  std::string text;
  for (const TermDescription& term : terms) {
    if (term.values.has("file")) text += " " + std::to_string(hash(read_text_file(term.values.text("file"))));
    text += digests(term.of);
  }
  return text;
}

int run(const BakeFlags& flags, const Settings& settings) {
  require_argument(!flags.material.empty(), "bake", "MATERIAL.json");
  require_argument(!flags.output.empty() || flags.json, "bake", "-o TABLE or --json");
  bake::BakeOptions options;
  options.threads = settings.threads;
  options.tolerance = read_tolerance(flags.tolerance, 1e-6);
  if (!flags.error.empty()) {
    options.error = parse_number(flags.error);
    if (!options.error || !(*options.error > 0 && *options.error < infinity))
      throw InputError("--error", "found \"" + echo(flags.error) + "\", accepted: a number > 0");
  }
  const bake::TableFormat* const format = flags.output.empty() ? nullptr : &bake::format_of(flags.output);
  const bake::Stored stored = format == nullptr ? bake::Stored::float64 : stored_as(flags.type, *format);
  MaterialDescription material = config::material_of_argument(flags.material);
  material.name = config::name_of_argument(flags.material); // errors name the material by its file
  std::vector<bake::Axis> axes;
  for (const std::string& text : flags.over) axes.push_back(bake::parse_axis(text, "--over"));
  if (axes.empty()) axes = default_axes(material, flags.quantity);
  options.team = team_for(settings, flags.pieces, [&] {
    std::string over;
    for (const bake::Axis& axis : axes) over += " " + axis.variable;
    return "bake " + flags.quantity + " over" + over + " tolerance " + format_number(options.tolerance) + " of" +
           digests(material.terms) + "\n" + config::material_text(material);
  });
  if (options.team != nullptr && !options.team->leads()) {
    bake::help_to_bake(material, flags.quantity, axes, options);
    return 0;
  }
  bake::BakedTable table;
  run_tasks({{flags.quantity, [&] { table = bake::bake(material, flags.quantity, axes, options); }}}, settings);
  const double rounding = bake::rounding_of(table.table, stored);
  if (format != nullptr) write_text_file(flags.output, format->bytes(table, stored, flags.output));
  print(flags.json ? config::bake_record(table, rounding) : bake::summary(table, rounding));
  if (options.team != nullptr) options.team->forget();
  return 0;
}

std::string quantity_help() {
  std::string text;
  for (const bake::BakedInfo& info : bake::baked_quantities())
    text += (text.empty() ? "" : "; ") + info.name + ": " + info.doc;
  return text + "; default: albedo";
}

std::string output_help() {
  std::string text = "The table, by the ending of its name";
  for (const bake::TableFormat& format : bake::table_formats()) text += "; " + format.ending + ": " + format.doc;
  return text;
}

} // namespace

Command add_bake(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<BakeFlags>();
  CLI::App* command = app.add_subcommand("bake", "Tables of albedo for renderers, with their error");
  set_usage(*command, {"MATERIAL.json (-o TABLE | --json)"});
  add_material(*command, flags->material, "The material");
  command->add_option("-q,--quantity", flags->quantity, quantity_help())->type_name("NAME");
  command
      ->add_option(
          "--over", flags->over,
          "An axis, the first one fastest; each may be given: cos_theta_o, theta_o, phi_o, u or a parameter of the "
          "material. Nodes are at FROM + (TO - FROM) t^POWER, t = 0 to 1; default: cos_theta_o=0:1, or u=0:1 of "
          "inverses, and, where there is one, alpha=0.01:1, of 32 nodes")
      ->type_name("NAME=FROM:TO[:NODES[:POWER]]");
  command
      ->add_option("--error", flags->error,
                   "Takes as many nodes as the interpolation needs to be off by no more, and powers of 1 to 3, of u to "
                   "8, where none "
                   "is given")
      ->type_name("E");
  command->add_option("--tolerance", flags->tolerance, "Of the integrals; default: 1e-6")->type_name("E");
  command
      ->add_option("--type", flags->type,
                   "How numbers are stored: float, half (.npy, .ktx2, .exr), double (.npy); default: float")
      ->type_name("TYPE");
  command->add_option("-o,--output", flags->output, output_help())->type_name("TABLE");
  add_pieces_flag(*command, flags->pieces);
  command->add_flag("--json", flags->json, "The table and its error as JSON on stdout");
  command->footer(footer("brdfplot bake configs/materials/ggx.json -q furnace --error 0.01 -o ggx.npy"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
