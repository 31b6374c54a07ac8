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
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

namespace brdfplot::cli {

namespace {

struct PlotFlags {
  std::vector<std::string> files;
  config::QuickFigure quick;
  std::vector<std::string> quantities, vs;
  std::string save;
  std::string width, font_size;
  bool no_title = false;
  std::string output;
  std::string cache;

  /// Whether materials are drawn rather than figures.
  bool is_quick() const { return !quantities.empty() || std::ranges::any_of(files, config::is_material_text); }
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
    (config::is_material_text(other) || other.find('=') == std::string::npos ? quick.materials : quick.vs)
        .push_back(other);
  return quick;
}

/// Millimetres of the columns and pages that journals have.
constexpr std::array<std::pair<std::string_view, double>, 8> journal_widths = {{{"acm", 84.7},
                                                                                {"acm-page", 177.9},
                                                                                {"elsevier", 90},
                                                                                {"elsevier-page", 190},
                                                                                {"ieee", 88.9},
                                                                                {"ieee-page", 181.9},
                                                                                {"nature", 89},
                                                                                {"nature-page", 183}}};

/// A length with or without its unit, within bounds. \throws InputError
double bounded_length(const std::string& flag, const std::string& text, const std::string& unit, double shortest,
                      double longest, const std::string& accepted) {
  const std::string number = text.ends_with(unit) ? text.substr(0, text.size() - unit.size()) : text;
  const auto value = parse_number(number);
  if (!value || !(*value >= shortest) || *value > longest)
    throw InputError(flag, "found \"" + echo(text) + "\"; accepted: " + accepted);
  return *value;
}

double page_width(const std::string& text) {
  std::string accepted = "10mm to 2000mm, or a column or page of";
  for (const auto& [name, millimetres] : journal_widths) {
    if (text == name) return millimetres;
    accepted += (accepted.ends_with("of") ? " " : ", ") + std::string(name);
  }
  return bounded_length("--width", text, "mm", 10, 2000, accepted);
}

plot::Layout layout_of(const PlotFlags& flags) {
  plot::Layout layout;
  layout.title = !flags.no_title;
  if (!flags.width.empty()) layout.width_mm = page_width(flags.width);
  if (!flags.font_size.empty()) {
    if (flags.width.empty()) throw InputError("--font-size", "it goes with --width");
    layout.font_pt = bounded_length("--font-size", flags.font_size, "pt", 3, 40, "3pt to 40pt");
  }
  return layout;
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
  const plot::Layout layout = layout_of(flags);
  for (std::size_t k = 0; k < figures.size(); ++k)
    tasks.push_back({figures[k].id, [&, k] { rendered[k] = render(figures[k], store, threads, layout); }});
  run_tasks(tasks, settings);
  return rendered;
}

/// One file, as its ending says; `-`: SVG to stdout.
NamedText picture(const PlotFlags& flags, PictureFormat format, RenderedFigure rendered) {
  if (format == PictureFormat::csv) return {flags.output, std::move(rendered.csv)};
  if (format == PictureFormat::svg) return {flags.output, std::move(rendered.svg)};
  return {flags.output, converted(rendered.svg, format, layout_of(flags).width_mm, flags.output)};
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
  const bool laid_out = !flags.width.empty() || !flags.font_size.empty() || flags.no_title;
  if (laid_out && (flags.output.empty() || format == PictureFormat::csv))
    throw InputError("--width, --font-size, --no-title",
                     "they go with a drawing: -o FILE.svg, .png or .pdf, or a folder");
  (void)layout_of(flags); // its mistakes are told before anything is computed
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
  set_usage(*command, {"FIGURE.json... -o DIR|FILE", "MATERIAL.json... -q Q[,Q...] -o DIR|FILE"});
  add_materials(*command, flags->files, "Figures; with -q, materials")->type_name("FILE.json|JSON");
  command
      ->add_option("-q,--quantity", flags->quantities,
                   "Draws this of materials, several as panels: see brdfplot list quantities")
      ->type_name("Q[,Q...]");
  command->add_option("--at", flags->quick.at, "With -q: what is fixed, as theta_o=60deg")->type_name("NAME=VALUE");
  command->add_option("--over", flags->quick.over, "With -q: a series for each value, as alpha=0.1,0.3")
      ->type_name("NAME=VALUE,...");
  command
      ->add_option("--vs", flags->vs,
                   "With -q: a material beside the first, or the same with masking=v_cavity and the like")
      ->type_name("FILE|JSON|NAME=TYPE");
  command->add_option("--x", flags->quick.x, "With -q: what is swept, as alpha=0.05:1; default: by the quantity")
      ->type_name("NAME=FROM:TO");
  command
      ->add_option("--channel", flags->quick.channel, "With -q: of what is coloured; default: each, where they differ")
      ->type_name("r|g|b|luminance|rgb");
  command->add_option("--save", flags->save, "With -q: writes the figure file that it stands for")->type_name("FILE");
  command
      ->add_option("--width", flags->width,
                   "On paper, as 84mm, or acm, elsevier, ieee, nature for a column, acm-page and so on for a page: the "
                   "figure is laid out for it, so that text keeps its size")
      ->type_name("MM|JOURNAL");
  command->add_option("--font-size", flags->font_size, "With --width: of the numbers at axes; default: 8pt")
      ->type_name("PT");
  command->add_flag("--no-title", flags->no_title, "Leaves the title to a caption");
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
