/// \file
/// brdfplot report: every figure and table of a manifest, as a folder with a page.

#include "base/errors.hpp"
#include "base/text_files.hpp"
#include "built_in.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "draw/html/page.hpp"
#include "render.hpp"
#include "report_tables.hpp"
#include "version.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <numeric>
#include <set>
#include <utility>

namespace brdfplot::cli {

namespace {

namespace fs = std::filesystem;

struct ReportFlags {
  std::string manifest;
  std::string output;
  std::string cache;
};

/// One entry, computed.
struct Computed {
  RenderedFigure figure;
  std::vector<PropertyRow> rows;
  std::vector<double> row_seconds;
};

/// What has to be computed for `entry`: a figure at once, into `figure_tasks`, a table of properties row by row, into
/// `row_tasks`,
/// of a table of data nothing.
void append_tasks(const config::ReportEntry& entry, simulation::Store& store, Computed& computed,
                  std::vector<Task>& figure_tasks, std::vector<Task>& row_tasks) {
  if (const auto* figure = std::get_if<plot::FigureDescription>(&entry.what)) {
    figure_tasks.push_back({figure->id, [figure, &store, &computed] { computed.figure = render(*figure, store); }});
    return;
  }
  if (std::holds_alternative<config::DataTable>(entry.what)) return;
  const auto& table = std::get<PropertyTableDescription>(entry.what);
  auto rows = families(table);
  computed.rows.resize(rows.size());
  computed.row_seconds.resize(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::string name = table.id + ", " + rows[r].members.at(0).name;
    row_tasks.push_back({name, [name, &table, &computed, family = std::move(rows[r]), r] {
                           computed.row_seconds[r] =
                               timed([&] { computed.rows[r] = measure(family, table3_properties(), table.search()); });
                           for (const auto& what : untold(computed.rows[r])) throw AccuracyError(name, what);
                         }});
  }
}

/// The folder's content, gathered entry by entry.
struct Content {
  std::vector<NamedText> files; ///< relative to the folder
  std::vector<plot::PageEntry> page;
  std::vector<config::EntryRecord> records;

  void add(const config::ReportEntry& entry, const plot::FigureDescription& figure, const Computed& computed) {
    const auto& [svg, csv, caption, seconds] = computed.figure;
    const std::string stem = "figures/" + figure.id;
    page.push_back(
        {figure.id, entry.section, figure.title, caption, svg, csv, entry.json, {}, seconds, stem, entry.number, {}});
    records.push_back({figure.id, "figure", {stem + ".svg", stem + ".csv", stem + ".json"}, seconds, {}});
    files.push_back({stem + ".svg", svg});
    files.push_back({stem + ".csv", csv});
    files.push_back({stem + ".json", entry.json});
  }

  void add(const config::ReportEntry& entry, const PropertyTableDescription& table, const Computed& computed) {
    const std::string csv = table_csv(computed.rows);
    const double seconds = std::accumulate(computed.row_seconds.begin(), computed.row_seconds.end(), 0.0);
    const std::string stem = "tables/" + table.id;
    const auto summary = by_masking(computed.rows);
    auto cells = table_cells(computed.rows), all_rows = plot::Cells();
    if (!summary.empty()) all_rows = std::exchange(cells, table_cells(summary));
    page.push_back({table.id, entry.section, table.title, table.caption, "", csv, entry.json, std::move(cells), seconds,
                    stem, entry.number, std::move(all_rows)});
    records.push_back({table.id, "table", {stem + ".csv", stem + ".json", stem + ".md"}, seconds, computed.rows});
    files.push_back({stem + ".csv", csv});
    files.push_back({stem + ".json", entry.json});
    files.push_back({stem + ".md", table_markdown(table.title, table.caption, computed.rows)});
  }

  void add(const config::ReportEntry& entry, const config::DataTable& table, const Computed&) {
    const std::string stem = "tables/" + table.id;
    page.push_back({table.id,
                    entry.section,
                    table.title,
                    table.caption,
                    "",
                    table.csv,
                    entry.json,
                    table.cells,
                    0,
                    stem,
                    entry.number,
                    {}});
    records.push_back({table.id, "table", {stem + ".csv", stem + ".json", stem + ".md"}, 0, {}});
    files.push_back({stem + ".csv", table.csv});
    files.push_back({stem + ".json", entry.json});
    files.push_back({stem + ".md", table_markdown(table.title, table.caption, table.cells)});
  }
};

/// What an earlier report left in figures/ and tables/. Files of other kinds are not this program's.
std::vector<fs::path> stale_files(const std::string& folder, const std::vector<NamedText>& files) {
  std::set<fs::path> current;
  for (const auto& file : files) current.insert(file.path);
  std::vector<fs::path> stale;
  std::error_code error;
  for (const char* part : {"figures", "tables"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(folder) / part, error)) {
      const auto extension = entry.path().extension();
      const bool ours = extension == ".svg" || extension == ".csv" || extension == ".json" || extension == ".md";
      if (ours && entry.is_regular_file(error) && !current.contains(entry.path())) stale.push_back(entry.path());
    }
  }
  return stale;
}

/// The old report stays until the new one is on the disk, whole; the record of what there is comes last.
void write(const std::string& folder, std::vector<NamedText> files) {
  create_folders(in_folder(folder, "figures"));
  create_folders(in_folder(folder, "tables"));
  for (auto& file : files) file.path = in_folder(folder, file.path);
  const auto stale = stale_files(folder, files);
  write_text_files(files);
  for (const auto& path : stale) remove_file(path.string());
}

int run(const ReportFlags& flags, const Settings& settings) {
  require_argument(!flags.output.empty(), "report", "-o DIR");
  const auto report =
      config::load_report(flags.manifest.empty() ? built_in_config("reports/heitz2014.json") : flags.manifest);
  create_folders(flags.output);
  std::vector<Computed> computed(report.entries.size());
  const double seconds = timed([&] {
    simulation::Store store(flags.cache);
    std::vector<Task> tasks;
    std::vector<const plot::FigureDescription*> figures;
    for (const auto& entry : report.entries)
      if (const auto* figure = std::get_if<plot::FigureDescription>(&entry.what)) figures.push_back(figure);
    append_simulations(figures, settings, store, tasks);
    // Rows of tables are short and come last, so that all threads end together.
    std::vector<Task> rows;
    for (std::size_t k = 0; k < computed.size(); ++k) append_tasks(report.entries[k], store, computed[k], tasks, rows);
    std::ranges::move(rows, std::back_inserter(tasks));
    run_tasks(tasks, settings);
  });
  Content content;
  for (std::size_t k = 0; k < computed.size(); ++k)
    std::visit([&](const auto& what) { content.add(report.entries[k], what, computed[k]); }, report.entries[k].what);
  const std::string made_by = "Made by brdfplot " + std::string(version) + " from " + report.id + ".json in " +
                              std::to_string(std::lround(std::ceil(seconds))) + " s.";
  content.files.push_back(
      {"index.html", plot::to_html({report.title, report.introduction, made_by, std::move(content.page), report.paper,
                                    report.references, report.licence})});
  content.files.push_back(
      {"report.json", config::report_record(report, std::string(version), content.records, seconds)});
  write(flags.output, std::move(content.files));
  return 0;
}

} // namespace

Command add_report(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<ReportFlags>();
  CLI::App* command = app.add_subcommand("report", "Every figure and table of a manifest, as a folder with a page");
  set_usage(*command, {"[MANIFEST.json] -o DIR"});
  command->add_option("manifest", flags->manifest, "The report; default: the built-in one of Heitz 2014")
      ->type_name("MANIFEST.json");
  command->add_option("-o,--output", flags->output, "Folder of index.html, figures/, tables/ and report.json")
      ->type_name("DIR");
  add_cache_flag(*command, flags->cache);
  command->footer(footer("brdfplot report configs/reports/heitz2014.json -o build/report"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
