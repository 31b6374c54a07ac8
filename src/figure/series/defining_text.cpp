#include "figure/series/defining_text.hpp"

#include "base/number.hpp"

namespace brdfplot::plot {

namespace {

std::string text_of(const ModelChoice& choice);

std::string text_of(const Value& value) {
  struct Visitor {
    std::string operator()(double x) const { return format_number(x); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const Vec2& v) const { return format_number(v[0]) + ";" + format_number(v[1]); }
    std::string operator()(const Rgb& v) const {
      return format_number(v[0]) + ";" + format_number(v[1]) + ";" + format_number(v[2]);
    }
    std::string operator()(const WeightedChoices& components) const {
      std::string out;
      for (const auto& component : components)
        out += format_number(component.weight) + "*" + text_of(component.model) + ";";
      return out;
    }
  };
  return std::visit(Visitor{}, value);
}

struct SettingText {
  std::string operator()(double x) const { return format_number(x); }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const Tie& tie) const {
    return format_number(tie.sign) + "*" + tie.to + "+" + format_number(tie.offset);
  }
};

std::string text_of(const ModelChoice& choice) {
  std::string out = choice.type + "{";
  for (const auto& [key, value] : choice.values.map()) out += key + "=" + text_of(value) + ",";
  return out + "}";
}

std::string text_of_masking(const MicrosurfaceDescription& surface) {
  return " " + text_of(surface.masking) + " " + (surface.shadowing ? text_of(*surface.shadowing) : "");
}

} // namespace

std::string defining_text(const MaterialDescription& material) {
  std::string out;
  for (const TermDescription& term : material.terms) {
    // What a simulation does not know, which has one mirror, is left out: old measurements stay good.
    const bool plain = term.type == "mirror" && term.name.empty() && text_of(term.weight) == "1";
    if (!plain)
      out += term.name + " " + term.type + " " + text_of(term.weight) + " " + text_of({"", term.values}) + " ";
    out += text_of(term.distribution) + " " + text_of(term.fresnel);
    if (!term.of_name.empty()) out += " of \"" + term.of_name + "\"";
    for (const TermDescription& other : term.of)
      out += " of (" + defining_text(MaterialDescription(other)) + text_of_masking(other) + ")";
    for (const LayerDescription& layer : term.layers)
      out += " under " + layer.coat + " " + text_of(layer.weight) + text_of({"", layer.values});
  }
  return out;
}

std::string defining_text(const Direction& direction) {
  return format_number(direction.x) + " " + format_number(direction.y) + " " + format_number(direction.z);
}

std::string defining_text(const Term& term, const std::vector<std::string>& swept) {
  std::string out = term.quantity + " " + defining_text(term.material);
  for (const TermDescription& one : term.material.terms) out += text_of_masking(one);
  out += "\nat";
  for (const Setting& setting : term.at) {
    out += " " + setting.variable + "=" + std::visit(SettingText{}, setting.value);
  }
  out += "\nover";
  for (const auto& variable : swept) out += " " + variable;
  return out;
}

} // namespace brdfplot::plot
