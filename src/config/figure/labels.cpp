#include "config/figure/labels.hpp"

#include "base/number.hpp"
#include "draw/text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::config {

namespace {

bool is_angle(const std::string& variable) { return variable.starts_with("theta_") || variable.starts_with("phi_"); }

/// Degrees without what the way to radians and back leaves behind.
std::string degrees_text(double radians) {
  return format_number(std::round(radians * 180 / std::numbers::pi * 1e9) / 1e9) + "°";
}

std::string text_of(const plot::Setting& setting) {
  struct Visitor {
    const std::string& variable;
    std::string operator()(double x) const { return is_angle(variable) ? degrees_text(x) : format_number(x); }
    std::string operator()(const std::string& text) const { return plot::literal_label(text); }
    std::string operator()(const plot::Tie& tie) const {
      std::string out = (tie.sign < 0 ? "−" : "") + symbol(tie.to);
      if (tie.offset > 0) out += " + " + degrees_text(tie.offset);
      if (tie.offset < 0) out += " − " + degrees_text(-tie.offset);
      return out;
    }
  };
  const std::string value = std::visit(Visitor{setting.variable}, setting.value);
  const bool word = std::holds_alternative<std::string>(setting.value);
  return word ? value : symbol(setting.variable) + " = " + value;
}

void add(Traits& traits, const std::string& name, const std::string& text) {
  const auto found = std::ranges::find(traits, name, &Trait::name);
  if (found == traits.end())
    traits.push_back({name, text});
  else if ((" / " + found->text + " / ").find(" / " + text + " / ") == std::string::npos)
    found->text += " / " + text;
}

/// The text of a trait; none where a series has not got it.
std::string text_in(const Traits& traits, const std::string& name) {
  const auto found = std::ranges::find(traits, name, &Trait::name);
  return found == traits.end() ? "" : found->text;
}

} // namespace

std::string symbol(const std::string& variable) {
  static const std::vector<std::pair<std::string, std::string>> letters = {
      {"theta", "θ"}, {"phi", "φ"}, {"alpha", "α"}, {"gamma", "γ"}, {"eta", "η"}};
  const auto underscore = variable.find('_');
  const std::string base = variable.substr(0, underscore);
  const auto found = std::ranges::find(letters, base, &std::pair<std::string, std::string>::first);
  if (found == letters.end()) return plot::literal_label(variable);
  if (underscore == std::string::npos) return found->second;
  const std::string below = variable.substr(underscore + 1);
  return found->second + "_" + (below.size() == 1 ? below : "{" + below + "}");
}

void add_traits(Traits& traits, const plot::Term& term, const Scope& scope) {
  add(traits, "material", plot::literal_label(scope.material_name));
  add(traits, "quantity", plot::literal_label(term.quantity));
  for (auto setting = term.at.begin(); setting != term.at.end(); ++setting) {
    const auto again = std::find_if(setting + 1, term.at.end(),
                                    [&](const plot::Setting& later) { return later.variable == setting->variable; });
    if (again == term.at.end()) add(traits, setting->variable, text_of(*setting));
  }
  add(traits, "simulate", term.simulate ? "simulated" : "computed");
}

Trait operation_trait(plot::Expression::Operation operation) {
  using Operation = plot::Expression::Operation;
  return {"operation", operation == Operation::ratio        ? "ratio"
                       : operation == Operation::difference ? "difference"
                       : operation == Operation::absolute   ? "absolute value"
                                                            : ""};
}

std::vector<std::string> labels_of(const std::vector<Traits>& series, const std::string& without) {
  std::vector<std::string> names;
  for (const Traits& traits : series)
    for (const Trait& trait : traits)
      if (trait.name != without && std::ranges::find(names, trait.name) == names.end()) names.push_back(trait.name);
  std::erase_if(names, [&](const std::string& name) {
    return std::ranges::all_of(series,
                               [&](const Traits& one) { return text_in(one, name) == text_in(series[0], name); });
  });
  std::vector<std::string> labels;
  for (const Traits& traits : series) {
    std::string& label = labels.emplace_back();
    for (const std::string& name : names) {
      const std::string text = text_in(traits, name);
      if (!text.empty()) label += (label.empty() ? "" : ", ") + text;
    }
  }
  return labels;
}

} // namespace brdfplot::config
