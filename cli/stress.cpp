/// \file
/// brdfplot stress: where each method fails.

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/text_files.hpp"
#include "choice/methods/problems.hpp"
#include "choice/stress/error_map.hpp"
#include "choice/stress/exhaustive.hpp"
#include "choice/stress/findings_text.hpp"
#include "choice/stress/material_problems.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "config/records/stress_json.hpp"
#include "figure/stress_figure.hpp"
#include "models/parameters.hpp"
#include "render.hpp"
#include "terminal.hpp"
#include "version.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

namespace brdfplot::cli {

namespace {

struct StressFlags {
  std::vector<std::string> names;
  std::vector<std::string> fail_on;
  bool json = false, markdown = false, exhaustive = false;
  std::string output;
};

/// A problem, or one method of it, and what was found.
struct Asked {
  choice::Problem problem;
  std::string method; ///< none: all
  std::vector<choice::MethodReport> reports{};
  std::optional<choice::ProblemMap> map{};
};

/// A problem, or PROBLEM/METHOD.
Asked asked_by(const std::string& name) {
  const std::string problem = name.substr(0, name.find('/'));
  const std::string method = name.size() > problem.size() ? name.substr(problem.size() + 1) : "";
  std::vector<std::string> names = choice::problem_names();
  std::string wanted = problem;
  if (auto made = choice::make_problem(problem)) {
    const auto found = std::ranges::find(made->methods, method, &choice::Method::name);
    if (problem.size() == name.size() || found != made->methods.end())
      return {.problem = std::move(*made), .method = method};
    names.clear();
    for (const auto& one : made->methods) names.push_back(problem + "/" + one.name);
    wanted = name;
  }
  std::string what = "found \"" + echo(name) + "\"";
  if (const auto near = nearest(wanted, names)) what += "; did you mean \"" + *near + "\"?";
  what += " accepted: a MATERIAL.json, or a problem or problem/method:";
  for (const auto& one : choice::problem_names()) what += " " + one;
  throw InputError("stress", what);
}

void add_material(const std::string& file, std::vector<Asked>& asked) {
  const MaterialDescription material = config::material_of_argument(file);
  for (auto& problem : choice::material_problems(material))
    asked.push_back({.problem = std::move(problem), .method = ""});
}

std::vector<Asked> what_is_asked(const std::vector<std::string>& names) {
  std::vector<Asked> asked;
  for (const auto& name : names.empty() ? choice::problem_names() : names) {
    if (config::is_material_text(name) || name.ends_with(".json"))
      add_material(name, asked);
    else
      asked.push_back(asked_by(name));
  }
  return asked;
}

void check_kinds(const std::vector<std::string>& kinds) {
  auto accepted = choice::failure_names();
  accepted.emplace_back("any");
  for (const auto& kind : kinds)
    if (std::ranges::find(accepted, kind) == accepted.end())
      throw InputError("--fail-on", unknown_name("kind of failure", kind, accepted));
}

/// The list of kinds for --help.
std::string kinds_text() {
  std::string out = "Kinds of failure:\n";
  for (const auto& kind : choice::failure_kinds())
    out += "  " + std::string(kind.name) + std::string(19 - kind.name.size(), ' ') + std::string(kind.says) + "\n";
  return out +
         "Digits count as lost above a relative error of 2^-26 (1.5e-8) in double, 2^-12 (2.4e-4) in float;\n"
         "of an approximation above the error that it states, or 10 %. Numbers below 2^-511 (float: 2^-63) count\n"
         "as 0. Inputs are rounded before they are judged: what that costs is no failure. Each figure is a lower\n"
         "bound of the worst.\n\n";
}

std::string summary_of(const std::vector<choice::MethodReport>& reports) {
  const auto fail = std::ranges::count_if(reports, [](const auto& report) { return !report.findings.empty(); });
  std::size_t rows = 0;
  for (const auto& report : reports) rows += report.rows;
  return std::to_string(fail) + " of " + std::to_string(reports.size()) + " fail, looked for with " +
         std::to_string(rows) + " rows and a climb from the worst: each figure is a lower bound of the worst.\n";
}

int judge(const std::vector<choice::MethodReport>& reports, const std::vector<std::string>& fail_on) {
  const auto counts = [&](const choice::Finding& finding) {
    return std::ranges::any_of(fail_on, [&](const auto& kind) { return kind == "any" || kind == finding.kind->name; });
  };
  return std::ranges::any_of(reports, [&](const auto& report) { return std::ranges::any_of(report.findings, counts); })
             ? 1
             : 0;
}

void search_all(std::vector<Asked>& asked, bool with_maps, const Settings& settings) {
  std::vector<Task> tasks;
  for (Asked& one : asked) {
    const std::string name =
        one.problem.exact ? one.problem.name : one.problem.name + ", " + one.problem.methods.front().name;
    tasks.push_back({name, [&one, with_maps] {
                       one.reports = choice::stress(one.problem, one.method);
                       if (with_maps && one.problem.exact) one.map = choice::error_map(one.problem, one.reports);
                     }});
  }
  run_tasks(tasks, settings);
}

void write_files(const std::vector<Asked>& asked, const std::vector<choice::MethodReport>& reports,
                 const std::string& folder) {
  std::vector<NamedText> files = {
      {in_folder(folder, "failures.csv"), choice::findings_csv(reports)},
      {in_folder(folder, "failures.json"), config::stress_record(reports, std::string(version))}};
  std::set<std::string> drawn;
  for (const Asked& one : asked) {
    if (!one.map || !drawn.insert(one.map->problem).second) continue;
    const plot::Figure figure = plot::stress_figure(*one.map);
    files.push_back({in_folder(folder, figure.id + ".svg"), plot::to_svg(figure)});
    files.push_back({in_folder(folder, figure.id + ".csv"), plot::to_csv(figure)});
  }
  create_folders(folder);
  write_text_files(files);
}

/// Instead of a search, every float of the problems with one input.
int run_exhaustive(const std::vector<Asked>& asked, const Settings& settings) {
  std::vector<choice::Exhausted> all;
  for (const Asked& one : asked) {
    Progress progress(settings);
    const auto found = choice::exhaust(one.problem, one.method, settings.threads, [&](double share) {
      progress.set(static_cast<std::size_t>(100 * share), 100, one.problem.name);
    });
    all.insert(all.end(), found.begin(), found.end());
  }
  if (all.empty())
    throw InputError("stress", "--exhaustive: nothing here has one input and a method in float; accepted: problems "
                               "such as lambda_ggx");
  print(choice::exhausted_markdown(all));
  return 0;
}

int run(const StressFlags& flags, const Settings& settings) {
  check_kinds(flags.fail_on);
  if (flags.json && flags.markdown) throw InputError("stress", "accepted: one of --json, --markdown");
  std::vector<Asked> asked = what_is_asked(flags.names);
  if (flags.exhaustive) return run_exhaustive(asked, settings);
  search_all(asked, !flags.output.empty(), settings);
  std::vector<choice::MethodReport> reports;
  for (const auto& one : asked) reports.insert(reports.end(), one.reports.begin(), one.reports.end());
  if (!flags.output.empty()) write_files(asked, reports, flags.output);
  if (flags.markdown)
    print(choice::findings_markdown(reports));
  else
    print(flags.json ? config::stress_record(reports, std::string(version))
                     : choice::findings_table(reports) + summary_of(reports));
  return judge(reports, flags.fail_on);
}

} // namespace

Command add_stress(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<StressFlags>();
  CLI::App* command = app.add_subcommand("stress", "Where methods fail: lost digits, NaN, energy from nothing");
  set_usage(*command, {"[METHOD|MATERIAL.json]..."});
  add_materials(*command, flags->names,
                "Materials, and problems (brdfplot list problems) or methods of them (d_ggx/printed); default: all "
                "problems")
      ->type_name("METHOD|MATERIAL.json|JSON");
  command->add_option("-o,--output", flags->output, "Folder of failures.csv, failures.json and maps of errors")
      ->type_name("DIR");
  command->add_flag("--json", flags->json, "Every method with its largest error and its failures, as JSON");
  command->add_flag("--markdown", flags->markdown, "A table for a page");
  command->add_flag("--exhaustive", flags->exhaustive,
                    "Every float instead of a search, of methods in float with one input: an upper bound; minutes");
  command->add_option("--fail-on", flags->fail_on, "Exit code 1 when such a failure is found; may be repeated")
      ->type_name("KIND|any");
  command->footer(kinds_text() + footer("brdfplot stress d_ggx --fail-on nan"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
