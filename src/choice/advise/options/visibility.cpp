#include "choice/advise/options/visibility.hpp"

#include "microfacet/microsurface.hpp"

#include <algorithm>

namespace brdfplot::choice {

namespace {

struct Form {
  std::string label, masking, shadowing;
};

std::string shadowing_of(const TermDescription& term) {
  return term.shadowing ? term.shadowing->type : "height_correlated";
}

std::vector<Form> forms_for(const std::string& distribution) {
  std::vector<Form> forms = {{"height-correlated", "smith", "height_correlated"}};
  if (distribution == "beckmann")
    forms.push_back({"height-correlated, Walter's rational Lambda", "smith_rational", "height_correlated"});
  if (distribution == "sheen") forms.push_back({"height-correlated, published fit", "sheen_fit", "height_correlated"});
  if (distribution == "sheen" || distribution == "velvet")
    forms.push_back({"NL + NV - NL NV (Neubelt)", "smith", "neubelt"});
  if (distribution != "sheen" && distribution != "velvet") {
    forms.push_back({"separable", distribution == "beckmann" ? "smith_rational" : "smith", "separable"});
    forms.push_back({"Karis's Lambda, height-correlated (Hammon)", "smith", "hammon"});
  }
  forms.push_back({"constant", "implicit", "separable"});
  return forms;
}

bool replace(Draft& draft, const std::string& name, const Form& form) {
  TermDescription* term = draft.find(name);
  if (term == nullptr) return false;
  const std::vector<Form> possible = forms_for(term->distribution.type);
  if (std::ranges::find(possible, form.label, &Form::label) == possible.end()) return false;
  term->masking = {.type = form.masking};
  term->shadowing = ModelChoice{.type = form.shadowing};
  return true;
}

} // namespace

std::vector<Option> CheaperVisibility::of(const MaterialDescription& material) {
  static const std::vector<std::string> smiths = {"smith", "smith_rational", "sheen_fit", "student_t_fit"};
  std::vector<Option> out;
  for (const TermDescription& term : material.terms) {
    if (term.type != "mirror" || std::ranges::find(smiths, term.masking.type) == smiths.end()) continue;
    const std::string name = term.name, part = "V of " + name;
    Option option{part, {}};
    for (const Form& form : forms_for(term.distribution.type))
      if (form.masking != term.masking.type || form.shadowing != shadowing_of(term))
        option.steps.push_back(
            {part + ": " + form.label, [name, form](Draft& draft) { return replace(draft, name, form); }});
    out.push_back(option);
  }
  return out;
}

} // namespace brdfplot::choice
