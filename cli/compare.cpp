/// \file
/// brdfplot compare: how far apart materials are.

#include "choice/compare/compare.hpp"
#include "base/errors.hpp"
#include "base/text_files.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "draw/html/page.hpp"
#include "figure/compare_figures.hpp"
#include "render.hpp"
#include "version.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace brdfplot::cli {

namespace {

struct CompareFlags {
  std::vector<std::string> files;
  std::vector<std::string> refit;
  std::string output;
  bool json = false;
};

/// The materials, of which all but the first may be fitted to it.
struct Compared {
  std::vector<MaterialDescription> materials;
  std::vector<MaterialDescription> refitted; ///< none, or one for each but the first
  std::vector<choice::MaterialDifference> differences;

  std::string text() const {
    std::string out = choice::comparison_text(materials[0].name, differences);
    for (const MaterialDescription& material : refitted) out += "\n" + config::material_text(material);
    return out;
  }
};

/// Figures name materials: names that are equal get a number.
std::vector<MaterialDescription> load_materials(const std::vector<std::string>& files) {
  std::vector<MaterialDescription> materials;
  for (const std::string& file : files) {
    MaterialDescription material = config::material_of_argument(file);
    int count = 1;
    for (const MaterialDescription& other : materials) count += other.name == material.name ? 1 : 0;
    if (count > 1) material.name += " (" + std::to_string(count) + ")";
    materials.push_back(std::move(material));
  }
  return materials;
}

Compared compare_all(const CompareFlags& flags, const Settings& settings) {
  Compared out{load_materials(flags.files), {}, {}};
  out.differences.resize(out.materials.size() - 1);
  if (!flags.refit.empty()) out.refitted.resize(out.materials.size() - 1);
  std::vector<Task> tasks;
  for (std::size_t k = 1; k < out.materials.size(); ++k)
    tasks.push_back({out.materials[k].name, [&, k] {
                       if (!flags.refit.empty()) {
                         MaterialDescription fitted =
                             choice::refitted_to(out.materials[0], out.materials[k], flags.refit, settings.threads);
                         fitted.name = out.materials[k].name + ", refitted";
                         out.materials[k] = out.refitted[k - 1] = std::move(fitted);
                       }
                       out.differences[k - 1] =
                           choice::difference_of(out.materials[0], out.materials[k], {.threads = settings.threads});
                     }});
  run_tasks(tasks, settings);
  return out;
}

void write_files(const Compared& compared, const std::string& folder, const Settings& settings) {
  const std::vector<plot::FigureDescription> figures = plot::compare_figures(compared.materials);
  std::vector<RenderedFigure> rendered(figures.size());
  simulation::Store store("");
  std::vector<Task> tasks;
  for (std::size_t k = 0; k < figures.size(); ++k)
    tasks.push_back({figures[k].id, [&, k] { rendered[k] = render(figures[k], store); }});
  run_tasks(tasks, settings);
  plot::Page page;
  page.title = "Materials compared with " + compared.materials[0].name;
  page.introduction =
      "Differences are over all pairs of directions, with standard errors of the sums; the largest ones are "
      "the largest that a search has found.";
  page.footer = "made by brdfplot " + std::string(version) + " compare";
  for (std::size_t k = 0; k < compared.differences.size(); ++k) {
    std::vector<std::vector<std::string>> table = {{"what", "how far apart"}};
    for (auto& row : choice::comparison_rows(compared.materials[0].name, compared.differences[k]))
      table.push_back(std::move(row));
    page.entries.push_back({"table" + std::to_string(k + 1), "Numbers", compared.differences[k].name, "", "",
                            choice::comparison_csv({compared.differences[k]}), "", std::move(table), 0});
  }
  std::vector<NamedText> files = {
      {in_folder(folder, "compare.csv"), choice::comparison_csv(compared.differences)},
      {in_folder(folder, "compare.json"),
       config::comparison_record(compared.materials[0].name, compared.differences, compared.refitted)}};
  for (std::size_t k = 0; k < figures.size(); ++k) {
    files.push_back({in_folder(folder, figures[k].id + ".svg"), rendered[k].svg});
    files.push_back({in_folder(folder, figures[k].id + ".csv"), rendered[k].csv});
    page.entries.push_back({figures[k].id,
                            "Figures",
                            figures[k].title,
                            rendered[k].caption,
                            rendered[k].svg,
                            rendered[k].csv,
                            "",
                            {},
                            rendered[k].seconds,
                            figures[k].id});
  }
  files.push_back({in_folder(folder, "index.html"), plot::to_html(page)});
  write_text_files(files);
}

int run(const CompareFlags& flags, const Settings& settings) {
  require_argument(flags.files.size() >= 2, "compare", "A.json B.json...");
  if (!flags.output.empty()) create_folders(flags.output);
  const Compared compared = compare_all(flags, settings);
  if (!flags.output.empty()) write_files(compared, flags.output, settings);
  print(flags.json ? config::comparison_record(compared.materials[0].name, compared.differences, compared.refitted)
                   : compared.text());
  return 0;
}

} // namespace

Command add_compare(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<CompareFlags>();
  CLI::App* command =
      app.add_subcommand("compare", "How far apart materials are: over all directions, and as lit spheres");
  set_usage(*command, {"A.json B.json..."});
  add_materials(*command, flags->files, "The first is what the others are held against");
  command
      ->add_option("--refit", flags->refit,
                   "Fits these of the others to the first before: alpha, weight, f0, or a colour of a term; prints the "
                   "materials")
      ->delimiter(',')
      ->type_name("KEY,...");
  command
      ->add_option("-o,--output", flags->output,
                   "Folder of compare.csv, compare.json, lobes, differences and spheres as SVG and CSV, and index.html")
      ->type_name("DIR");
  command->add_flag("--json", flags->json, "The numbers as JSON");
  command->footer(footer("brdfplot compare configs/materials/ggx.json configs/materials/beckmann.json"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
