/// \file
/// brdfplot schema: the JSON Schema of a kind of file.

#include "command.hpp"
#include "config/load.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace brdfplot::cli {

Command add_schema(CLI::App& app) {
  const auto kind = std::make_shared<std::string>();
  std::string accepted;
  for (const auto& name : config::kinds()) accepted += (accepted.empty() ? "" : ", ") + name;
  CLI::App* command = app.add_subcommand("schema", "The JSON Schema that the reader of a kind of file enforces");
  set_usage(*command, {"KIND"});
  command->add_option("kind", *kind, accepted)->type_name("KIND");
  command->footer(footer("brdfplot schema material"));
  const auto run = [kind, accepted] {
    require_argument(!kind->empty(), "schema", "KIND: " + accepted);
    print(config::schema(*kind));
    return 0;
  };
  return {command, run};
}

} // namespace brdfplot::cli
