#include "config/figure/sphere.hpp"

#include "figure/series/configuration.hpp"
#include "figure/spheres/panel.hpp"

#include <algorithm>
#include <map>

namespace brdfplot::config {

namespace {

constexpr std::size_t most_lights = 16;

/// Beyond, nothing is told apart, and products might overflow.
constexpr double brightest = 1e6;

ShapePtr colour() {
  const ShapePtr one = number({.min = 0, .max = brightest});
  return either({one, array(one, 3, 3)});
}

ShapePtr light() {
  return named("light", [] {
    const Field theta{"theta", angle(), true, "from the direction of the viewer, up to 180deg"};
    const Field phi{"phi", angle(), false, "from the right of the picture, counterclockwise; default 0"};
    const Field radiance{"radiance", colour(), true, "of every direction of it, linear"};
    const auto type = [](const std::string& doc) { return Field{"type", text(), true, doc}; };
    return tagged(
        {{"directional", object({type("light from one direction"),
                                 theta,
                                 phi,
                                 {"irradiance", colour(), true, "across its direction, linear"}})},
         {"sphere", object({type("a sphere far away, of even radiance"),
                            theta,
                            phi,
                            {"radius", angle(), true, "the angle under which its radius is seen, up to 90deg"},
                            radiance})},
         {"environment", object({type("the same radiance from everywhere: a furnace"), radiance})}});
  });
}

Colour to_colour(const Json& value) {
  if (value.is_array()) return {value.get<Rgb>(), true};
  const auto grey = value.get<double>();
  return {{grey, grey, grey}, false};
}

plot::Light to_light(const Json& value) {
  using Type = plot::Light::Type;
  static const std::map<std::string, Type> types = {
      {"directional", Type::directional}, {"sphere", Type::sphere}, {"environment", Type::environment}};
  plot::Light light;
  light.type = types.at(value["type"].get<std::string>());
  const auto read = [&](const char* key, double& to) {
    if (value.contains(key)) to = to_number(value[key]);
  };
  read("theta", light.theta);
  read("phi", light.phi);
  read("radius", light.radius);
  light.colour = to_colour(value[light.type == Type::directional ? "irradiance" : "radiance"]);
  return light;
}

/// Settings are of the material: a sphere has every direction, and shows all channels.
void check_settings(const JsonFile& file, const Scope& scope) {
  const auto& directions = plot::direction_variables();
  for (std::size_t k = 0; k < scope.at.size(); ++k) {
    const std::string& variable = scope.at[k].variable;
    if (variable == "channel" || std::ranges::find(directions, variable) != directions.end())
      file.fail(scope.places[k], "a sphere has no \"" + variable +
                                     "\": it shows all directions and channels; accepted: what is set of "
                                     "the material");
  }
}

/// Tries the material with its settings, in one channel at one pair of directions.
void check_material(const JsonFile& file, const plot::SphereDescription& sphere, const std::string& pointer,
                    Scope scope, double tolerance) {
  for (const char* angle : {"theta_o", "theta_i"}) scope.set({angle, 0.0}, pointer);
  scope.set({"channel", "r"}, pointer);
  check_term(file, {"brdf_cos", sphere.material, scope.at, {}}, pointer, scope, {}, tolerance);
}

} // namespace

ShapePtr sphere_shape() {
  return named("sphere", [] {
    return object({{"lights", array(light(), 1, most_lights), false, "what lights it; their light adds up"},
                   {"exposure", number({.min = 1 / brightest, .max = brightest}), false,
                    "radiance times it is shown, 1 as white; default 1"},
                   {"pixels", whole_number(plot::fewest_pixels, plot::most_pixels), false,
                    "along each side of the picture; default 256"}});
  });
}

plot::SphereDescription read_sphere(const JsonFile& file, const Json& panel, const std::string& pointer,
                                    const Scope& scope, double tolerance) {
  Json merged = file.root().value("sphere", Json::object());
  for (const auto& [key, value] : panel["sphere"].items()) merged[key] = value;
  const auto place = [&](const std::string& key) {
    const bool above = !panel["sphere"].contains(key) && file.root().contains("sphere");
    return above && file.root()["sphere"].contains(key) ? "/sphere" : pointer + "/sphere";
  };
  if (!merged.contains("lights")) file.fail(pointer + "/sphere", "\"lights\" is missing here and above");
  if (!scope.material) file.fail(pointer, "\"material\" is missing here and above");
  check_settings(file, scope);
  plot::SphereDescription out;
  out.material = *scope.material;
  out.at = scope.at;
  for (const Json& one : merged["lights"]) out.lights.push_back(to_light(one));
  out.exposure = merged.value("exposure", out.exposure);
  out.pixels = static_cast<int>(merged.value("pixels", double(out.pixels)));
  check_material(file, out, pointer, scope, tolerance);
  if (const auto problem = plot::problem_of(out)) {
    if (problem->key.empty()) file.fail(pointer, problem->what);
    file.fail(place("lights") + "/" + problem->key, problem->what);
  }
  return out;
}

} // namespace brdfplot::config
