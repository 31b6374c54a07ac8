/// \file
/// Files of brdfplot: JSON to typed values. Nothing outside this folder sees JSON.
///
/// Every function throws InputError for bad content, with WHERE as the contract has it (`FILE:LINE:COLUMN` for syntax,
/// `FILE: /json/pointer` for values, in the file in which the value stands when it came through a `$ref`), and
/// FileError when a file cannot be read. `-` is not a file name here.
#pragma once

#include "analysis/properties.hpp"
#include "brdf/material.hpp"
#include "choice/advise/advise.hpp"
#include "choice/compare/compare.hpp"
#include "draw/html/page.hpp"
#include "figure/description.hpp"
#include "simulation/scene.hpp"

#include <string>
#include <variant>
#include <vector>

namespace brdfplot::config {

/// A material that is complete and can be built: name (the file's stem when it gives none).
MaterialDescription load_material(const std::string& path);

/// The same of a text that is no file: errors say `name`, and references are relative to the working directory.
MaterialDescription material_from_text(const std::string& json, const std::string& name);

/// Whether what a command line names as a material is the material's own JSON, "{...}", rather than a file.
bool is_material_text(const std::string& argument);

/// The material that a command line names: a file, or its own JSON, whose errors say "-m".
MaterialDescription material_of_argument(const std::string& argument);

/// What errors call that: the file, or "-m".
std::string name_of_argument(const std::string& argument);

/// A figure with the text of its file; where that refers to others, with what they say in their place.
struct FigureFile {
  plot::FigureDescription figure;
  std::string json;
};

FigureFile load_figure(const std::string& path);
FigureFile figure_from_text(const std::string& json, const std::string& name);

/// A table that a CSV file has: what was measured elsewhere, and is shown as it is.
struct DataTable {
  std::string id;
  std::string title;
  std::string caption;
  std::string csv;
  std::vector<std::vector<std::string>> cells; ///< what is shown: header row first, all of one length
};

/// One entry of a report: a figure or a table, with its JSON.
struct ReportEntry {
  std::string section;
  std::variant<plot::FigureDescription, PropertyTableDescription, DataTable> what;
  std::string json;
  std::string number; ///< the paper's own; empty: the report's
};

struct ReportFile {
  std::string id; ///< stem of the manifest's name
  std::string title;
  std::string introduction;
  std::vector<ReportEntry> entries;
  std::string paper; ///< how captions name it; empty: there is none
  std::vector<plot::Reference> references;
  std::string licence;
};

ReportFile load_report(const std::string& path);

/// A surface and what is measured on it, checked; name: the file's stem when it gives none. The path of a height map is
/// relative to the file that names it.
simulation::SceneDescription load_scene(const std::string& path);

/// A scene for which the least model is looked for.
choice::AdviceScene load_advice(const std::string& path);

/// A material as a file that load_material() reads, indented, ending in a newline. Paths of files that it names become
/// absolute.
std::string material_text(const MaterialDescription& material);

/// What `compare` found, as JSON; with the materials that were fitted, if they were.
std::string comparison_record(const std::string& a, const std::vector<choice::MaterialDifference>& all,
                              const std::vector<MaterialDescription>& refitted);

/// What `advise --json` prints.
std::string advice_record(const choice::AdviceScene& scene, const std::vector<choice::MaterialAdvice>& all);

/// The kinds of file that have a schema: material, figure, report, scene, advice.
const std::vector<std::string>& kinds();

/// The JSON Schema (draft 2020-12) of a kind, indented, ending in a newline. \throws InputError for an unknown kind.
std::string schema(const std::string& kind);

/// Reads a file, or a material that is JSON itself (material_of_argument()), as what it is (its kind is told by its
/// keys), without computing; returns the kind.
std::string validate(const std::string& argument);

/// What report.json says of one entry.
struct EntryRecord {
  std::string id;
  std::string kind; ///< figure or table
  std::vector<std::string> files;
  double seconds = 0;
  std::vector<PropertyRow> rows; ///< tables: the residuals
};

/// A material's row with what it claims.
struct CheckRecord {
  std::string file; ///< none of the rows of a table
  PropertyRow row;
  std::vector<std::string> claims;
};

/// What `check --json` prints.
std::string check_record(const std::vector<CheckRecord>& checked, double tolerance);

/// The text of report.json.
std::string report_record(const ReportFile& report, const std::string& version, const std::vector<EntryRecord>& entries,
                          double seconds);

} // namespace brdfplot::config
