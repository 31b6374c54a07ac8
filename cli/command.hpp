/// \file
/// What the commands share: the global flags, and how a command is added. One file a command.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace brdfplot {
class Team;
} // namespace brdfplot

namespace brdfplot::cli {

/// The global flags.
struct Settings {
  int threads = 1;
  bool quiet = false;
  std::string progress = "auto"; ///< auto, always or never
  std::string color = "auto";    ///< auto, always or never
  Team* team = nullptr;          ///< of the commands whose work ranks share
};

/// A command: its description and flags in CLI11, and what it does after parsing. Returns the exit code.
struct Command {
  CLI::App* app = nullptr;
  std::function<int()> run;
};

/// Each adds a command to `app`. `settings` is read when the command runs.
Command add_eval(CLI::App& app, const Settings& settings);
Command add_pareto(CLI::App& app, const Settings& settings);
Command add_plot(CLI::App& app, const Settings& settings);
Command add_advise(CLI::App& app, const Settings& settings);
Command add_bake(CLI::App& app, const Settings& settings);
Command add_check(CLI::App& app, const Settings& settings);
Command add_compare(CLI::App& app, const Settings& settings);
Command add_convert(CLI::App& app, const Settings& settings);
Command add_fit(CLI::App& app, const Settings& settings);
Command add_report(CLI::App& app, const Settings& settings);
Command add_sample(CLI::App& app, const Settings& settings);
Command add_simulate(CLI::App& app, const Settings& settings);
Command add_stress(CLI::App& app, const Settings& settings);
Command add_list(CLI::App& app);
Command add_help(CLI::App& app);
Command add_schema(CLI::App& app);
Command add_validate(CLI::App& app, const Settings& settings);

/// The head of the command's help: what it cannot do without, and what else it cannot.
void set_usage(CLI::App& command, const std::vector<std::string>& required);

/// The end of every command's help.
std::string footer(const std::string& example);

/// The arguments of a command that are materials, or may be: files or JSON, with or without -m before them, in the
/// order of the line; config::material_of_argument() reads them.
CLI::Option* add_materials(CLI::App& command, std::vector<std::string>& materials, const std::string& doc);

/// The same of a command that takes one.
CLI::Option* add_material(CLI::App& command, std::string& material, const std::string& doc);

/// \throws InputError when `value`, which `command` needs, is not given; `what` says what it is.
void require_argument(bool given, const std::string& command, const std::string& what);

/// The value of --tolerance; `fallback` when it is not given. \throws InputError
double read_tolerance(const std::string& text, double fallback);

/// Text to a file, or to stdout ("-"): all of it or a FileError. Who reads stdout may stop early; the command goes on,
/// to its own exit code.
void write_output(const std::string& path, const std::string& text);

/// The same to stdout.
void print(const std::string& text);

} // namespace brdfplot::cli
