#include "brdf/material.hpp"

#include "base/number.hpp"
#include "brdf/integrals/kinks.hpp"
#include "brdf/terms/coated.hpp"

#include <algorithm>

namespace brdfplot {

namespace {

template <class T>
TermSpec term_spec() {
  TermSpec made{T::spec()};
  made.has_surface = requires(const T& t) { t.surface; };
  made.has_distribution = made.has_surface || requires(const T& t) { t.distribution; };
  made.has_fresnel = requires(const T& t) { t.fresnel; };
  made.of_another = requires { T::of_another; };
  return made;
}

/// Calls f<T>() with the type of term that `type` names.
template <class Function>
void with_type(const std::string& type, const Function& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    const auto& specs = term_specs();
    (void)((specs[I].spec.type == type ? (f.template operator()<std::variant_alternative_t<I, BrdfTerm>>(), true)
                                       : false) ||
           ...);
  }
  (std::make_index_sequence<std::variant_size_v<BrdfTerm>>{});
}

const TermSpec& spec_of(const std::string& type) {
  const auto& specs = term_specs();
  const auto found = std::ranges::find_if(specs, [&](const TermSpec& s) { return s.spec.type == type; });
  if (found != specs.end()) return *found;
  std::vector<std::string> names;
  for (const TermSpec& spec : specs) names.push_back(spec.spec.type);
  throw MaterialError("/type", unknown_name("type", type, names));
}

std::string name_of(const TermDescription& term) { return term.name.empty() ? term.type : term.name; }

Colour weight_of(const Value& weight) {
  const auto* rgb = std::get_if<Rgb>(&weight);
  const Rgb value =
      rgb != nullptr ? *rgb : Rgb{std::get<double>(weight), std::get<double>(weight), std::get<double>(weight)};
  constexpr double most = 1e6;
  for (const double w : value)
    if (!(w >= 0 && w <= most))
      throw MaterialError("/weight", "found " + format_number(w) + ", accepted: a number in [0, 1e+06]");
  return {value, rgb != nullptr};
}

/// The weight of a term and of the coated terms that it is part of.
Colour weight_of(const TermDescription& description) {
  Colour weight = weight_of(description.weight);
  for (const LayerDescription& layer : description.layers) {
    const Colour one = weight_of(layer.weight);
    for (std::size_t c = 0; c < weight.value.size(); ++c) weight.value[c] *= one.value[c];
    weight.is_rgb = weight.is_rgb || one.is_rgb;
  }
  return weight;
}

/// The description with the term that it names in the place of its name.
TermDescription resolved(const TermDescription& description, const MaterialDescription& all) {
  TermDescription out = description;
  if (description.of_name.empty()) return out;
  std::vector<std::string> names;
  for (const TermDescription& other : all.terms) {
    if (!spec_of(other.type).of_another && name_of(other) == description.of_name) out.of = {other};
    if (!spec_of(other.type).of_another) names.push_back(name_of(other));
  }
  if (out.of.empty()) throw MaterialError("/of", unknown_name("term", description.of_name, names));
  out.of_name.clear();
  return out;
}

void require_one_mesosurface(const Material& material) {
  const SlopeMap& of_all = material.mesosurface();
  for (const WeightedTerm& term : material.terms) {
    const Microsurface* surface = term.surface();
    const SlopeMap own = surface != nullptr ? surface->slopes() : SlopeMap{};
    if (own.mean_x != of_all.mean_x || own.mean_y != of_all.mean_y)
      throw MaterialError("/terms", "found a mean slope of (" + format_number(of_all.mean_x) + ", " +
                                        format_number(of_all.mean_y) + ") and one of (" + format_number(own.mean_x) +
                                        ", " + format_number(own.mean_y) + ") in \"" + term.name +
                                        "\"; accepted: the same for all terms");
  }
}

/// Sets `key` in `choice` if the model that it names has it.
bool set_in(const std::vector<ModelSpec>& specs, ModelChoice& choice, const std::string& key, double value) {
  for (const ModelSpec& spec : specs) {
    if (spec.type != choice.type || spec.find(key) == nullptr) continue;
    Values kept;
    const auto in = [](const std::vector<std::string>& group, const std::string& k) {
      return std::ranges::find(group, k) != group.end();
    };
    for (const auto& entry : choice.values.map()) {
      const std::string& other = entry.first;
      const auto alternative = [&](const std::string& k) {
        return std::ranges::any_of(spec.alternatives, [&](const auto& g) { return in(g, k); });
      };
      const bool displaced =
          alternative(key) && alternative(other) &&
          std::ranges::none_of(spec.alternatives, [&](const auto& g) { return in(g, key) && in(g, other); });
      if (!displaced) kept.set(other, entry.second);
    }
    kept.set(key, value);
    choice.values = kept;
    return true;
  }
  return false;
}

/// The values of a term as a choice, for set_in().
bool set_own(TermDescription& description, const std::string& key, double value) {
  if (key == "weight") {
    description.weight = value;
    return true;
  }
  ModelChoice own{description.type, description.values};
  if (!set_in({spec_of(description.type).spec}, own, key, value)) return false;
  description.values = own.values;
  return true;
}

void append_numbers(const std::vector<ModelSpec>& specs, const std::string& type, const std::string& prefix,
                    std::vector<std::string>& names) {
  for (const ModelSpec& spec : specs)
    if (spec.type == type)
      for (const ParameterSpec& parameter : spec.parameters)
        if (parameter.kind == ParameterKind::number || parameter.kind == ParameterKind::number_or_rgb)
          names.push_back(prefix + parameter.key);
}

} // namespace

const std::vector<TermSpec>& term_specs() {
  static const std::vector<TermSpec> all = []<std::size_t... I>(std::index_sequence<I...>) {
    return std::vector<TermSpec>{term_spec<std::variant_alternative_t<I, BrdfTerm>>()...,
                                 {.spec = Coated::spec(), .of_layers = true}};
  }
  (std::make_index_sequence<std::variant_size_v<BrdfTerm>>{});
  return all;
}

const TermDescription& another_of(const TermDescription& description) {
  if (description.of.size() != 1) throw MaterialError("/of", "found none; accepted: a term");
  if (spec_of(description.of[0].type).of_another)
    throw MaterialError("/of/type",
                        "found \"" + description.of[0].type + "\"; accepted: a term that is not itself of another");
  return description.of[0];
}

WeightedTerm build_term(const TermDescription& description) {
  const TermSpec& spec = spec_of(description.type);
  if (!spec.has_distribution && !description.distribution.type.empty())
    throw MaterialError("/distribution", "found one in a term \"" + description.type + "\", which has none");
  if (!spec.has_fresnel && description.fresnel.type != "none")
    throw MaterialError("/fresnel/type", "found \"" + description.fresnel.type + "\" in a term \"" + description.type +
                                             "\"; accepted: none");
  WeightedTerm made{name_of(description), weight_of(description), {}};
  for (const LayerDescription& layer : description.layers) made.groups.push_back(layer.name);
  with_type(description.type, [&]<class T>() { made.term = T::from(description); });
  return made;
}

int WeightedTerm::channels() const {
  if (weight.is_rgb || std::ranges::any_of(coats, [](const Coat& coat) { return coat.channels() > 1; })) return 3;
  return std::visit([](const auto& t) { return t.channels(); }, term);
}

const Microsurface* WeightedTerm::surface() const {
  return std::visit(
      [](const auto& t) -> const Microsurface* {
        if constexpr (requires { t.surface; })
          return &t.surface;
        else
          return nullptr;
      },
      term);
}

const Fresnel* WeightedTerm::fresnel() const {
  return std::visit(
      [](const auto& t) -> const Fresnel* {
        if constexpr (requires { t.fresnel; })
          return &t.fresnel;
        else
          return nullptr;
      },
      term);
}

const Distribution* WeightedTerm::facets() const {
  return std::visit(
      [](const auto& t) -> const Distribution* {
        if constexpr (requires { t.facets(); })
          return &t.facets();
        else
          return nullptr;
      },
      term);
}

bool WeightedTerm::is_isotropic() const {
  return std::visit(
      [](const auto& t) {
        if constexpr (requires { t.surface; })
          return !is_formula(t.surface.masking) && brdfplot::is_isotropic(t.surface.distribution);
        else if constexpr (requires { t.facets(); })
          return brdfplot::is_isotropic(t.facets());
        else if constexpr (requires { t.isotropic(); })
          return t.isotropic();
        else
          return true;
      },
      term);
}

int Material::channels() const {
  return std::ranges::any_of(terms, [](const WeightedTerm& t) { return t.channels() > 1; }) ? 3 : 1;
}

const SlopeMap& Material::mesosurface() const {
  static const SlopeMap flat;
  for (const WeightedTerm& term : terms)
    if (const Microsurface* surface = term.surface()) return surface->slopes();
  return flat;
}

const WeightedTerm& Material::term_with_surface(const std::string& term) const {
  std::string names;
  const WeightedTerm* found = nullptr;
  std::size_t count = 0;
  for (const WeightedTerm& one : terms) {
    if (one.surface() == nullptr) continue;
    names += (names.empty() ? "" : ", ") + one.name;
    if (!term.empty() && one.name != term) continue;
    found = &one;
    ++count;
  }
  if (count == 1) return *found;
  if (names.empty()) throw InputError(name, "none of its terms has a microsurface");
  if (term.empty())
    throw InputError(name, "several terms have a microsurface; accepted: TERM. before the name, of " + names);
  throw InputError(name, "no term \"" + term + "\" with a microsurface; accepted: " + names);
}

const Microsurface& Material::surface(const std::string& term) const { return *term_with_surface(term).surface(); }

std::vector<const WeightedTerm*> terms_of(const Material& material, const std::string& name) {
  std::vector<const WeightedTerm*> terms;
  for (const WeightedTerm& term : material.terms)
    if (name.empty() || term.name == name || std::ranges::find(term.groups, name) != term.groups.end())
      terms.push_back(&term);
  if (!terms.empty()) return terms;
  std::vector<std::string> names;
  for (const WeightedTerm& term : material.terms) names.push_back(term.name);
  throw InputError(material.name, unknown_name("term", name, names));
}

std::string pointer_of_term(const MaterialDescription& description, std::size_t index) {
  if (!description.terms[index].place.empty()) return description.terms[index].place;
  return description.listed ? "/terms/" + std::to_string(index) : "";
}

bool has_surface(const TermDescription& description) { return spec_of(description.type).has_surface; }

std::size_t term_with_surface(const MaterialDescription& description) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < description.terms.size(); ++k)
    if (has_surface(description.terms[k])) found.push_back(k);
  if (found.size() == 1) return found[0];
  throw MaterialError(description.listed ? "/terms" : "",
                      found.empty() ? "found no term with a microsurface; accepted: one"
                                    : "found several terms with a microsurface; accepted: one");
}

Material build(const MaterialDescription& description) {
  Material material{description.name, {}};
  for (std::size_t k = 0; k < description.terms.size(); ++k) {
    const std::string place = pointer_of_term(description, k);
    try {
      material.terms.push_back(build_term(resolved(description.terms[k], description)));
    } catch (const MaterialError& error) {
      throw MaterialError(place + error.pointer(), error.reason());
    }
    const std::string& own = material.terms.back().name;
    if (std::ranges::count(material.terms, own, &WeightedTerm::name) > 1)
      throw MaterialError(place + "/name", "found \"" + own + "\" twice; accepted: a name of its own for each term");
  }
  if (material.terms.empty()) throw MaterialError("/terms", "found none; accepted: one or more");
  require_one_mesosurface(material);
  lay_coats(description, material);
  return material;
}

Material build(const TermDescription& term) { return build(MaterialDescription(term)); }

void set_parameter(TermDescription& description, const std::string& key, double value) {
  const TermSpec& spec = spec_of(description.type);
  if (spec.has_distribution && set_in(specs_of<Distribution>(), description.distribution, key, value)) return;
  if (spec.has_surface && set_in(specs_of<Masking>(), description.masking, key, value)) return;
  if (spec.has_surface && description.shadowing && set_in(specs_of<Shadowing>(), *description.shadowing, key, value))
    return;
  if (spec.has_fresnel && set_in(specs_of<Fresnel>(), description.fresnel, key, value)) return;
  if (set_own(description, key, value)) return;
  if (key.starts_with("of.") && !description.of.empty()) return set_parameter(description.of[0], key.substr(3), value);
  throw MaterialError("/distribution", "no model of this material has a parameter \"" + key + "\"");
}

namespace {

/// Sets the weight or the tint of the coated term of this name. \return whether it has one
bool set_of_layers(MaterialDescription& description, const std::string& name, const std::string& key, double value) {
  bool found = false;
  for (TermDescription& term : description.terms)
    for (LayerDescription& layer : term.layers) {
      if (layer.name != name || (key != "weight" && key != "tint")) continue;
      found = true;
      if (key == "weight")
        layer.weight = value;
      else
        layer.values.set(key, value);
    }
  return found;
}

} // namespace

void set_parameter(MaterialDescription& description, const std::string& key, double value) {
  if (description.terms.size() == 1 && !description.listed) return set_parameter(description.terms[0], key, value);
  const std::size_t dot = key.find('.');
  for (TermDescription& term : description.terms)
    if (dot != std::string::npos && name_of(term) == key.substr(0, dot))
      return set_parameter(term, key.substr(dot + 1), value);
  if (dot != std::string::npos && set_of_layers(description, key.substr(0, dot), key.substr(dot + 1), value)) return;
  throw MaterialError("/terms", unknown_name("parameter", key, parameter_keys(description)));
}

namespace {

void append_keys(const TermDescription& term, const std::string& prefix, std::vector<std::string>& names) {
  const TermSpec& spec = spec_of(term.type);
  if (spec.has_distribution) append_numbers(specs_of<Distribution>(), term.distribution.type, prefix, names);
  if (spec.has_surface) {
    append_numbers(specs_of<Masking>(), term.masking.type, prefix, names);
    if (term.shadowing) append_numbers(specs_of<Shadowing>(), term.shadowing->type, prefix, names);
  }
  if (spec.has_fresnel) append_numbers(specs_of<Fresnel>(), term.fresnel.type, prefix, names);
  append_numbers({spec.spec}, term.type, prefix, names);
  names.push_back(prefix + "weight");
  for (const TermDescription& other : term.of) append_keys(other, prefix + "of.", names);
}

} // namespace

std::vector<std::string> parameter_keys(const MaterialDescription& description) {
  std::vector<std::string> names;
  for (const TermDescription& term : description.terms)
    append_keys(term, description.listed ? name_of(term) + "." : "", names);
  for (const TermDescription& term : description.terms)
    for (const LayerDescription& layer : term.layers)
      for (const std::string key : {".weight", ".tint"})
        if (std::ranges::find(names, layer.name + key) == names.end()) names.push_back(layer.name + key);
  return names;
}

} // namespace brdfplot
