/// \file
/// brdfplot validate: files read and checked, nothing computed.

#include "base/errors.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace brdfplot::cli {

namespace {

int run(const std::vector<std::string>& files, const Settings& settings) {
  require_argument(!files.empty(), "validate", "FILE...");
  int code = 0;
  for (const auto& file : files) {
    std::string kind;
    try {
      kind = config::validate(file);
    } catch (const Error& error) {
      print_error(settings, error.what());
      code = std::max(code, error.exit_code());
      continue;
    }
    if (!settings.quiet) print(config::name_of_argument(file) + ": ok (" + kind + ")\n");
  }
  return code;
}

} // namespace

Command add_validate(CLI::App& app, const Settings& settings) {
  const auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("validate", "Check materials, figures and reports without computing");
  set_usage(*command, {"FILE..."});
  add_materials(*command, *files, "The files, of any kind")->type_name("FILE|JSON");
  command->footer(footer("brdfplot validate configs/materials/ggx.json configs/materials/rough_gold.json"));
  return {command, [files, &settings] { return run(*files, settings); }};
}

} // namespace brdfplot::cli
