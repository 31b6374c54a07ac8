#include "choice/advise/options/fresnel.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

namespace {

bool coloured(const Fresnel& fresnel) {
  return std::visit([](const auto& f) { return f.coloured(); }, fresnel);
}

double reflectance(const Fresnel& fresnel, double c, std::size_t channel) {
  double f = 0;
  std::visit([&](const auto& one) { one.reflectances(&c, channel, &f, 1); }, fresnel);
  return f;
}

Value as_value(const Rgb& rgb, bool is_rgb) { return is_rgb ? Value(rgb) : Value(rgb[0]); }

Rgb at_normal(const Fresnel& fresnel) {
  return {reflectance(fresnel, 1, 0), reflectance(fresnel, 1, 1), reflectance(fresnel, 1, 2)};
}

ModelChoice schlick(const Fresnel& fresnel) {
  ModelChoice choice{.type = "schlick"};
  choice.values.set("f0", as_value(at_normal(fresnel), coloured(fresnel)));
  return choice;
}

/// With the reflectance of the other at 0 and at 82 degrees.
ModelChoice f82(const Fresnel& fresnel) {
  const Rgb f0 = at_normal(fresnel);
  Rgb factor{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double of_schlick = f0[c] + (1 - f0[c]) * std::pow(6.0 / 7, 5);
    factor[c] = std::clamp(reflectance(fresnel, 1.0 / 7, c) / of_schlick, F82Fresnel::least_f82(f0[c]), 1.0);
  }
  ModelChoice choice{.type = "f82"};
  choice.values.set("f0", as_value(f0, coloured(fresnel)));
  choice.values.set("f82", as_value(factor, coloured(fresnel)));
  return choice;
}

/// Whether another term stands for what the facets of this one reflect again, and asks for their F.
bool is_bounced(const MaterialDescription& material, const std::string& name) {
  return std::ranges::any_of(material.terms, [&](const TermDescription& other) {
    return other.of_name == name && (other.type == "multiple_bounce" || other.type == "turquin");
  });
}

/// Schlick's term with f90 = f0.
ModelChoice constant(const Fresnel& fresnel) {
  ModelChoice choice = schlick(fresnel);
  choice.values.set("f90", choice.values.map().find("f0")->second);
  return choice;
}

/// The Fresnel term is left out, and its value at the normal is part of the weight.
void put_in_weight(TermDescription& term, const Fresnel& fresnel) {
  const Rgb f0 = at_normal(fresnel);
  const bool is_rgb = coloured(fresnel) || std::holds_alternative<Rgb>(term.weight);
  Rgb weight{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto* rgb = std::get_if<Rgb>(&term.weight);
    weight[c] = f0[c] * (rgb != nullptr ? (*rgb)[c] : std::get<double>(term.weight));
  }
  term.weight = as_value(weight, is_rgb);
  term.fresnel = {.type = "none"};
}

using Maker = ModelChoice (*)(const Fresnel&);

Step fitted(const std::string& name, const std::string& label, Maker maker) {
  return {label, [name, maker](Draft& draft) {
            TermDescription* term = draft.find(name);
            if (term == nullptr) return false;
            term->fresnel = maker(make_or_throw<Fresnel>("fresnel", term->fresnel));
            draft.set_free(name, "f0");
            return true;
          }};
}

Option option_of(const std::string& name, const std::string& type) {
  const std::string part = "F of " + name, was = " (was " + type + ")";
  Option option{part, {}};
  if (type == "conductor") option.steps.push_back(fitted(name, part + ": F82" + was, f82));
  if (type != "schlick") option.steps.push_back(fitted(name, part + ": Schlick" + was, schlick));
  option.steps.push_back({part + ": constant" + was, [name](Draft& draft) {
                            TermDescription* term = draft.find(name);
                            if (term == nullptr) return false;
                            const auto fresnel = make_or_throw<Fresnel>("fresnel", term->fresnel);
                            const bool bounced = is_bounced(draft.material, name);
                            bounced ? void(term->fresnel = constant(fresnel)) : put_in_weight(*term, fresnel);
                            draft.set_free(name, bounced ? "f0" : "weight");
                            return true;
                          }});
  return option;
}

} // namespace

std::vector<Option> SimplerFresnel::of(const MaterialDescription& material) {
  std::vector<Option> out;
  for (const TermDescription& term : material.terms)
    if (term.type == "mirror" && term.fresnel.type != "none") out.push_back(option_of(term.name, term.fresnel.type));
  return out;
}

} // namespace brdfplot::choice
