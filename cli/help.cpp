/// \file
/// brdfplot help: what --help prints.

#include "base/errors.hpp"
#include "command.hpp"
#include "models/parameters.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace brdfplot::cli {

namespace {

int run_help(CLI::App& app, const std::string& wanted) {
  if (wanted.empty()) {
    // The help of the chosen command would be printed instead.
    app.clear();
    print(app.help());
    return 0;
  }
  std::vector<std::string> names;
  for (CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == wanted) {
      print(command->help("brdfplot"));
      return 0;
    }
    names.push_back(command->get_name());
  }
  throw InputError("help", unknown_name("command", wanted, names));
}

} // namespace

Command add_help(CLI::App& app) {
  const auto wanted = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("help", "The help of a command");
  command->add_option("command", *wanted, "Which; default: all commands")->type_name("COMMAND");
  command->footer(footer("brdfplot help eval"));
  return {command, [&app, wanted] { return run_help(app, *wanted); }};
}

} // namespace brdfplot::cli
