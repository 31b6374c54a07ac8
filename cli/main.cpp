/// \file
/// The command line: global flags, the commands, and errors as exit codes.

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/threads/interrupt.hpp"
#include "base/threads/parallel.hpp"
#include "base/threads/team.hpp"
#include "command.hpp"
#include "last_resort.hpp"
#include "math/kernels/kernels.hpp"
#include "models/parameters.hpp"
#include "start_ranks.hpp"
#include "terminal.hpp"
#include "usage.hpp"
#include "version.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <new>
#include <string_view>
#include <thread>

#include <fcntl.h>
#include <sched.h>
#include <unistd.h>

namespace {

using namespace brdfplot;

/// A standard stream that is closed would give its number to the next file that is opened, and what is meant for
/// stderr would end up in it. Each is opened the wrong way round, so that its use is an error, as it should be.
void keep_standard_streams_apart() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(fd, F_GETFD) < 0 && open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) != fd) return;
}

std::string check_threads(const std::string& text) {
  int count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error == std::errc() && end == text.data() + text.size() && count >= 1) return {};
  return "found \"" + echo(text) + "\", accepted: a whole number >= 1";
}

std::string check_when(const std::string& text) {
  const std::vector<std::string> accepted = {"auto", "always", "never"};
  if (std::ranges::find(accepted, text) != accepted.end()) return {};
  return unknown_name("value", text, accepted);
}

void add_global_flags(CLI::App& app, cli::Settings& settings) {
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.set_version_flag("-V,--version", "brdfplot " + std::string(version), "Print the version and exit");
  app.add_option("--threads", settings.threads, "How many threads compute; default: all")
      ->type_name("N")
      ->check(CLI::Validator(check_threads, ""));
  app.add_flag("--quiet", settings.quiet, "Nothing but errors on stderr, nothing of validate on stdout");
  app.add_option("--progress", settings.progress, "Progress on stderr: auto (on a terminal), always, never")
      ->type_name("WHEN")
      ->check(CLI::Validator(check_when, ""));
  app.add_option("--color", settings.color,
                 "Colour of errors and tables: auto (on a terminal, without NO_COLOR), always, never")
      ->type_name("WHEN")
      ->check(CLI::Validator(check_when, ""));
}

int parse_and_run(int argc, char** argv, cli::Settings& settings) {
  CLI::App app("Microfacet BRDF models: evaluation, figures and reports", "brdfplot");
  app.fallthrough();
  app.require_subcommand(0, 1); // so that the second word of `schema report` is no command
  if (const auto error = kernels::isa_request_error()) throw InputError("BRDFPLOT_ISA", *error);
  add_global_flags(app, settings);
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.footer("brdfplot COMMAND --help shows the flags of a command.\n\nExample:\n"
             "  brdfplot eval configs/materials/ggx.json -q lambda,g1 -i configs/points/theta_o.csv");
  const std::vector<cli::Command> commands = {cli::add_eval(app, settings),
                                              cli::add_plot(app, settings),
                                              cli::add_check(app, settings),
                                              cli::add_fit(app, settings),
                                              cli::add_report(app, settings),
                                              cli::add_sample(app, settings),
                                              cli::add_compare(app, settings),
                                              cli::add_bake(app, settings),
                                              cli::add_pareto(app, settings),
                                              cli::add_stress(app, settings),
                                              cli::add_advise(app, settings),
                                              cli::add_simulate(app, settings),
                                              cli::add_convert(app, settings),
                                              cli::add_list(app),
                                              cli::add_help(app),
                                              cli::add_schema(app),
                                              cli::add_validate(app, settings)};
  for (const auto& command : commands) command.app->group("Commands");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion& call) {
    cli::print(std::string(call.what()) + "\n");
    return 0;
  } catch (const CLI::CallForHelp&) {
    cli::print(app.help());
    return 0;
  } catch (const CLI::ParseError& error) {
    throw cli::usage_error(app, error);
  }
  for (const auto& command : commands) {
    if (!command.app->parsed()) continue;
    const int code = command.run();
    cli::print_warnings(settings);
    return code;
  }
  throw cli::no_command(app);
}

/// What goes wrong, told, as an exit code.
template <class Work>
int exit_code_of(const cli::Settings& settings, const Work& work) {
  try {
    return work();
  } catch (const Interrupted& error) {
    if (settings.team != nullptr && settings.team->count() > 1) settings.team->leave_interrupted();
    cli::print_error(settings, error.what());
    _exit(error.exit_code()); // work that could not be interrupted may still be running
  } catch (const ClosedPipe&) {
    cli::print_warnings(settings); // of rows that were written
    return 0;
  } catch (const Error& error) {
    cli::print_warnings(settings);
    cli::print_error(settings, error.what());
    return error.exit_code();
  } catch (const std::bad_alloc&) {
    cli::print_error(settings, cli::no_memory);
    return cli::no_memory_code;
  } catch (const std::exception& error) {
    cli::print_error(settings, std::string("internal: ") + error.what());
    return 2;
  }
}

/// Whether the command is one whose work ranks share. The others are as many processes as mpirun starts.
bool is_shared(int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc, [](std::string_view word) { return word == "bake" || word == "simulate"; });
}

/// The threads of each rank, where nothing is said: no more than mpirun lets it have, or its part of the machine.
int threads_of_a_rank(const Team& team) {
  cpu_set_t allowed;
  const int most = sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : hardware_threads();
  return std::clamp(hardware_threads() / team.on_this_machine(), 1, std::max(most, 1));
}

/// Rank 0 speaks and writes. What the others have to say they say to it, but that rank 0 is dead.
int run_on_ranks(int argc, char** argv, cli::Settings& settings) {
  const int told = dup(STDERR_FILENO);
  if (launched().rank > 0)
    for (const int fd : {STDOUT_FILENO, STDERR_FILENO})
      if (const int null = open("/dev/null", O_WRONLY); null >= 0) dup2(null, fd);
  const auto leave = [&](const Error* error) {
    if (error != nullptr) {
      dup2(told, STDERR_FILENO);
      cli::print_error(settings, error->what());
    }
    // mpirun loses what was written when a process ends at once; those who say nothing wait for it to end them.
    std::this_thread::sleep_for(std::chrono::milliseconds(error != nullptr ? 300 : 2000));
    _exit(error != nullptr ? error->exit_code() : 3);
  };
  std::unique_ptr<Team> team;
  const int code = exit_code_of(settings, [&] {
    team = std::make_unique<Team>(cli::start_ranks(), leave);
    settings.team = team.get();
    settings.threads = threads_of_a_rank(*team);
    if (team->leads()) return parse_and_run(argc, argv, settings);
    try {
      return parse_and_run(argc, argv, settings);
    } catch (const Interrupted&) {
      throw;
    } catch (...) {
      team->report(Failure::current());
      return 0;
    }
  });
  if (team == nullptr || team->count() == 1) return code;
  team->end();
  _exit(team->leads() ? code : 0); // work that was broken off may still be running
}

} // namespace

int main(int argc, char** argv) {
  keep_standard_streams_apart();
  std::signal(SIGPIPE, SIG_IGN); // a closed pipe is an error of the write
  install_interrupt_handler();
  cli::Settings settings;
  settings.threads = hardware_threads();
  if (is_shared(argc, argv)) return run_on_ranks(argc, argv, settings);
  return exit_code_of(settings, [&] { return parse_and_run(argc, argv, settings); });
}
