#include "choice/advise/options/diffuse.hpp"

#include <algorithm>

namespace brdfplot::choice {

namespace {

bool make_lambert(Draft& draft, const std::string& name) {
  TermDescription* term = draft.find(name);
  if (term == nullptr) return false;
  const auto& map = term->values.map();
  const auto albedo = map.find(term->type == "complement" ? "color" : "albedo");
  Values values;
  values.set("albedo", albedo != map.end() ? albedo->second : Value(1.0));
  TermDescription flat;
  flat.name = term->name;
  flat.type = "lambert";
  flat.weight = term->weight;
  flat.layers = term->layers;
  flat.values = values;
  *term = flat;
  draft.set_free(name, "albedo");
  return true;
}

bool make_fujii(Draft& draft, const std::string& name) {
  TermDescription* term = draft.find(name);
  if (term == nullptr) return false;
  term->type = "fujii_oren_nayar";
  draft.set_free(name, "albedo");
  return true;
}

bool make_qualitative(Draft& draft, const std::string& name) {
  TermDescription* term = draft.find(name);
  if (term == nullptr) return false;
  term->values.set("form", std::string("qualitative"));
  draft.set_free(name, "albedo");
  return true;
}

} // namespace

std::vector<Option> FlatterDiffuse::of(const MaterialDescription& material) {
  static const std::vector<std::string> rough = {
      "eon",           "fujii_oren_nayar", "oren_nayar",      "disney_diffuse",
      "facet_diffuse", "hammon_diffuse",   "fresnel_lambert", "shirley",
      "complement"};
  std::vector<Option> out;
  for (const TermDescription& term : material.terms) {
    if (std::ranges::find(rough, term.type) == rough.end()) continue;
    const std::string name = term.name, was = " (was " + term.type + ")";
    Option option{"diffuse " + name, {}};
    if (term.type == "eon")
      option.steps.push_back({name + ": Fujii's Oren-Nayar" + was, [name](Draft& d) { return make_fujii(d, name); }});
    const bool qualitative = term.values.has("form") && term.values.text("form") == "qualitative";
    if (term.type == "oren_nayar" && !qualitative)
      option.steps.push_back(
          {name + ": Oren and Nayar's qualitative fit", [name](Draft& d) { return make_qualitative(d, name); }});
    option.steps.push_back({name + ": Lambert" + was, [name](Draft& d) { return make_lambert(d, name); }});
    out.push_back(option);
  }
  return out;
}

} // namespace brdfplot::choice
