/// \file
/// brdfplot plot: figures from their descriptions.

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text_files.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "config/quick_figure.hpp"
#include "picture.hpp"
#include "render.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

namespace brdfplot::cli {

namespace {

struct PlotFlags {
  std::vector<std::string> files;
  config::QuickFigure quick;
  std::vector<std::string> quantities, vs;
  std::string save;
  std::string width;
  std::string output;
  std::string cache;

  /// Whether materials are drawn rather than figures.
  bool is_quick() const { return !quantities.empty() || !quick.inline_materials.empty(); }
};

/// What a quantity's list and `--vs` are made of.
config::QuickFigure quick_figure(const PlotFlags& flags) {
  config::QuickFigure quick = flags.quick;
  quick.materials = flags.files;
  for (const std::string& list : flags.quantities)
    for (std::size_t begin = 0; begin <= list.size();) {
      const std::size_t end = std::min(list.find(',', begin), list.size());
      quick.quantities.push_back(list.substr(begin, end - begin));
      begin = end + 1;
    }
  for (const std::string& other : flags.vs)
    (other.find('=') == std::string::npos ? quick.materials : quick.vs).push_back(other);
  return quick;
}

double page_width(const std::string& text) {
  if (text.empty()) return 0;
  const std::string number = text.ends_with("mm") ? text.substr(0, text.size() - 2) : text;
  const auto value = parse_number(number);
  if (!value || !(*value >= 10) || *value > 2000)
    throw InputError("--width", "found \"" + echo(text) + "\"; accepted: 10mm to 2000mm");
  return *value;
}

std::vector<plot::FigureDescription> load(const std::vector<std::string>& files) {
  std::vector<plot::FigureDescription> figures;
  std::map<std::string, std::string> file_of;
  for (const auto& file : files) {
    figures.push_back(config::load_figure(file).figure);
    const auto [other, is_new] = file_of.try_emplace(figures.back().id, file);
    if (!is_new)
      throw InputError(file + ": /id",
                       "found \"" + echo(other->first) + "\", which is the id of " + other->second + " too");
  }
  return figures;
}

/// Renders figures, with the simulations that they need.
std::vector<RenderedFigure> render_all(const std::vector<plot::FigureDescription>& figures, const PlotFlags& flags,
                                       const Settings& settings) {
  std::vector<RenderedFigure> rendered(figures.size());
  simulation::Store store(flags.cache);
  std::vector<Task> tasks;
  std::vector<const plot::FigureDescription*> described;
  for (const auto& figure : figures) described.push_back(&figure);
  append_simulations(described, settings, store, tasks);
  const int threads = std::max(1, settings.threads / static_cast<int>(figures.size()));
  for (std::size_t k = 0; k < figures.size(); ++k)
    tasks.push_back({figures[k].id, [&, k] { rendered[k] = render(figures[k], store, threads); }});
  run_tasks(tasks, settings);
  return rendered;
}

/// One file, as its ending says; `-`: SVG to stdout.
NamedText picture(const PlotFlags& flags, PictureFormat format, RenderedFigure rendered) {
  const double width = page_width(flags.width);
  if (format == PictureFormat::csv) return {flags.output, std::move(rendered.csv)};
  if (format == PictureFormat::svg) return {flags.output, std::move(rendered.svg)};
  return {flags.output, converted(rendered.svg, format, width, flags.output)};
}

/// Nothing is written before everything is computed: a figure that fails leaves the folder as it was.
int run(const PlotFlags& flags, const Settings& settings) {
  require_argument(!flags.files.empty() || flags.is_quick(), "plot", "FIGURE.json, or MATERIAL.json with -q");
  require_argument(!flags.output.empty() || !flags.save.empty(), "plot", "-o DIR, or -o FILE.svg|png|pdf|csv");
  if (!flags.is_quick() && !flags.save.empty()) throw InputError("--save", "it goes with -q QUANTITY");
  std::vector<plot::FigureDescription> figures;
  std::vector<NamedText> files;
  if (flags.is_quick()) {
    const config::QuickFigure quick = quick_figure(flags);
    figures.push_back(config::load_quick_figure(quick));
    const std::string folder = std::filesystem::path(flags.save).parent_path().string();
    if (!flags.save.empty()) files.push_back({flags.save, config::quick_figure(quick, folder)});
  } else {
    figures = load(flags.files);
  }
  const auto format = flags.output == "-" ? PictureFormat::svg : format_of(flags.output);
  if (!flags.width.empty() && format != PictureFormat::png && format != PictureFormat::pdf)
    throw InputError("--width", "it goes with -o FILE.png or FILE.pdf");
  if (format && figures.size() > 1)
    throw InputError("-o", "found a file for " + std::to_string(figures.size()) + " figures; accepted: a folder");
  if (!flags.output.empty() && !format) create_folders(flags.output);
  if (!flags.output.empty()) {
    std::vector<RenderedFigure> rendered = render_all(figures, flags, settings);
    if (format) files.push_back(picture(flags, *format, std::move(rendered[0])));
    for (std::size_t k = 0; k < figures.size() && !format; ++k) {
      files.push_back({in_folder(flags.output, figures[k].id + ".svg"), std::move(rendered[k].svg)});
      files.push_back({in_folder(flags.output, figures[k].id + ".csv"), std::move(rendered[k].csv)});
    }
  }
  if (flags.output == "-") {
    print(files.back().text);
    files.pop_back();
  }
  write_text_files(files);
  return 0;
}

} // namespace

Command add_plot(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<PlotFlags>();
  CLI::App* command = app.add_subcommand("plot", "Figures as SVG, CSV, PNG and PDF");
  command->add_option("files", flags->files, "Figures; with -q, materials")->type_name("FILE.json");
  command
      ->add_option("-q,--quantity", flags->quantities,
                   "Draws this of materials, several as panels: see brdfplot list quantities")
      ->type_name("Q[,Q...]");
  command->add_option("-m,--material", flags->quick.inline_materials, "With -q: a material as JSON text")
      ->type_name("JSON");
  command->add_option("--at", flags->quick.at, "With -q: what is fixed, as theta_o=60deg")->type_name("NAME=VALUE");
  command->add_option("--over", flags->quick.over, "With -q: a series for each value, as alpha=0.1,0.3")
      ->type_name("NAME=VALUE,...");
  command
      ->add_option("--vs", flags->vs,
                   "With -q: a material beside the first, or the same with masking=v_cavity and the like")
      ->type_name("FILE|NAME=TYPE");
  command->add_option("--x", flags->quick.x, "With -q: what is swept, as alpha=0.05:1; default: by the quantity")
      ->type_name("NAME=FROM:TO");
  command
      ->add_option("--channel", flags->quick.channel, "With -q: of what is coloured; default: each, where they differ")
      ->type_name("r|g|b|luminance");
  command->add_option("--save", flags->save, "With -q: writes the figure file that it stands for")->type_name("FILE");
  command->add_option("--width", flags->width, "Of a PNG or PDF on paper, as 84mm")->type_name("MM");
  command
      ->add_option(
          "-o,--output", flags->output,
          "Folder of ID.svg and ID.csv, made where it is missing; or a file of one figure, FILE.svg, .png, .pdf "
          "or .csv; -: SVG to stdout")
      ->type_name("DIR|FILE");
  add_cache_flag(*command, flags->cache);
  command->footer(footer("brdfplot plot configs/figures/fig15_shear.json -o build/figures"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
