/// \file
/// brdfplot stress: where each method fails.

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "choice/methods/problems.hpp"
#include "choice/stress/findings_text.hpp"
#include "command.hpp"
#include "models/parameters.hpp"
#include "render.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace brdfplot::cli {

namespace {

struct StressFlags {
  std::vector<std::string> names;
  std::vector<std::string> fail_on;
  bool json = false;
  std::string output;
};

/// A problem, or one method of it.
struct Asked {
  choice::Problem problem;
  std::string method; ///< none: all
};

std::vector<std::string> accepted_names(const std::vector<choice::Problem>& all) {
  std::vector<std::string> names;
  for (const auto& problem : all) {
    names.push_back(problem.name);
    for (const auto& method : problem.methods) names.push_back(problem.name + "/" + method.name);
  }
  return names;
}

Asked asked_by(const std::string& name, const std::vector<choice::Problem>& all) {
  const std::string problem = name.substr(0, name.find('/'));
  const std::string method = name.size() > problem.size() ? name.substr(problem.size() + 1) : "";
  const auto found = std::ranges::find(all, problem, &choice::Problem::name);
  if (found != all.end() && (problem.size() == name.size() ||
                             std::ranges::find(found->methods, method, &choice::Method::name) != found->methods.end()))
    return {*found, method};
  std::string what = "found \"" + echo(name) + "\"";
  if (const auto near = nearest(name, accepted_names(all))) what += "; did you mean \"" + *near + "\"?";
  what += " accepted: a MATERIAL.json, or a problem or problem/method:";
  for (const auto& one : all) what += " " + one.name;
  throw InputError("stress", what);
}

std::vector<Asked> what_is_asked(const std::vector<std::string>& names) {
  const auto all = choice::problems();
  std::vector<Asked> asked;
  if (names.empty())
    for (const auto& problem : all) asked.push_back({problem, ""});
  for (const auto& name : names) asked.push_back(asked_by(name, all));
  return asked;
}

void check_kinds(const std::vector<std::string>& kinds) {
  auto accepted = choice::failure_names();
  accepted.emplace_back("any");
  for (const auto& kind : kinds)
    if (std::ranges::find(accepted, kind) == accepted.end())
      throw InputError("--fail-on", unknown_name("kind of failure", kind, accepted));
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

int run(const StressFlags& flags, const Settings& settings) {
  check_kinds(flags.fail_on);
  const std::vector<Asked> asked = what_is_asked(flags.names);
  std::vector<std::vector<choice::MethodReport>> made(asked.size());
  std::vector<Task> tasks;
  for (std::size_t k = 0; k < asked.size(); ++k)
    tasks.push_back({asked[k].problem.name, [&, k] { made[k] = choice::stress(asked[k].problem, asked[k].method); }});
  run_tasks(tasks, settings);
  std::vector<choice::MethodReport> reports;
  for (const auto& some : made) reports.insert(reports.end(), some.begin(), some.end());
  print(choice::findings_table(reports) + summary_of(reports));
  return judge(reports, flags.fail_on);
}

} // namespace

Command add_stress(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<StressFlags>();
  CLI::App* command = app.add_subcommand("stress", "Where methods fail: lost digits, NaN, energy from nothing");
  command
      ->add_option("names", flags->names,
                   "Materials, and problems (d_ggx) or methods of them (d_ggx/printed); default: all problems")
      ->type_name("MATERIAL.json|METHOD");
  command->add_option("--fail-on", flags->fail_on, "Exit code 1 when such a failure is found; may be repeated")
      ->type_name("KIND|any");
  command->footer(footer("brdfplot stress d_ggx --fail-on nan"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
