#include "usage.hpp"

#include "microfacet/parameters.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace brdfplot::cli {

namespace {

const std::string command_line = "command line";

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

void append_flags(const CLI::App& app, std::vector<std::string>& flags) {
  for (const CLI::Option* option : app.get_options()) {
    for (const auto& name : option->get_snames()) flags.push_back("-" + name);
    for (const auto& name : option->get_lnames()) flags.push_back("--" + name);
  }
}

/// `argument` is what nothing took.
InputError unexpected(const CLI::App& app, const std::string& argument) {
  const auto chosen = app.get_subcommands();
  if (argument.size() > 1 && argument.front() == '-') {
    std::vector<std::string> flags;
    if (!chosen.empty()) append_flags(*chosen.front(), flags);
    append_flags(app, flags);
    return {command_line, unknown_name("flag", argument.substr(0, argument.find('=')), flags)};
  }
  if (chosen.empty()) return {command_line, unknown_name("command", argument, command_names(app))};
  return {command_line, "found \"" + argument + "\", which is one argument too many for " + chosen.front()->get_name()};
}

} // namespace

InputError usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto rest = app.remaining(true);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !rest.empty()) return unexpected(app, rest.front());
  return {command_line, error.what()};
}

InputError no_command(const CLI::App& app) {
  std::string names;
  for (const auto& name : command_names(app)) names += (names.empty() ? "" : ", ") + name;
  return {command_line, "no command is given; accepted: " + names};
}

} // namespace brdfplot::cli
