#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/text_files.hpp"
#include "base/threads/interrupt.hpp"
#include "config/load.hpp"
#include "config/model_json.hpp"
#include "config/shapes.hpp"
#include "models/registry.hpp"
#include "stream/rows.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

namespace brdfplot::config {

namespace {

/// Distributions with any of their parameters: a table adds the roughness, and building tells what is missing then.
std::vector<ModelSpec> without_requirements() {
  auto specs = specs_of<Distribution>();
  for (auto& spec : specs) {
    spec.alternatives.clear();
    for (auto& parameter : spec.parameters)
      if (!parameter.fallback) parameter.fallback = 0.0;
  }
  return specs;
}

ShapePtr table_shape() {
  return named("table", [] {
    return object(
        {{"id", file_stem(), true, "name of its files"},
         {"title", text(), true, "above the table"},
         {"caption", text(), true, "what it shows"},
         {"maskings", array(choice(names_of(specs_of<Masking>())), 1, 100), true, "masking functions, in order"},
         {"distributions",
          array(either({choice(names_of(specs_of<Distribution>())),
                        named("row_distribution", [] { return model(without_requirements()); })}),
                1, 100),
          true, "distributions, by name or with their parameters"},
         {"alpha", array(number({.min = 0, .open_min = true}), 1, 100), true,
          "roughnesses tried of each distribution that has none of its own"},
         {"theta_o", array(angle(), 1, 1000), true, "angles of the viewer tried"},
         {"tolerance", number({.min = 1e-12, .max = 1e-1}), false, "a residual up to this counts as zero"}});
  });
}

ShapePtr data_shape() {
  return named("data", [] {
    return object(
        {{"id", file_stem(), true, "name of its files"},
         {"title", text(), true, "above the table"},
         {"caption", text(), true, "what it shows"},
         {"file", text(), true, "path of a CSV with a header line, relative to this file"},
         {"columns", array(text(), 1, 100), false, "those of the CSV that are shown, in order; default: all"}});
  });
}

/// Of a table of properties: a masking function, a distribution and a roughness each.
constexpr std::size_t most_materials = 20000;

/// Tells what building would: a distribution that a roughness alone does not define, one out of its bounds.
void check_models(const PropertyTableDescription& table, const JsonFile& file, const std::string& pointer) {
  const std::size_t count = table.maskings.size() * table.distributions.size() * table.alpha.size();
  if (count > most_materials)
    file.fail(pointer, std::to_string(count) + " materials; accepted: at most " + std::to_string(most_materials) +
                           " in one table");
  const auto rows = families(table);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::size_t columns = table.distributions.size();
    const std::string distribution = "/distributions/" + std::to_string(row % columns);
    const std::string masking = "/maskings/" + std::to_string(row / columns);
    for (const auto& member : rows[row].members) {
      throw_if_interrupted();
      try {
        build(member);
      } catch (const MaterialError& error) {
        if (error.pointer().starts_with("/masking")) file.fail(pointer + masking, error.reason());
        file.fail(pointer + distribution,
                  "\"" + table.distributions[row % columns].type + "\" with alpha alone: " + error.reason());
      }
    }
  }
}

ModelChoice read_distribution(const Json& value) {
  return value.is_string() ? ModelChoice{value.get<std::string>(), {}} : to_choice<Distribution>(value);
}

PropertyTableDescription read_table(const Json& value) {
  PropertyTableDescription table;
  table.id = value["id"].get<std::string>();
  table.title = value["title"].get<std::string>();
  table.caption = value["caption"].get<std::string>();
  table.maskings = value["maskings"].get<std::vector<std::string>>();
  for (const Json& distribution : value["distributions"])
    table.distributions.push_back(read_distribution(distribution));
  table.alpha = value["alpha"].get<std::vector<double>>();
  for (const Json& theta : value["theta_o"]) table.theta_o.push_back(to_number(theta));
  table.tolerance = value.value("tolerance", table.tolerance);
  return table;
}

/// The fields of every row of a CSV. \throws InputError where a row has another number of them than the first.
std::vector<std::vector<std::string>> read_cells(const std::string& name, const std::string& csv) {
  constexpr std::size_t most_cells = 100000; // a page shows them all
  std::size_t cell_count = 0;
  std::vector<std::vector<std::string>> cells;
  for (FieldScanner scanner(csv); !scanner.at_end();) {
    const std::string where = name + ":" + std::to_string(scanner.lines() + 1);
    std::vector<std::string> row;
    do row.push_back(unquoted(scanner.next()));
    while (!scanner.row_ended());
    throw_if_interrupted();
    cell_count += row.size();
    if (cell_count > most_cells)
      throw InputError(where, "more than " + std::to_string(most_cells) + " fields so far; accepted: at most as many");
    if (!cells.empty() && row.size() != cells.front().size())
      throw InputError(where, "found " + std::to_string(row.size()) + " fields, the header has " +
                                  std::to_string(cells.front().size()));
    cells.push_back(std::move(row));
  }
  if (cells.size() < 2) throw InputError(name, "accepted: a CSV with a header line and rows");
  return cells;
}

/// The columns of a table that are named.
std::vector<std::vector<std::string>> chosen(const std::vector<std::vector<std::string>>& cells, const Json& names,
                                             const JsonFile& file, const std::string& pointer) {
  std::vector<std::vector<std::string>> out(cells.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto name = names[k].get<std::string>();
    const auto found = std::ranges::find(cells.front(), name);
    if (found == cells.front().end())
      file.fail(pointer + "/" + std::to_string(k), unknown_name("column", name, cells.front()));
    const auto column = static_cast<std::size_t>(found - cells.front().begin());
    for (std::size_t row = 0; row < cells.size(); ++row) out[row].push_back(cells[row][column]);
  }
  return out;
}

DataTable read_data(const JsonFile& file, const std::string& pointer, const Json& value) {
  const std::filesystem::path here = file.file(pointer + "/file");
  const std::string name = (here.parent_path() / value["file"].get<std::string>()).string();
  DataTable table{value["id"].get<std::string>(),
                  value["title"].get<std::string>(),
                  value["caption"].get<std::string>(),
                  read_text_file(name, std::size_t{16} << 20),
                  {}};
  table.cells = read_cells(name, table.csv);
  if (value.contains("columns")) table.cells = chosen(table.cells, value["columns"], file, pointer + "/columns");
  return table;
}

ShapePtr reference_shape() {
  return named("publication", [] {
    return object_with_alternatives(
        {{"cited", array(text(), 1, 20), true, "how captions name it, as \"Walter et al. 2007\"; the first is a link"},
         {"text", text(), true, "author, title, where and when"},
         {"doi", text(), false, "its DOI, as 10.1145/2897824.2925943"},
         {"url", text(), false, "where it is, if it has no DOI"}},
        {{"doi"}, {"url"}});
  });
}

plot::Reference read_reference(const Json& value) {
  return {value["cited"].get<std::vector<std::string>>(), value["text"].get<std::string>(),
          value.contains("doi") ? "https://doi.org/" + value["doi"].get<std::string>()
                                : value["url"].get<std::string>()};
}

} // namespace

ShapePtr report_shape() {
  const ShapePtr entry = object_with_alternatives({{"section", text(), true, "heading under which it stands"},
                                                   {"number", text(), false, "the paper's own, as \"Fig. 11\""},
                                                   {"figure", text(), false, "path of a figure, relative to this file"},
                                                   {"table", table_shape(), false, "a table of properties"},
                                                   {"data", data_shape(), false, "a table that a CSV file has"}},
                                                  {{"figure"}, {"table"}, {"data"}});
  return object(
      {{"title", text(), true, "of the page"},
       {"introduction", text(), false, "paragraphs, separated by an empty line"},
       {"paper", text(), false, "how captions name the paper whose numbers entries have; others get R1, R2, …"},
       {"references", array(reference_shape(), 1, 200), false, "publications that captions name"},
       {"licence", text(), false, "under which the page may be used"},
       {"entries", array(entry, 1, 1000), true, "figures and tables, in order"}},
      true);
}

ReportFile load_report(const std::string& path) {
  const JsonFile file(path);
  expect_kind(file, "report");
  static const ShapePtr shape = report_shape();
  file.check(*shape);
  const Json& root = file.root();
  ReportFile report{std::filesystem::path(path).stem().string(),
                    root["title"].get<std::string>(),
                    root.value("introduction", ""),
                    {},
                    root.value("paper", ""),
                    {},
                    root.value("licence", "")};
  if (root.contains("references"))
    for (const Json& reference : root["references"]) report.references.push_back(read_reference(reference));
  std::set<std::string> ids;
  for (std::size_t k = 0; k < root["entries"].size(); ++k) {
    const Json& entry = root["entries"][k];
    const std::string pointer = "/entries/" + std::to_string(k);
    ReportEntry out{entry["section"].get<std::string>(), PropertyTableDescription{}, "", entry.value("number", "")};
    std::string id;
    if (entry.contains("figure")) {
      const std::filesystem::path here = file.file(pointer + "/figure");
      const auto name = (here.parent_path() / entry["figure"].get<std::string>()).string();
      FigureFile figure = load_figure(name);
      id = figure.figure.id;
      out.what = std::move(figure.figure);
      out.json = std::move(figure.json);
    } else if (entry.contains("data")) {
      DataTable table = read_data(file, pointer + "/data", entry["data"]);
      id = table.id;
      out.what = std::move(table);
      out.json = entry["data"].dump(2) + "\n";
    } else {
      PropertyTableDescription table = read_table(entry["table"]);
      check_models(table, file, pointer + "/table");
      id = table.id;
      out.what = std::move(table);
      out.json = entry["table"].dump(2) + "\n";
    }
    if (!ids.insert(id).second) file.fail(pointer, "the id \"" + echo(id) + "\" stands twice in this report");
    report.entries.push_back(std::move(out));
  }
  return report;
}

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> all = {"material", "figure", "report", "scene", "advice"};
  return all;
}

std::string schema(const std::string& kind) {
  ShapePtr shape;
  if (kind == "material")
    shape = material_shape(true);
  else if (kind == "figure")
    shape = figure_shape();
  else if (kind == "report")
    shape = report_shape();
  else if (kind == "scene")
    shape = scene_shape();
  else if (kind == "advice")
    shape = advice_shape();
  else
    throw InputError("schema", unknown_name("kind", kind, kinds()));
  return json_schema(*shape, kind).dump(2) + "\n";
}

std::string validate(const std::string& argument) {
  if (is_material_text(argument)) return material_of_argument(argument), "material";
  const std::string kind = kind_of_file(JsonFile(argument));
  if (kind == "figure") return load_figure(argument), kind;
  if (kind == "report") return load_report(argument), kind;
  if (kind == "scene") return load_scene(argument), kind;
  if (kind == "advice") return load_advice(argument), kind;
  return load_material(argument), kind;
}

std::string report_record(const ReportFile& report, const std::string& version, const std::vector<EntryRecord>& entries,
                          double seconds) {
  Json list = Json::array();
  for (const auto& entry : entries) {
    Json one = {{"id", entry.id}, {"kind", entry.kind}, {"files", entry.files}, {"seconds", entry.seconds}};
    Json rows = Json::array();
    for (const auto& row : entry.rows) rows.push_back(property_row(row));
    if (!rows.empty()) one["rows"] = std::move(rows);
    list.push_back(std::move(one));
  }
  return Json{{"report", report.id},
              {"title", report.title},
              {"version", version},
              {"seconds", seconds},
              {"entries", list}}
             .dump(2) +
         "\n";
}

} // namespace brdfplot::config
