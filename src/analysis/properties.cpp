#include "analysis/properties.hpp"

#include "analysis/property_tests.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "models/registry.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot {

namespace {

/// Whether the distribution that `choice` names still needs a roughness, and takes it as `alpha`.
bool takes_alpha(const ModelChoice& choice) {
  const auto& specs = specs_of<Distribution>();
  const auto spec = std::ranges::find(specs, choice.type, &ModelSpec::type);
  if (spec == specs.end() || spec->find("alpha") == nullptr || choice.values.has("alpha")) return false;
  return std::ranges::none_of(spec->alternatives, [&](const auto& group) {
    return std::ranges::all_of(group, [&](const auto& key) { return choice.values.has(key); });
  });
}

std::string text_of(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return format_number(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  std::string out;
  if (const auto* parts = std::get_if<WeightedChoices>(&value))
    for (const WeightedChoice& part : *parts) out += (out.empty() ? "" : " ") + part.model.type;
  const auto append = [&](double x) { out += (out.empty() ? "" : " ") + format_number(x); };
  if (const auto* pair = std::get_if<Vec2>(&value)) std::ranges::for_each(*pair, append);
  if (const auto* rgb = std::get_if<Rgb>(&value)) std::ranges::for_each(*rgb, append);
  return out;
}

Verdict verdict_of(const PropertyRow& row, Property property) {
  const auto found = row.residuals.find(property);
  return found == row.residuals.end() ? Verdict::unknown : found->second.verdict;
}

/// Whether a property is one of the BRDF itself; the others are of the microsurface that it is derived from.
bool of_brdf(Property property) { return property == Property::reciprocity || property == Property::energy; }

/// Why a property says nothing of any of these materials; nothing where it may.
std::string why_not_applicable(Property property, const std::vector<MaterialDescription>& family) {
  if (of_brdf(property)) return {};
  std::size_t most = 0;
  for (const MaterialDescription& member : family) {
    const Material material = build(member);
    const auto count = std::ranges::count_if(material.terms, [](const auto& t) { return t.surface() != nullptr; });
    if (count == 1) return {};
    most = std::max(most, static_cast<std::size_t>(count));
  }
  return most == 0 ? "the BRDF has no microsurface" : "several microsurfaces, each of which is told by itself";
}

/// The models of a term, for a row.
std::string label_of(const TermDescription& term) {
  if (has_surface(term)) return describe(term.distribution);
  const std::string own = describe({term.type, term.values});
  return term.distribution.type.empty() ? own : own + " of " + describe(term.distribution);
}

} // namespace

const std::vector<PropertyInfo>& properties() {
  static const std::vector<PropertyInfo> all = {
      {Property::eq14, "eq14", "Eq. 14", "|projected area of the visible facets / cos theta_o - 1|",
       "Heitz 2014, Eqs. 13-14; Akenine-Moller et al. 2018, Eq. 9.23"},
      {Property::eq18, "eq18", "Eq. 18", "|integral of the visible normals - 1|", "Heitz 2014, Eq. 18"},
      {Property::eq36, "eq36", "Eq. 36", "|weak white furnace of specular facets - 1|", "Heitz 2014, Eqs. 35-36"},
      {Property::eq37, "eq37", "Eq. 37", "|weak white furnace of diffuse facets - 1|", "Heitz 2014, Eq. 37"},
      {Property::normalized, "normalized", "D normalized", "|integral of D cos theta_m - 1|",
       "Heitz 2014, Eq. 9; Akenine-Moller et al. 2018, Eq. 9.21"},
      {Property::eq9_22, "eq9_22", "RTR Eq. 9.22", "|integral of D (o.m), unclamped, - o.g| at most over o",
       "Akenine-Moller et al. 2018, Eq. 9.22"},
      {Property::g1_range, "g1_range", "G1 in [0, 1]", "how far G1 is outside"},
      {Property::g1_decreasing, "g1_decreasing", "G1 decreasing", "how much G1 grows in a step of theta_o"},
      {Property::g1_normal, "g1_normal", "G1 = 1 at normal", "|G1 - 1| at the normal"},
      {Property::stretch_invariance, "stretch_invariance", "stretch invariant",
       "|change of G1| when the whole configuration is stretched"},
      {Property::reciprocity, "reciprocity", "reciprocal", "|rho(o,i) - rho(i,o)| / (rho(o,i) + rho(i,o))"},
      {Property::energy, "energy", "energy <= 1", "white furnace (F = 1) - 1, where it is above", "Heitz 2014, Eq. 34"},
  };
  return all;
}

const std::vector<Property>& table3_properties() {
  static const std::vector<Property> all = {Property::eq14, Property::eq18, Property::eq36, Property::eq37};
  return all;
}

std::vector<std::string> claim_names() {
  std::vector<std::string> names = {"physically_based"};
  for (const auto& info : properties()) names.push_back(info.name);
  return names;
}

Verdict PropertyRow::physically_based() const {
  const auto of = [&](Property property) { return verdict_of(*this, property); };
  const auto& four = table3_properties();
  if (std::ranges::any_of(four, [&](Property p) { return of(p) == Verdict::fails; })) return Verdict::fails;
  for (const Verdict all : {Verdict::holds, Verdict::not_applicable})
    if (std::ranges::all_of(four, [&](Property p) { return of(p) == all; })) return all;
  return Verdict::unknown;
}

Verdict PropertyRow::verdict(const std::string& claim) const {
  if (claim == "physically_based") return physically_based();
  const auto info = std::ranges::find(properties(), claim, &PropertyInfo::name);
  return verdict_of(*this, info->property);
}

std::vector<double> PropertySearch::default_theta_o() {
  std::vector<double> out;
  for (const double degrees : {0, 15, 30, 45, 60, 75, 85, 89}) out.push_back(degrees * (std::acos(-1.0) / 180));
  return out;
}

Residual measure(Property property, const std::vector<MaterialDescription>& family, const PropertySearch& search) {
  if (const std::string reason = why_not_applicable(property, family); !reason.empty())
    return {.verdict = Verdict::not_applicable, .reason = reason};
  WorstResidual worst(search.tolerance);
  for (const MaterialDescription& member : family) {
    const PropertySubject subject(member);
    worst.at_alpha(subject.material.mesosurface().alpha_x);
    try {
      test_property(property, subject, search, worst);
    } catch (const AccuracyError&) {
      worst.take(std::numeric_limits<double>::quiet_NaN(), 0, 0, 0);
    }
  }
  Residual residual = worst.residual();
  if (residual.verdict == Verdict::not_applicable)
    residual.reason = property == Property::eq9_22 ? "the mean slope is infinite" : "not shape-invariant";
  return residual;
}

std::string describe(const ModelChoice& distribution) {
  std::string parameters;
  for (const auto& [key, value] : distribution.values.map())
    parameters += (parameters.empty() ? "" : "; ") + key + " " + text_of(value);
  return distribution.type + (parameters.empty() ? "" : " (" + parameters + ")");
}

std::vector<PropertyFamily> families_of(const MaterialDescription& material) {
  std::string label;
  std::vector<PropertyFamily> all;
  for (const TermDescription& term : material.terms) {
    label += (label.empty() ? "" : " + ") + label_of(term);
    if (!has_surface(term)) continue;
    MaterialDescription alone{material.name, {term}, false};
    alone.terms[0].layers.clear(); // what is told is its microsurface
    alone.name += ", " + (term.name.empty() ? term.type : term.name);
    all.push_back({alone.name, label_of(term), {alone}});
  }
  if (all.size() == 1) all.clear();
  all.insert(all.begin(), {material.name, label, {material}});
  return all;
}

std::vector<PropertyFamily> families(const PropertyTableDescription& table) {
  std::vector<PropertyFamily> all;
  for (const auto& masking : table.maskings)
    for (const auto& distribution : table.distributions) {
      PropertyFamily family{"", describe(distribution), {}};
      TermDescription member{};
      member.name = family.label + " with " + masking;
      member.distribution = distribution;
      member.masking.type = masking;
      if (!takes_alpha(distribution)) {
        family.members.emplace_back(member);
      } else {
        for (const double alpha : table.alpha) {
          member.distribution.values.set("alpha", alpha);
          family.members.emplace_back(member);
        }
      }
      all.push_back(std::move(family));
    }
  return all;
}

PropertyRow row_of(const PropertyFamily& family) {
  PropertyRow row{family.material, family.label, "", "", {}};
  for (const TermDescription& term : family.members.at(0).terms) {
    if (!has_surface(term)) continue;
    row.distribution += (row.distribution.empty() ? "" : " + ") + term.distribution.type;
    row.masking += (row.masking.empty() ? "" : " + ") + term.masking.type;
  }
  return row;
}

PropertyRow measure(const PropertyFamily& family, const std::vector<Property>& which, const PropertySearch& search) {
  PropertyRow row = row_of(family);
  for (const Property property : which) row.residuals[property] = measure(property, family.members, search);
  return row;
}

} // namespace brdfplot
