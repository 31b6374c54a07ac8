#include "figure/series/defining_text.hpp"

#include "base/number.hpp"
#include "models/model_text.hpp"

namespace brdfplot::plot {

namespace {

struct SettingText {
  std::string operator()(double x) const { return format_number(x); }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const Tie& tie) const {
    return format_number(tie.sign) + "*" + tie.to + "+" + format_number(tie.offset);
  }
};

std::string text_of_masking(const MicrosurfaceDescription& surface) {
  return " " + text_of_model(surface.masking) + " " + (surface.shadowing ? text_of_model(*surface.shadowing) : "");
}

} // namespace

std::string defining_text(const MaterialDescription& material) {
  std::string out;
  for (const TermDescription& term : material.terms) {
    // What a simulation does not know, which has one mirror, is left out: old measurements stay good.
    const bool plain = term.type == "mirror" && term.name.empty() && text_of_value(term.weight) == "1";
    if (!plain)
      out +=
          term.name + " " + term.type + " " + text_of_value(term.weight) + " " + text_of_model({"", term.values}) + " ";
    out += text_of_model(term.distribution) + " " + text_of_model(term.fresnel);
    if (!term.of_name.empty()) out += " of \"" + term.of_name + "\"";
    for (const TermDescription& other : term.of)
      out += " of (" + defining_text(MaterialDescription(other)) + text_of_masking(other) + ")";
    for (const LayerDescription& layer : term.layers)
      out += " under " + layer.coat + " " + text_of_value(layer.weight) + text_of_model({"", layer.values});
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
