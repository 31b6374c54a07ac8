/// \file
/// brdfplot convert: a material as a file of measured data.

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/text_files.hpp"
#include "brdf/measured/merl_writer.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "render.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace brdfplot::cli {

namespace {

struct ConvertFlags {
  std::string material;
  std::string output;
};

int run(const ConvertFlags& flags, const Settings& settings) {
  require_argument(!flags.material.empty(), "convert", "MATERIAL.json");
  require_argument(!flags.output.empty(), "convert", "-o FILE.binary");
  if (flags.output != "-" && !flags.output.ends_with(".binary"))
    throw InputError("-o", "found \"" + echo(flags.output) +
                               "\"; accepted: a name that ends in .binary (MERL), or - (stdout)");
  Material material = build(config::material_of_argument(flags.material));
  material.name = config::name_of_argument(flags.material); // errors name the material by its file
  OutputFile out(flags.output);
  std::string bytes;
  run_tasks({{flags.output, [&] { bytes = merl_bytes(material, settings.threads); }}}, settings);
  out.write(bytes);
  out.commit();
  return 0;
}

} // namespace

Command add_convert(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<ConvertFlags>();
  CLI::App* command = app.add_subcommand("convert", "A material as a MERL file of 90 x 90 x 180 cells");
  set_usage(*command, {"MATERIAL.json -o FILE.binary"});
  add_material(*command, flags->material, "The material: isotropic and reciprocal, which a MERL file assumes");
  command
      ->add_option("-o,--output", flags->output,
                   "The file (35 MB): the BRDF at the centre of each cell, -1 in cells that are below the horizon. The "
                   "term merl reads it")
      ->type_name("FILE.binary|-");
  command->footer(footer("brdfplot convert configs/materials/bright_gold.json -o bright_gold.binary"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
