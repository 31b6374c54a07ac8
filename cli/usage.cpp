#include "usage.hpp"

#include "base/echo.hpp"
#include "models/parameters.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
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
  const auto append = [&](const std::string& flag) {
    if (std::ranges::find(flags, flag) == flags.end()) flags.push_back(flag);
  };
  for (const CLI::Option* option : app.get_options()) {
    for (const auto& name : option->get_snames()) append("-" + name);
    for (const auto& name : option->get_lnames()) append("--" + name);
  }
}

/// CLI11's message of a flag starts with it, and then counts arguments.
InputError miscounted(const std::string& message) {
  const std::string flag = message.substr(0, message.find(':'));
  const bool missing = message.ends_with("missing");
  return {flag, missing ? "needs a value after it" : "is given more than once"};
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
  return {command_line,
          "found \"" + echo(argument) + "\", which is one argument too many for " + chosen.front()->get_name()};
}

} // namespace

InputError usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto rest = app.remaining(true);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !rest.empty()) return unexpected(app, rest.front());
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) return miscounted(error.what());
  if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr) return {"", error.what()};
  return {command_line, error.what()};
}

InputError no_command(const CLI::App& app) {
  std::string names;
  for (const auto& name : command_names(app)) names += (names.empty() ? "" : ", ") + name;
  return {command_line, "no command is given; accepted: " + names};
}

} // namespace brdfplot::cli
