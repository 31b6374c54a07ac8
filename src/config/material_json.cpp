#include "config/load.hpp"
#include "config/model_json.hpp"
#include "config/shapes.hpp"
#include "math/number.hpp"
#include "microfacet/registry.hpp"

#include <filesystem>

namespace brdfplot::config {

double to_number(const Json& value) {
  return value.is_string() ? *parse_angle(value.get<std::string>()) : value.get<double>();
}

ShapePtr material_shape(bool top) {
  std::vector<Field> fields = {
      {"name", text(), false, "what figures and errors call it; default: the name of the file"},
      {"distribution", named("distribution", [] { return model(specs_of<Distribution>()); }), true,
       "distribution of normals"},
      {"masking", named("masking", [] { return model(specs_of<Masking>()); }), false,
       "masking function G1; default smith"},
      {"shadowing", named("shadowing", [] { return model(specs_of<Shadowing>()); }), false,
       "joint masking-shadowing G2; default height_correlated, minimum for v_cavity, separable for implicit and "
       "kelemen"},
      {"fresnel", named("fresnel", [] { return model(specs_of<Fresnel>()); }), false,
       "Fresnel term; default none (F = 1)"},
      {"facet", choice(facet_names()), false,
       "how a facet reflects; default specular. A diffuse one has no Fresnel term; the fits of Oren and Nayar are for "
       "distribution oren_nayar with masking v_cavity"},
      {"claims", array(choice(claim_names())), false,
       "what `brdfplot check` has to find true: physically_based, or properties by name"}};
  if (top) return object(std::move(fields), true);
  return named("material", [fields] { return object(fields); });
}

MaterialDescription read_material(const JsonFile& file, const Json& value, const std::string& pointer) {
  MaterialDescription material;
  material.name = value.contains("name") ? value["name"].get<std::string>()
                                         : std::filesystem::path(file.file(pointer)).stem().string();
  material.distribution = to_choice<Distribution>(value["distribution"]);
  if (value.contains("masking")) material.masking = to_choice<Masking>(value["masking"]);
  if (value.contains("shadowing")) material.shadowing = to_choice<Shadowing>(value["shadowing"]);
  if (value.contains("fresnel")) material.fresnel = to_choice<Fresnel>(value["fresnel"]);
  if (value.contains("facet")) material.facet = value["facet"].get<std::string>();
  if (value.contains("claims")) material.claims = value["claims"].get<std::vector<std::string>>();
  try {
    build(material);
  } catch (const MaterialError& error) {
    file.fail(pointer + error.pointer(), error.reason());
  }
  return material;
}

MaterialDescription load_material(const std::string& path) {
  const JsonFile file(path);
  static const ShapePtr shape = material_shape(true);
  file.check(*shape);
  return read_material(file, file.root(), "");
}

} // namespace brdfplot::config
