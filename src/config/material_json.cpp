#include "base/number.hpp"
#include "config/load.hpp"
#include "config/model_json.hpp"
#include "config/shapes.hpp"

#include <algorithm>
#include <filesystem>

namespace brdfplot::config {

namespace {

/// What "facet" may say of a material of one term: the type of the term, and the form of a fit.
struct FacetName {
  std::string name;
  std::string type;
  std::string form;
};

const std::vector<FacetName>& facets() {
  static const std::vector<FacetName> all = {{"specular", "mirror", ""},
                                             {"diffuse", "facet_diffuse", ""},
                                             {"oren_nayar", "oren_nayar", "full"},
                                             {"oren_nayar_direct", "oren_nayar", "direct"},
                                             {"oren_nayar_qualitative", "oren_nayar", "qualitative"}};
  return all;
}

std::vector<std::string> facet_names() {
  std::vector<std::string> names;
  for (const FacetName& facet : facets()) names.push_back(facet.name);
  return names;
}

Field distribution_field() {
  return {"distribution", named("distribution", [] { return model(specs_of<Distribution>()); }), true,
          "distribution of normals"};
}

std::vector<Field> microsurface_fields() {
  return {distribution_field(),
          {"masking", named("masking", [] { return model(specs_of<Masking>()); }), false,
           "masking function G1; default smith"},
          {"shadowing", named("shadowing", [] { return model(specs_of<Shadowing>()); }), false,
           "joint masking-shadowing G2; default height_correlated, minimum for v_cavity, separable for implicit and "
           "kelemen"}};
}

Field fresnel_field() {
  return {"fresnel", named("fresnel", [] { return model(specs_of<Fresnel>()); }), false,
          "Fresnel term; default none (F = 1)"};
}

Field claims_field() {
  return {"claims", array(choice(claim_names())), false,
          "what `brdfplot check` has to find true: physically_based, or properties by name"};
}

Field name_field() { return {"name", text(), false, "what figures and errors call it; default: the name of the file"}; }

Field another_field();
std::vector<Field> layer_fields();

ShapePtr term_shape() {
  std::vector<std::pair<std::string, ShapePtr>> types;
  constexpr double most = 1e6;
  const Bounds weights{.min = 0, .max = most};
  for (const TermSpec& term : term_specs()) {
    const ModelSpec& spec = term.spec;
    std::vector<Field> fields = {{"type", text(), true, spec.doc + " (" + spec.source + ")"},
                                 {"name", file_stem(), false,
                                  "how parameters and quantities of it are asked for: NAME.alpha; default: its type"},
                                 {"weight", either({number(weights), array(number(weights), 3, 3)}), false,
                                  "what it is multiplied by, or one factor a channel; default 1"}};
    if (term.has_surface)
      for (Field& field : microsurface_fields()) fields.push_back(std::move(field));
    else if (term.has_distribution)
      fields.push_back(distribution_field());
    if (term.of_another) fields.push_back(another_field());
    if (term.of_layers)
      for (Field& field : layer_fields()) fields.push_back(std::move(field));
    if (term.has_fresnel) fields.push_back(fresnel_field());
    for (Field& field : parameter_fields(spec)) fields.push_back(std::move(field));
    types.emplace_back(spec.type, object_with_alternatives(std::move(fields), spec.alternatives));
  }
  return tagged(std::move(types));
}

Field another_field() {
  return {"of", either({text(), named("term", term_shape)}), true, "the name of a term beside it, or a term"};
}

constexpr std::size_t most_terms = 64;

std::vector<Field> layer_fields() {
  return {{"coat", named("term", term_shape), true, "the term that lies over the base; its name: by default coat"},
          {"base", array(named("term", term_shape), 1, most_terms), true, "what lies beneath it, a sum of terms"}};
}

/// A material of one term, as it is written without a list.
ShapePtr short_shape(bool top) {
  std::vector<Field> fields = {name_field()};
  for (Field& field : microsurface_fields()) fields.push_back(std::move(field));
  fields.push_back(fresnel_field());
  fields.push_back({"facet", choice(facet_names()), false,
                    "how a facet reflects; default specular. A diffuse one has no Fresnel term; the fits of Oren and "
                    "Nayar are for distribution oren_nayar with masking v_cavity"});
  fields.push_back(claims_field());
  return object(std::move(fields), top);
}

ShapePtr list_shape(bool top) {
  return object({name_field(),
                 {"terms", array(named("term", term_shape), 1, most_terms), true, "what its BRDF is a sum of"},
                 claims_field()},
                top);
}

void read_microsurface(const Json& value, MicrosurfaceDescription& surface) {
  surface.distribution = to_choice<Distribution>(value["distribution"]);
  if (value.contains("masking")) surface.masking = to_choice<Masking>(value["masking"]);
  if (value.contains("shadowing")) surface.shadowing = to_choice<Shadowing>(value["shadowing"]);
}

Value read_weight(const Json& value) {
  if (!value.contains("weight")) return 1.0;
  const Json& weight = value["weight"];
  return weight.is_number() ? Value(weight.get<double>()) : Value(weight.get<Rgb>());
}

const TermSpec& spec_of(const Json& term) {
  const std::string type = term["type"].get<std::string>();
  return *std::ranges::find_if(term_specs(), [&](const TermSpec& s) { return s.spec.type == type; });
}

/// Where a material stands.
struct Site {
  const JsonFile& file;
  const std::string& pointer;

  /// What stands in a file names other files relative to it.
  std::string beside(const std::string& place, const std::string& path) const {
    return (std::filesystem::path(file.file(pointer + place)).parent_path() / path).string();
  }
};

/// `place` is where the model stands within the material.
Values read_values(const Site& site, const Json& value, const std::string& place, const ModelSpec& spec) {
  Values values;
  for (const ParameterSpec& parameter : spec.parameters) {
    if (!value.contains(parameter.key)) continue;
    const Json& given = value[parameter.key];
    if (parameter.kind == ParameterKind::text)
      values.set(parameter.key, site.beside(place + "/" + parameter.key, given.get<std::string>()));
    else
      values.set(parameter.key, to_value(given, parameter));
  }
  return values;
}

TermDescription read_term(const Site& site, const Json& value, const std::string& place) {
  TermDescription term;
  const TermSpec& spec = spec_of(value);
  term.type = spec.spec.type;
  term.place = place;
  if (value.contains("name")) term.name = value["name"].get<std::string>();
  term.weight = read_weight(value);
  if (value.contains("distribution")) read_microsurface(value, term);
  if (value.contains("of") && value["of"].is_string()) term.of_name = value["of"].get<std::string>();
  if (value.contains("of") && value["of"].is_object()) {
    if (spec_of(value["of"]).of_layers)
      throw MaterialError(place + "/of/type", "found \"" + value["of"]["type"].get<std::string>() +
                                                  "\", which is several terms; accepted: one term");
    term.of = {read_term(site, value["of"], place + "/of")};
  }
  if (value.contains("fresnel")) term.fresnel = to_choice<Fresnel>(value["fresnel"]);
  term.values = read_values(site, value, place, spec.spec);
  return term;
}

/// A term, or the terms that a coated one is made of.
std::vector<TermDescription> read_terms(const Site& site, const Json& value, const std::string& place) {
  const TermSpec& spec = spec_of(value);
  if (!spec.of_layers) return {read_term(site, value, place)};
  if (const TermSpec& coat = spec_of(value["coat"]); coat.of_layers || coat.of_another)
    throw MaterialError(place + "/coat/type",
                        "found \"" + coat.spec.type + "\"; accepted: a term that is not made of others");
  LayerDescription layer{value.contains("name") ? value["name"].get<std::string>() : spec.spec.type, read_weight(value),
                         "", read_values(site, value, place, spec.spec), place};
  std::vector<TermDescription> all = {read_term(site, value["coat"], place + "/coat")};
  if (all[0].name.empty()) all[0].name = "coat";
  all[0].layers.push_back(layer);
  layer.coat = all[0].name;
  for (std::size_t k = 0; k < value["base"].size(); ++k)
    for (TermDescription& term : read_terms(site, value["base"][k], place + "/base/" + std::to_string(k))) {
      term.layers.insert(term.layers.begin(), layer);
      all.push_back(std::move(term));
    }
  return all;
}

/// Oren and Nayar fitted one microsurface, of which their fits know sigma.
void make_fit(TermDescription& term, const FacetName& facet) {
  const bool own = term.distribution.type == "oren_nayar" && term.masking.type == "v_cavity" &&
                   (!term.shadowing || term.shadowing->type == "minimum");
  if (!own)
    throw MaterialError("/facet", "\"" + facet.name +
                                      "\" is a fit for the distribution \"oren_nayar\", the masking \"v_cavity\" and "
                                      "the shadowing \"minimum\" alone; accepted with any: specular, diffuse");
  term.values.set("sigma", term.distribution.values.number("sigma"));
  term.values.set("form", facet.form);
  static_cast<MicrosurfaceDescription&>(term) = {};
}

TermDescription read_short(const Json& value) {
  TermDescription term;
  read_microsurface(value, term);
  if (value.contains("fresnel")) term.fresnel = to_choice<Fresnel>(value["fresnel"]);
  const std::string name = value.contains("facet") ? value["facet"].get<std::string>() : "specular";
  const FacetName& facet = *std::ranges::find(facets(), name, &FacetName::name);
  term.type = facet.type;
  if (term.type != "mirror" && term.fresnel.type != "none")
    throw MaterialError("/fresnel/type",
                        "found \"" + term.fresnel.type + "\" beside \"facet\": \"" + name + "\"; accepted: none");
  if (!facet.form.empty()) make_fit(term, facet);
  return term;
}

} // namespace

double to_number(const Json& value) {
  return value.is_string() ? *parse_angle(value.get<std::string>()) : value.get<double>();
}

ShapePtr material_shape(bool top) {
  if (top) return with_key("terms", list_shape(true), short_shape(true));
  return named("material", [] { return with_key("terms", list_shape(false), short_shape(false)); });
}

MaterialDescription read_material(const JsonFile& file, const Json& value, const std::string& pointer) {
  MaterialDescription material;
  material.name = value.contains("name") ? value["name"].get<std::string>()
                                         : std::filesystem::path(file.file(pointer)).stem().string();
  if (value.contains("claims")) material.claims = value["claims"].get<std::vector<std::string>>();
  material.listed = value.contains("terms");
  try {
    if (material.listed)
      for (std::size_t k = 0; k < value["terms"].size(); ++k)
        for (TermDescription& term : read_terms({file, pointer}, value["terms"][k], "/terms/" + std::to_string(k)))
          material.terms.push_back(std::move(term));
    else
      material.terms.push_back(read_short(value));
    build(material);
  } catch (const MaterialError& error) {
    file.fail(pointer + error.pointer(), error.reason());
  }
  return material;
}

namespace {

MaterialDescription material_of(const JsonFile& file) {
  expect_kind(file, "material");
  static const ShapePtr shape = material_shape(true);
  file.check(*shape);
  return read_material(file, file.root(), "");
}

} // namespace

MaterialDescription load_material(const std::string& path) { return material_of(JsonFile(path)); }

MaterialDescription material_from_text(const std::string& json, const std::string& name) {
  return material_of(JsonFile(name, json));
}

bool is_material_text(const std::string& argument) {
  const auto first = argument.find_first_not_of(" \t\r\n");
  return first != std::string::npos && argument[first] == '{';
}

std::string name_of_argument(const std::string& argument) { return is_material_text(argument) ? "-m" : argument; }

MaterialDescription material_of_argument(const std::string& argument) {
  if (!is_material_text(argument)) return load_material(argument);
  MaterialDescription material = material_from_text(argument, "-m");
  if (material.name == "-m") material.name = "material"; // what is written is named so too
  return material;
}

} // namespace brdfplot::config
