/// \file
/// brdfplot check: the properties of Table 3 and more, of materials or of everything built in.

#include "analysis/masking_mistake.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "built_in.hpp"
#include "check_sampling.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "render.hpp"
#include "report_tables.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace brdfplot::cli {

namespace {

struct CheckFlags {
  std::vector<std::string> materials;
  bool json = false, csv = false, markdown = false;
  std::string output = "-";
  std::string tolerance;
  SamplingCheckFlags sampling;
};

/// What is measured, and what came out.
struct Checked {
  std::string file; ///< none of a table's row
  PropertyFamily family;
  std::vector<std::string> claims;
  PropertySearch search;
  PropertyRow row;
};

std::vector<Checked> materials_of(const CheckFlags& flags) {
  std::vector<Checked> all;
  for (const auto& file : flags.materials) {
    const auto material = config::material_of_argument(file);
    for (auto& family : families_of(material)) {
      const bool whole = family.material == material.name;
      all.push_back({config::name_of_argument(file),
                     std::move(family),
                     whole ? material.claims : std::vector<std::string>{},
                     {},
                     {}});
    }
  }
  return all;
}

/// The rows of the tables in the built-in report.
std::vector<Checked> built_in() {
  std::vector<Checked> all;
  for (const auto& entry : config::load_report(built_in_config("reports/heitz2014.json")).entries)
    if (const auto* table = std::get_if<PropertyTableDescription>(&entry.what))
      for (auto& family : families(*table)) all.push_back({"", std::move(family), {}, table->search(), {}});
  return all;
}

void measure_all(std::vector<Checked>& all, const Settings& settings) {
  // One task a property, since a material alone has to keep all threads busy.
  std::vector<Task> tasks;
  for (Checked& one : all) {
    const MaterialDescription& first = one.family.members.at(0);
    one.row = row_of(one.family);
    if (!one.file.empty()) one.row.mistake = masking_mistake(first);
    for (const auto& info : properties()) {
      Residual& to = one.row.residuals[info.property];
      tasks.push_back({first.name + ", " + info.name, [&one, &to, property = info.property] {
                         to = measure(property, one.family.members, one.search);
                       }});
    }
  }
  run_tasks(tasks, settings);
}

/// Text in the colour of a verdict.
class Paint {
public:
  explicit Paint(bool coloured) : coloured_(coloured) {}
  std::string operator()(Verdict verdict, const std::string& text) const {
    const char* code = verdict == Verdict::holds     ? "32"
                       : verdict == Verdict::fails   ? "31"
                       : verdict == Verdict::unknown ? "33"
                                                     : "2";
    return coloured_ ? "\x1b[" + std::string(code) + "m" + text + "\x1b[0m" : text;
  }

private:
  bool coloured_;
};

/// Filled with blanks to `columns` characters.
std::string padded(const std::string& text, std::size_t columns) {
  const auto used = static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
  return text + std::string(used < columns ? columns - used : 0, ' ');
}

std::string in_degrees(double angle) {
  return format_number(std::round(angle * (180 / std::acos(-1.0)) * 1e4) / 1e4) + "deg";
}

/// Where a residual is, unless it holds: then that is chance.
std::string place(const Residual& residual, const PropertySearch& search) {
  if (residual.verdict == Verdict::unknown)
    return "cannot be told at a tolerance of " + format_number(search.tolerance) + ": the error is " +
           (std::isfinite(residual.error) ? short_number(residual.error) : format_number(residual.error)) +
           " at theta_o = " + in_degrees(residual.theta_o);
  if (residual.verdict == Verdict::fails)
    return "at theta_o = " + in_degrees(residual.theta_o) + ", phi_o = " + in_degrees(residual.phi_o);
  return residual.verdict == Verdict::not_applicable ? "does not apply: " + residual.reason : "";
}

/// A material by itself: a line a property.
std::string block(const Checked& one, const Paint& paint) {
  std::string out =
      one.row.material + ": " + one.row.label + (one.row.masking.empty() ? "" : ", masking " + one.row.masking) + "\n";
  for (const auto& info : properties()) {
    const Residual& residual = one.row.residuals.at(info.property);
    const bool applies = residual.verdict != Verdict::not_applicable;
    const std::string number = applies ? short_number(residual.max_residual) : "";
    std::string line = padded(info.title, 20) + padded(number, 9) + place(residual, one.search);
    line.erase(line.find_last_not_of(' ') + 1);
    out += "  " + paint(residual.verdict, std::string(mark(residual.verdict))) + " " + line + "\n";
  }
  const Verdict verdict = one.row.physically_based();
  out += "  " + paint(verdict, std::string(mark(verdict))) + " physically based (Eqs. 14, 18, 36, 37)\n";
  if (!one.row.mistake.empty()) out += "  ! " + one.row.mistake + "\n";
  for (const auto& claim : one.claims)
    out +=
        "  " + paint(one.row.verdict(claim), std::string(mark(one.row.verdict(claim)))) + " claimed: " + claim + "\n";
  return out;
}

/// Heads of the columns of the wide table, short.
std::string head(Property property) {
  switch (property) {
  case Property::eq14: return "Eq. 14";
  case Property::eq18: return "Eq. 18";
  case Property::eq36: return "Eq. 36";
  case Property::eq37: return "Eq. 37";
  case Property::normalized: return "D";
  case Property::eq9_22: return "9.22";
  case Property::g1_range: return "G1";
  case Property::g1_decreasing: return "G1'";
  case Property::g1_normal: return "G1(0)";
  case Property::stretch_invariance: return "stretch";
  case Property::reciprocity: return "recipr";
  case Property::energy: return "energy";
  }
  return {};
}

std::size_t width_of(Property property) { return property <= Property::eq37 ? 9 : head(property).size() + 1; }

/// Many rows: residuals of the four equations, verdicts of the rest.
std::string wide_table(const std::vector<Checked>& all, const Paint& paint) {
  std::size_t masking = 8, label = 13;
  for (const auto& one : all) {
    masking = std::max(masking, one.row.masking.size() + 1);
    label = std::max(label, one.row.label.size() + 1);
  }
  std::string out = padded("masking", masking) + padded("distribution", label);
  for (const auto& info : properties()) out += padded(head(info.property), width_of(info.property));
  out += "physical\n";
  for (const auto& one : all) {
    out += padded(one.row.masking, masking) + padded(one.row.label, label);
    for (const auto& info : properties()) {
      const Residual& residual = one.row.residuals.at(info.property);
      const bool equation = info.property <= Property::eq37;
      const std::string text =
          std::string(mark(residual.verdict)) + (equation ? " " + short_number(residual.max_residual) : "");
      out += paint(residual.verdict, padded(text, width_of(info.property)));
    }
    const Verdict verdict = one.row.physically_based();
    out += paint(verdict, std::string(mark(verdict))) + "\n";
  }
  return out + "\n✓ holds, ✗ fails, ? cannot be told, - does not apply. D: normalized; G1: in [0, 1]; G1': decreasing; "
               "G1(0): 1 at the normal.\n";
}

std::string formatted(const CheckFlags& flags, const std::vector<Checked>& all, const Settings& settings) {
  std::vector<PropertyRow> rows;
  std::vector<config::CheckRecord> records;
  for (const auto& one : all) {
    rows.push_back(one.row);
    records.push_back({one.file, one.row, one.claims});
  }
  const double tolerance = all.at(0).search.tolerance;
  if (flags.json) return config::check_record(records, tolerance);
  if (flags.csv) return table_csv(rows);
  if (flags.markdown)
    return table_markdown(
        "Properties, measured",
        "The largest residual of each; what is up to " + format_number(tolerance) + " counts as zero.", rows);
  const Paint paint(flags.output == "-" && colours_stdout(settings));
  if (flags.materials.empty()) return wide_table(all, paint);
  std::string out;
  for (const auto& one : all) out += (out.empty() ? "" : "\n") + block(one, paint);
  return out;
}

/// Says what is claimed and not so; 1 when a claim fails, 4 when one cannot be told.
int judge_claims(const std::vector<Checked>& all, const Settings& settings) {
  bool fails = false, unknown = false;
  for (const auto& one : all)
    for (std::size_t k = 0; k < one.claims.size(); ++k) {
      const Verdict verdict = one.row.verdict(one.claims[k]);
      if (verdict == Verdict::holds) continue;
      const bool told = verdict != Verdict::unknown;
      (told ? fails : unknown) = true;
      print_error(settings, one.file + ": /claims/" + std::to_string(k) + ": \"" + one.claims[k] + "\" " +
                                (verdict == Verdict::fails ? "does not hold"
                                 : told                    ? "does not apply"
                                        : "cannot be told at a tolerance of " + format_number(one.search.tolerance)));
    }
  return fails ? 1 : unknown ? 4 : 0;
}

/// Says what came out as no number: 4 where something did, else 0.
int judge_numbers(const std::vector<Checked>& all, const Settings& settings) {
  int code = 0;
  for (const auto& one : all)
    for (const auto& what : untold(one.row)) {
      code = 4;
      print_error(settings, (one.file.empty() ? one.row.label + ", " + one.row.masking : one.file) + ": " + what);
    }
  return code;
}

int check_samplers_of(const CheckFlags& flags, const Settings& settings) {
  if (flags.json || flags.markdown || !flags.tolerance.empty())
    throw InputError("check", "found --json, --markdown or --tolerance with --sampling; accepted: --csv, or a table");
  return check_samplers(flags.materials, flags.sampling, flags.csv, flags.output, settings);
}

int run(const CheckFlags& flags, const Settings& settings) {
  if (static_cast<int>(flags.json) + static_cast<int>(flags.csv) + static_cast<int>(flags.markdown) > 1)
    throw InputError("check", "accepted: one of --json, --csv, --markdown");
  if (flags.sampling.asked) return check_samplers_of(flags, settings);
  if (!flags.sampling.strategy.empty() || !flags.sampling.samples.empty() || !flags.sampling.seed.empty() ||
      !flags.sampling.density.empty())
    throw InputError("check", "found --strategy, -n, --seed or --pdf without --sampling; accepted: with it");
  std::vector<Checked> all = flags.materials.empty() ? built_in() : materials_of(flags);
  for (auto& one : all) one.search.tolerance = read_tolerance(flags.tolerance, one.search.tolerance);
  measure_all(all, settings);
  write_output(flags.output, formatted(flags, all, settings));
  const int claims = judge_claims(all, settings), numbers = judge_numbers(all, settings);
  return claims != 0 ? claims : numbers;
}

} // namespace

Command add_check(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<CheckFlags>();
  CLI::App* command = app.add_subcommand(
      "check", "Whether masking functions conserve area and energy: Table 3 of Heitz 2014, and more");
  set_usage(*command, {"[MATERIAL.json]..."});
  add_materials(*command, flags->materials, "The materials; default: all that is built in");
  command->add_flag("--json", flags->json, "Everything that was measured, as JSON");
  command->add_flag("--csv", flags->csv, "A row for each material");
  command->add_flag("--markdown", flags->markdown, "A table for a page");
  command->add_option("-o,--output", flags->output, "Where to write; default: stdout")->type_name("FILE|-");
  command->add_option("--tolerance", flags->tolerance, "A residual up to this counts as zero; default: 1e-6")
      ->type_name("NUMBER");
  command->add_flag(
      "--sampling", flags->sampling.asked,
      "Instead: whether what brdfplot sample draws follows its density, whether that integrates to 1, and "
      "whether the mean weight is the albedo");
  command->add_option("--strategy", flags->sampling.strategy, "Of --sampling (brdfplot sample --help)")
      ->type_name("NAME");
  command->add_option("-n,--samples", flags->sampling.samples, "Of --sampling, from each viewer; default: 20000")
      ->type_name("N");
  command->add_option("--seed", flags->sampling.seed, "Of --sampling; default: 1")->type_name("S");
  command
      ->add_option(
          "--pdf", flags->sampling.density,
          "Of --sampling: a density to test instead of the strategy's own, such as a renderer has for this material, "
          "a formula of that, pdf, of the "
          "directions x_o ... z_i and x_h y_h z_h, of theta_o phi_o theta_i phi_i theta_h phi_h, and of o_h")
      ->type_name("FORMULA");
  command->footer("Exit code 1 when a property that a material claims (\"claims\": [\"physically_based\"]) fails,\n"
                  "or a sampler does;\n"
                  "4 when it cannot be told.\n\n" +
                  footer("brdfplot check configs/materials/rough_gold.json"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
