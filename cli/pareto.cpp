/// \file
/// brdfplot pareto: what every method of a quantity costs, and how far it is off.

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/text_files.hpp"
#include "choice/methods/of_material.hpp"
#include "choice/methods/problems.hpp"
#include "choice/pareto/tables.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "config/records/pareto_json.hpp"
#include "draw/html/page.hpp"
#include "draw/text.hpp"
#include "figure/pareto_figure.hpp"
#include "models/parameters.hpp"
#include "render.hpp"
#include "terminal.hpp"
#include "version.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace brdfplot::cli {

namespace {

struct ParetoFlags {
  std::vector<std::string> quantities;
  bool json = false;
  bool no_times = false;
  std::string output;
};

bool is_material(const std::string& name) {
  return config::is_material_text(name) || name.ends_with(".json") || name.find('/') != std::string::npos;
}

/// The problems of a material; what is wrong with it is said of its file.
std::vector<choice::Problem> problems_of_file(const std::string& file) {
  try {
    return choice::problems_of(config::material_of_argument(file));
  } catch (const MaterialError& error) {
    throw InputError(config::name_of_argument(file) + ": " + error.pointer(), error.reason());
  }
}

/// Those that are named, in that order, of the material where there is one, and else of this program; where none is,
/// all of the material, or all.
std::vector<choice::Problem> chosen_problems(const std::vector<std::string>& arguments) {
  std::vector<choice::Problem> all;
  std::vector<std::string> names;
  for (const auto& argument : arguments) {
    if (!is_material(argument)) {
      names.push_back(argument);
      continue;
    }
    if (!all.empty()) throw InputError("pareto", "found a second material, \"" + echo(argument) + "\"; accepted: one");
    all = problems_of_file(argument);
  }
  if (names.empty()) return all.empty() ? choice::problems() : all;
  std::vector<std::string> accepted;
  for (const auto& problem : all) accepted.push_back(problem.name);
  for (auto& name : choice::problem_names()) accepted.push_back(std::move(name));
  std::vector<choice::Problem> chosen;
  for (const auto& name : names) {
    if (std::ranges::find(chosen, name, &choice::Problem::name) != chosen.end()) continue;
    const auto found = std::ranges::find(all, name, &choice::Problem::name);
    auto made = found != all.end() ? std::optional(*found) : choice::make_problem(name);
    if (!made) throw InputError("pareto", unknown_name("quantity", name, accepted));
    chosen.push_back(std::move(*made));
  }
  return chosen;
}

/// Columns of text, the first to the left, all others to the right but the place.
std::string aligned(const std::vector<std::vector<std::string>>& cells) {
  std::vector<std::size_t> widths(cells.at(0).size());
  for (const auto& row : cells)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  std::string out;
  for (const auto& row : cells) {
    std::string line = " ";
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string blanks(widths[k] - row[k].size(), ' ');
      const bool left = k == 0 || cells[0][k] == "where" || cells[0][k] == "front" || cells[0][k] == "timed";
      line += (k == 0 ? " " : "  ") + (left ? row[k] + blanks : blanks + row[k]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  }
  return out;
}

std::string heading(const choice::ProblemResult& result, bool times) {
  const choice::Problem& problem = result.problem;
  return problem.name + ": " + problem.doc + " (" + problem.source + "), " + std::to_string(result.samples) +
         " inputs" + (times ? "; reference: " + result.methods[result.reference].method.name : "") + "\n";
}

/// What was found of methods besides, in a line for all that it is the same of.
std::string notes(const choice::ProblemResult& result) {
  std::vector<std::pair<std::string, std::string>> lines; // note, names
  for (const auto& m : result.methods) {
    if (m.method.note.empty()) continue;
    const auto same = std::ranges::find(lines, m.method.note, &std::pair<std::string, std::string>::first);
    if (same == lines.end())
      lines.emplace_back(m.method.note, m.method.name);
    else
      same->second += ", " + m.method.name;
  }
  std::string out;
  for (const auto& [note, names] : lines) out += "  " + names + ": " + note + "\n";
  return out;
}

/// Who says where its methods fail, and on which inputs.
std::string faults(const choice::Problem& problem) {
  const std::vector<std::string> known = choice::problem_names();
  if (std::ranges::find(known, problem.name) == known.end()) return "";
  return "  faults: brdfplot stress " + problem.name + "\n";
}

/// Where times were measured, if they were.
using Machine = std::optional<choice::MachineRecord>;

std::string fronts(const choice::ProblemResult& result, bool times) {
  std::string out;
  for (const choice::CostKind cost : {choice::CostKind::counted, choice::CostKind::measured})
    for (const choice::ErrorKind error : {choice::ErrorKind::relative, choice::ErrorKind::absolute})
      if (cost == choice::CostKind::counted ? result.has_costs() : times)
        out += "  " + front_line(result, cost, error) + "\n";
  return out;
}

std::string tables(const std::vector<choice::ProblemResult>& results, const Machine& machine) {
  const bool times = machine.has_value();
  std::string out;
  for (const auto& result : results)
    out += heading(result, times) + aligned(pareto_cells(result)) + fronts(result, times) + notes(result) +
           faults(result.problem) + "\n";
  out += choice::pareto_legend(times);
  if (machine) out += "Times: " + machine->text() + "\n";
  return out;
}

/// The cells for a page, where the names of methods are no markup.
std::vector<std::vector<std::string>> page_cells(const choice::ProblemResult& result) {
  auto cells = pareto_cells(result);
  for (auto& row : cells) row[0] = plot::literal_label(row[0]);
  return cells;
}

/// The files of one folder.
std::vector<NamedText> files_of(const std::vector<choice::ProblemResult>& results, const Machine& machine) {
  std::vector<NamedText> files;
  plot::Page page{.title = "Cost against error",
                  .introduction = choice::pareto_legend(machine.has_value()),
                  .footer = "",
                  .entries = {}};
  page.footer =
      "Made by brdfplot " + std::string(version) + " pareto" + (machine ? " on " + machine->text() : "") + ".";
  const auto add_chart = [&](const choice::ProblemResult& result, const plot::Figure& figure) {
    const std::string svg = plot::to_svg(figure);
    files.push_back({figure.id + ".svg", svg});
    page.entries.push_back(
        {figure.id, result.problem.doc, figure.title, figure.description, svg, plot::to_csv(figure), "", {}, 0});
  };
  for (const auto& result : results) {
    if (result.has_costs()) add_chart(result, plot::pareto_figure(result));
    if (machine) add_chart(result, plot::pareto_figure(result, *machine));
    page.entries.push_back({result.problem.name, result.problem.doc, result.problem.doc + ": all methods",
                            result.problem.source, "", choice::pareto_csv({result}), "", page_cells(result), 0});
  }
  files.push_back({"pareto.csv", choice::pareto_csv(results)});
  if (machine) files.push_back({"times.csv", choice::times_csv(results, *machine)});
  files.push_back({"index.html", plot::to_html(page)});
  files.push_back({"pareto.json", config::pareto_record(results, machine, std::string(version))});
  return files;
}

int run(const ParetoFlags& flags, const Settings& settings) {
  std::vector<choice::Problem> problems = chosen_problems(flags.quantities);
  if (!flags.output.empty()) create_folders(flags.output);
  std::vector<choice::ProblemResult> results;
  {
    Progress progress(settings);
    results = choice::pareto(
        std::move(problems), {.threads = settings.threads, .times = !flags.no_times},
        [&](double share, const std::string& what) { progress.set(static_cast<std::size_t>(100 * share), 100, what); });
  }
  const Machine machine = flags.no_times ? Machine() : choice::machine_record();
  if (!flags.output.empty()) {
    std::vector<NamedText> files = files_of(results, machine);
    for (auto& file : files) file.path = in_folder(flags.output, file.path);
    write_text_files(files);
  }
  print(flags.json ? config::pareto_record(results, machine, std::string(version)) : tables(results, machine));
  return 0;
}

} // namespace

Command add_pareto(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<ParetoFlags>();
  CLI::App* command = app.add_subcommand("pareto", "What every method of a quantity costs, and how far it is off");
  set_usage(*command, {"[QUANTITY|MATERIAL.json]..."});
  add_materials(
      *command, flags->quantities,
      "Quantities (brdfplot list problems), and a material whose own they may be; default: all, of the material "
      "where there is one")
      ->type_name("QUANTITY|MATERIAL.json|JSON");
  command
      ->add_option("-o,--output", flags->output,
                   "Folder of QUANTITY_cost.svg, QUANTITY_time.svg, pareto.csv, times.csv, pareto.json, index.html")
      ->type_name("DIR");
  command->add_flag("--json", flags->json, "Everything that was measured, as JSON on stdout");
  command->add_flag("--no-times", flags->no_times, "Counted costs alone: the same bytes on every run");
  command->footer(footer("brdfplot pareto lambda_beckmann"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
