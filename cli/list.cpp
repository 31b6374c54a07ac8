/// \file
/// brdfplot list: what there is, from the models' own declarations.

#include "analysis/integrals.hpp"
#include "command.hpp"
#include "math/errors.hpp"
#include "math/number.hpp"
#include "microfacet/registry.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <sstream>

namespace brdfplot::cli {

namespace {

constexpr std::size_t name_column = 2;
constexpr std::size_t text_column = 6;

/// `text` in lines of the output's width, all but the first indented; words stay whole.
std::string wrapped(const std::string& text, std::size_t first_column, std::size_t column) {
  const std::size_t width = output_width();
  std::string out(first_column, ' ');
  std::size_t used = first_column;
  bool at_start = true;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const auto length = static_cast<std::size_t>(
        std::ranges::count_if(word, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
    if (!at_start && used + 1 + length > width) {
      out += "\n" + std::string(column, ' ');
      used = column;
      at_start = true;
    }
    out += (at_start ? "" : " ") + word;
    used += length + (at_start ? 0 : 1);
    at_start = false;
  }
  return out + "\n";
}

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
  case ParameterKind::choice: return joined(parameter.choices, " | ");
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
std::string text_of(const std::string& text) { return text; }

/// "default 1", "required", or nothing for what is one of several alternatives.
std::string need(const ModelSpec& spec, const ParameterSpec& parameter) {
  if (parameter.fallback) return "default " + std::visit([](const auto& v) { return text_of(v); }, *parameter.fallback);
  const bool alternative = std::ranges::any_of(
      spec.alternatives, [&](const auto& group) { return std::ranges::find(group, parameter.key) != group.end(); });
  return alternative ? "" : "required";
}

std::string describe(const ModelSpec& spec) {
  std::string out = wrapped(spec.type + ": " + spec.doc, name_column, text_column);
  if (!spec.source.empty()) out += wrapped("[" + spec.source + "]", text_column, text_column);
  for (const auto& parameter : spec.parameters) {
    const std::string needed = need(spec, parameter);
    out += wrapped(parameter.key + ": " + parameter.doc + "; " + accepted(parameter) +
                       (needed.empty() ? "" : "; " + needed),
                   text_column, text_column + 4);
  }
  std::vector<std::string> groups;
  for (const auto& group : spec.alternatives) groups.push_back(joined(group, " with "));
  if (!groups.empty()) out += wrapped("needs either " + joined(groups, ", or "), text_column, text_column + 4);
  return out;
}

template <class List>
std::string describe_list(const std::string& title) {
  std::string out = title + "\n";
  for (const auto& spec : specs_of<List>()) out += describe(spec);
  return out;
}

std::string needs_of(const QuantityInfo& info) {
  std::vector<std::string> needs;
  if (info.needs.o) needs.emplace_back("omega_o");
  if (info.needs.i) needs.emplace_back("omega_i");
  if (info.needs.m) needs.emplace_back("omega_m");
  return joined(needs, ", ");
}

std::string describe_quantities() {
  std::string out = "Quantities (brdfplot eval -q)\n";
  const auto line = [&](const std::string& name, const std::string& doc, const std::string& needs, bool coloured) {
    out += wrapped(name + ": " + doc + "; needs " + needs + (coloured ? "; per channel where the Fresnel term is" : ""),
                   name_column, text_column);
  };
  for (const auto& info : quantities()) line(info.name, info.doc, needs_of(info), info.coloured);
  for (const auto& info : integrals()) line(info.name, info.doc, "omega_o", info.coloured);
  return out;
}

struct Section {
  std::string name;
  std::string (*describe)();
};

const std::vector<Section>& sections() {
  static const std::vector<Section> all = {
      {"distributions", [] { return describe_list<Distribution>("Distributions of normals (\"distribution\")"); }},
      {"masking", [] { return describe_list<Masking>("Masking functions (\"masking\")"); }},
      {"shadowing", [] { return describe_list<Shadowing>("Masking with shadowing (\"shadowing\")"); }},
      {"fresnel", [] { return describe_list<Fresnel>("Fresnel terms (\"fresnel\")"); }},
      {"quantities", describe_quantities},
  };
  return all;
}

int run(const std::string& wanted) {
  std::string out;
  std::vector<std::string> names;
  for (const auto& section : sections()) {
    names.push_back(section.name);
    if (wanted.empty() || wanted == section.name) out += (out.empty() ? "" : "\n") + section.describe();
  }
  if (out.empty()) throw InputError("list", unknown_name("section", wanted, names));
  print(out);
  return 0;
}

} // namespace

Command add_list(CLI::App& app) {
  const auto wanted = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("list", "Models and quantities, with their parameters and sources");
  command->add_option("section", *wanted, "distributions, masking, shadowing, fresnel or quantities; default: all")
      ->type_name("SECTION");
  command->footer(footer("brdfplot list distributions"));
  return {command, [wanted] { return run(*wanted); }};
}

} // namespace brdfplot::cli
