/// \file
/// brdfplot list: what there is, from the models' own declarations.

#include "analysis/integrals.hpp"
#include "analysis/properties.hpp"
#include "analysis/weight_moments.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "choice/methods/problems.hpp"
#include "command.hpp"
#include "figure/profile/surface.hpp"
#include "models/registry.hpp"
#include "simulation/scene.hpp"
#include "simulation/surface.hpp"
#include "stream/stream.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

namespace brdfplot::cli {

namespace {

/// Of names, of what is said of them, and of the gap behind the longest of a group of names.
constexpr std::size_t name_column = 2;
constexpr std::size_t text_column = 6;
constexpr std::size_t gap = 2;

std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// `text` behind `lead`, in lines of the output's width that all start at `column`; words stay whole.
std::string wrapped(const std::string& lead, const std::string& text, std::size_t column) {
  const std::size_t width = output_width();
  std::string out = lead + std::string(column - width_of(lead), ' ');
  std::size_t used = column;
  bool at_start = true;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!at_start && used + 1 + width_of(word) > width) {
      out += "\n" + std::string(column, ' ');
      used = column;
      at_start = true;
    }
    out += (at_start ? "" : " ") + word;
    used += width_of(word) + (at_start ? 0 : 1);
    at_start = false;
  }
  out.erase(out.find_last_not_of(' ') + 1); // where there is no text
  return out + "\n";
}

/// Lines of a name and a text each, the texts below each other.
struct Lines {
  std::vector<std::pair<std::string, std::string>> lines;

  std::string aligned(std::size_t column) const {
    std::size_t longest = 0;
    for (const auto& [name, text] : lines) longest = std::max(longest, width_of(name));
    std::string out;
    for (const auto& [name, text] : lines)
      out += wrapped(std::string(column, ' ') + name, text, column + longest + gap);
    return out;
  }
};

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string out;
  for (const auto& word : words) out += (out.empty() ? "" : separator) + word;
  return out;
}

std::string accepted(const ParameterSpec& parameter) {
  switch (parameter.kind) {
  case ParameterKind::number: return parameter.bounds.describe();
  case ParameterKind::number_or_rgb: return parameter.bounds.describe() + ", or [r, g, b] of such";
  case ParameterKind::vec2: return "[x, y], each " + parameter.bounds.describe();
  case ParameterKind::vec3: return "[x, y, z], each " + parameter.bounds.describe();
  case ParameterKind::boolean: return "true | false";
  case ParameterKind::choice: return joined(parameter.choices, " | ");
  case ParameterKind::text: return "a text";
  case ParameterKind::components:
    return "[{\"weight\": " + parameter.bounds.describe() + ", \"distribution\": any but a mixture}, ...]";
  case ParameterKind::formula: return "a formula of " + joined(parameter.choices, ", ");
  }
  return {};
}

template <std::size_t N>
std::string text_of(const std::array<double, N>& numbers) {
  std::vector<std::string> texts;
  for (const double number : numbers) texts.push_back(format_number(number));
  return "[" + joined(texts, ", ") + "]";
}
std::string text_of(double number) { return format_number(number); }
std::string text_of(bool flag) { return flag ? "true" : "false"; }
std::string text_of(const std::string& text) { return text; }
std::string text_of(const WeightedChoices& components) { return std::to_string(components.size()) + " components"; }

/// "default 1", "required", or nothing for what is one of several alternatives.
std::string need(const ModelSpec& spec, const ParameterSpec& parameter) {
  if (parameter.fallback) return "default " + std::visit([](const auto& v) { return text_of(v); }, *parameter.fallback);
  const bool alternative = std::ranges::any_of(
      spec.alternatives, [&](const auto& group) { return std::ranges::find(group, parameter.key) != group.end(); });
  return alternative ? "" : "required";
}

std::string describe(const ModelSpec& spec) {
  std::string out = std::string(name_column, ' ') + spec.type + "\n" + wrapped("", spec.doc, text_column);
  if (!spec.source.empty()) out += wrapped("", "[" + spec.source + "]", text_column);
  Lines parameters;
  for (const auto& parameter : spec.parameters) {
    const std::string needed = need(spec, parameter);
    parameters.lines.emplace_back(parameter.key,
                                  parameter.doc + "; " + accepted(parameter) + (needed.empty() ? "" : "; " + needed));
  }
  out += parameters.aligned(text_column);
  std::vector<std::string> groups;
  for (const auto& group : spec.alternatives) groups.push_back(joined(group, " with "));
  if (!groups.empty()) out += wrapped("", "Needs either " + joined(groups, ", or ") + ".", text_column);
  return out;
}

/// A model or a quantity of a section.
struct Item {
  std::string name, doc;
  std::string whole; ///< with parameters, domains and sources; empty: the line of name and doc is all
};

template <class List>
std::vector<Item> items_of() {
  std::vector<Item> items;
  for (const auto& spec : specs_of<List>()) items.push_back({spec.type, spec.doc, describe(spec)});
  return items;
}

std::string describe_term(const TermSpec& term) {
  std::string out = describe(term.spec);
  if (term.of_another) out += wrapped("", "Takes \"of\": the name of a term beside it, or a term.", text_column);
  if (term.of_layers) out += wrapped("", "Takes \"coat\": a term, and \"base\": a list of terms.", text_column);
  if (term.has_distribution && !term.has_surface)
    out += wrapped("", "Takes \"distribution\", \"fresnel\".", text_column);
  if (term.has_surface)
    out += wrapped("",
                   std::string("Takes \"distribution\", \"masking\", \"shadowing\"") +
                       (term.has_fresnel ? ", \"fresnel\"." : "."),
                   text_column);
  return out;
}

std::vector<Item> terms() {
  std::vector<Item> items;
  for (const TermSpec& term : term_specs()) items.push_back({term.spec.type, term.spec.doc, describe_term(term)});
  return items;
}

std::string needs_of(const QuantityInfo& info) {
  std::vector<std::string> needs;
  if (info.needs.o) needs.emplace_back("omega_o");
  if (info.needs.i) needs.emplace_back("omega_i");
  if (info.needs.m) needs.emplace_back("omega_m");
  return joined(needs, ", ");
}

std::vector<Item> quantity_items() {
  std::vector<Item> items;
  const auto add = [&](const std::string& name, const std::string& doc, const std::string& needs, bool coloured) {
    items.push_back(
        {name, doc + "; needs " + needs + (coloured ? "; per channel where a colour of the material is" : ""), ""});
  };
  for (const auto& info : quantities()) add(info.name, info.doc, needs_of(info), info.coloured());
  for (const auto& info : integrals()) add(info.name, info.doc, "omega_o", info.coloured);
  const DensityInfo density;
  add(density.name, density.doc, needs_of(info_of(Quantity::brdf)), false);
  for (const auto& info : sampled_quantities())
    if (info.name != density.name) add(info.name, info.doc + "; in figures, at a \"strategy\"", "omega_o", true);
  return items;
}

std::vector<Item> measures() {
  std::vector<Item> items;
  for (const auto& spec : simulation::measure_specs()) {
    const std::string keys = spec.keys.empty() ? "" : "; takes " + joined(spec.keys, ", ");
    items.push_back({spec.type, spec.doc + keys + "; [" + spec.source + "]", ""});
  }
  return items;
}

std::vector<Item> property_items() {
  std::vector<Item> items;
  for (const PropertyInfo& info : properties())
    items.push_back({info.name, info.doc + (info.source.empty() ? "" : "; [" + info.source + "]"), ""});
  return items;
}

/// Without what is said of them: with their methods, some of which are fitted, they take a second to make.
std::vector<Item> problem_items() {
  std::vector<Item> items;
  for (const auto& name : choice::problem_names()) items.push_back({name, "", ""});
  return items;
}

struct Section {
  std::string name, title;
  std::vector<Item> (*items)();

  /// A line each.
  std::string brief() const {
    Lines lines;
    for (const Item& item : items()) lines.lines.emplace_back(item.name, item.doc);
    return title + "\n" + lines.aligned(name_column);
  }
  std::string whole() const {
    std::string out = title + "\n";
    for (const Item& item : items()) {
      if (item.whole.empty()) return brief();
      out += item.whole;
    }
    return out;
  }
};

const std::vector<Section>& sections() {
  static const std::vector<Section> all = {
      {"distributions", "Distributions of normals (\"distribution\")", items_of<Distribution>},
      {"masking", "Masking functions (\"masking\")", items_of<Masking>},
      {"shadowing", "Masking with shadowing (\"shadowing\")", items_of<Shadowing>},
      {"fresnel", "Fresnel terms (\"fresnel\")", items_of<Fresnel>},
      {"terms", "Terms of a BRDF (\"terms\" of a material), each with \"name\" and \"weight\"", terms},
      {"quantities", "Quantities (brdfplot eval -q)", quantity_items},
      {"properties", "Properties (brdfplot check, \"claims\" of a material): what is measured, 0 where it holds",
       property_items},
      {"surfaces", "Surfaces (\"surface\" of a scene)", items_of<simulation::Surface>},
      {"measures", "Measures of a scene (\"measures\")", measures},
      {"problems", "Quantities whose methods are compared (brdfplot pareto, brdfplot stress)", problem_items},
      {"profiles", "Surfaces in profile (\"surface\" of a profile)", items_of<plot::ProfileSurface>},
  };
  return all;
}

/// All sections in short, a section, or everything of one name, each in the section that it is in.
std::string listed(const std::string& wanted) {
  std::string out;
  std::vector<std::string> names;
  for (const Section& section : sections()) {
    names.push_back(section.name);
    if (wanted.empty()) out += (out.empty() ? "" : "\n") + section.brief();
    if (wanted == section.name) return section.whole();
  }
  if (wanted.empty()) return out + "\nbrdfplot list NAME tells of its parameters, domains and source.\n";
  for (const Section& section : sections())
    for (const Item& item : section.items()) {
      names.push_back(item.name);
      if (item.name != wanted) continue;
      out += (out.empty() ? "" : "\n") + section.title + "\n";
      const std::string doc = item.doc.empty() ? choice::make_problem(item.name)->doc : item.doc;
      out += item.whole.empty()
                 ? wrapped(std::string(name_column, ' ') + item.name, doc, name_column + item.name.size() + gap)
                 : item.whole;
    }
  if (out.empty()) throw InputError("list", unknown_name("section or name", wanted, names));
  return out;
}

} // namespace

Command add_list(CLI::App& app) {
  const auto wanted = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("list", "Models and quantities, with their parameters and sources");
  command
      ->add_option("name", *wanted,
                   "A model or a quantity, or all of distributions, masking, shadowing, fresnel, terms, quantities, "
                   "properties, surfaces, measures, problems or profiles; default: everything in short")
      ->type_name("NAME");
  command->footer(footer("brdfplot list ggx"));
  return {command, [wanted] {
            print(listed(*wanted));
            return 0;
          }};
}

} // namespace brdfplot::cli
