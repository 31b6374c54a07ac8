#include "config/load.hpp"
#include "config/shapes.hpp"

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <set>

namespace brdfplot::config {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double brightest_light = 1e6;
constexpr std::size_t most_advised = 64, most_range_values = 16, most_lights_of_advice = 16;

ShapePtr advised_material() {
  return object(
      {{"material", material_shape(false), true, "the material in full"},
       {"ranges", map(array(number(), 1, most_range_values), "a parameter of the material, as figures name it"), false,
        "other values of parameters that the model has to be good for as well, one at a time"}});
}

ShapePtr advice_light() {
  const ShapePtr one = number({.min = 0, .max = brightest_light});
  return object({{"theta", angle(), true, "from the direction of the viewer, up to 180deg"},
                 {"phi", angle(), false, "from the right of the picture, counterclockwise; default 0"},
                 {"radius", angle(), false, "of its disc, as it is seen; default 0: punctual"},
                 {"irradiance", either({one, array(one, 3, 3)}), true, "across its direction, linear"}});
}

ShapePtr view_range() {
  return object({{"theta_o", array(angle(), 2, 91), true,
                  "ascending angles between normal and viewer: the edges of a histogram, two for a range"},
                 {"shares", array(number({.min = 0, .max = 1e6}), 1, 90), false,
                  "how much of what is seen is in each bin; default: as a sphere has them"}});
}

ShapePtr tolerance_shape() {
  return object_with_alternatives({{"delta_e", number({.min = 0, .max = 100, .open_min = true}), false,
                                    "of Delta E_ITP (ITU-R BT.2124), of which 1 is just noticeable"},
                                   {"relative", number({.min = 0, .max = 10, .open_min = true}), false,
                                    "of radiance, of the channel that is worst"}},
                                  {{"delta_e"}, {"relative"}});
}

/// An angle of a light or a view, within [0, most].
double angle_within(const JsonFile& file, const Json& value, const std::string& pointer, double most,
                    const std::string& accepted) {
  const double out = to_number(value);
  if (!(out >= 0 && out <= most)) file.fail(pointer, "found " + show(value) + ", accepted: " + accepted);
  return out;
}

choice::AdviceLight to_advice_light(const JsonFile& file, const Json& value, const std::string& pointer) {
  choice::AdviceLight light;
  light.theta = angle_within(file, value["theta"], pointer + "/theta", pi, "an angle in [0, 180deg]");
  if (value.contains("phi")) light.phi = to_number(value["phi"]);
  if (value.contains("radius"))
    light.radius = angle_within(file, value["radius"], pointer + "/radius", pi / 2, "an angle in [0, 90deg]");
  const Json& colour = value["irradiance"];
  const double grey = colour.is_array() ? 0 : colour.get<double>();
  light.irradiance = colour.is_array() ? Colour{colour.get<Rgb>(), true} : Colour{{grey, grey, grey}, false};
  return light;
}

choice::ViewRange to_view(const JsonFile& file, const Json& root) {
  choice::ViewRange view;
  if (!root.contains("view")) return {{0, pi / 2}, {}};
  const Json& value = root["view"];
  for (std::size_t k = 0; k < value["theta_o"].size(); ++k) {
    const std::string pointer = "/view/theta_o/" + std::to_string(k);
    const double edge = angle_within(file, value["theta_o"][k], pointer, pi / 2, "an angle in [0, 90deg]");
    if (k > 0 && !(edge > view.edges.back()))
      file.fail(pointer, "found " + show(value["theta_o"][k]) + ", accepted: more than the one before");
    view.edges.push_back(edge);
  }
  if (!value.contains("shares")) return view;
  view.shares = value["shares"].get<std::vector<double>>();
  if (view.shares.size() + 1 != view.edges.size())
    file.fail("/view/shares", "found " + std::to_string(view.shares.size()) + " shares, accepted: " +
                                  std::to_string(view.edges.size() - 1) + ", one for each bin of theta_o");
  if (std::ranges::all_of(view.shares, [](double share) { return share == 0; }))
    file.fail("/view/shares", "all are 0; accepted: one of them above 0");
  return view;
}

choice::AdvisedMaterial to_advised(const JsonFile& file, const Json& value, const std::string& pointer) {
  choice::AdvisedMaterial out{read_material(file, value["material"], pointer + "/material"), {}, file.where(pointer)};
  const std::string place = pointer + "/ranges";
  if (!value.contains("ranges")) return out;
  const std::vector<std::string> keys = parameter_keys(out.material);
  for (const auto& [key, values] : value["ranges"].items()) {
    if (std::ranges::find(keys, key) == keys.end()) file.fail(step(place, key), unknown_name("parameter", key, keys));
    for (std::size_t k = 0; k < values.size(); ++k) {
      const auto number = values[k].get<double>();
      try {
        choice::variants_of({out.material, {{key, {number}}}, {}});
      } catch (const MaterialError& error) {
        file.fail(step(place, key) + "/" + std::to_string(k), error.reason());
      }
    }
    out.ranges.emplace_back(key, values.get<std::vector<double>>());
  }
  return out;
}

} // namespace

ShapePtr advice_shape() {
  return object(
      {{"name", text(), false, "what the answer calls it; default: the name of the file"},
       {"materials", array(advised_material(), 1, most_advised), true, "for each of which a model is looked for"},
       {"lights", array(advice_light(), 1, most_lights_of_advice), true, "what lights them; their light adds up"},
       {"view", view_range(), false, "which angles of the surface are seen; default: a whole sphere"},
       {"exposure", number({.min = 1e-6, .max = 1e6}), false,
        "radiance times it is shown, 1 as white of 203 cd/m^2; default 1"},
       {"tolerance", tolerance_shape(), true, "how far 95 % of the lit area may be off, the worst 1 % twice as far"},
       {"target", choice(choice::target_names()), false,
        "what runs it: a shader, or a processor that starts from double or float, one by one or in lanes; default "
        "shader"},
       {"budget", number({.min = 1, .max = 1e9}), false,
        "most operations of a shaded point, under all lights; of a processor its multiply-adds in double"}},
      true);
}

choice::AdviceScene load_advice(const std::string& path) {
  const JsonFile file(path);
  static const ShapePtr shape = advice_shape();
  expect_kind(file, "advice");
  file.check(*shape);
  const Json& root = file.root();
  choice::AdviceScene scene;
  scene.name = root.value("name", std::filesystem::path(path).stem().string());
  std::set<std::string> names;
  for (std::size_t k = 0; k < root["materials"].size(); ++k) {
    const std::string pointer = "/materials/" + std::to_string(k);
    scene.materials.push_back(to_advised(file, root["materials"][k], pointer));
    if (!names.insert(scene.materials.back().material.name).second)
      file.fail(pointer, "the name \"" + scene.materials.back().material.name + "\" stands twice in this scene");
  }
  for (std::size_t k = 0; k < root["lights"].size(); ++k)
    scene.lights.push_back(to_advice_light(file, root["lights"][k], "/lights/" + std::to_string(k)));
  scene.view = to_view(file, root);
  scene.exposure = root.value("exposure", scene.exposure);
  const Json& tolerance = root["tolerance"];
  const bool relative = tolerance.contains("relative");
  scene.tolerance = {relative ? choice::Metric::relative : choice::Metric::delta_e,
                     tolerance[relative ? "relative" : "delta_e"].get<double>()};
  if (root.contains("target")) scene.target = choice::target_of(root["target"].get<std::string>());
  if (root.contains("budget")) scene.budget = root["budget"].get<double>();
  return scene;
}

} // namespace brdfplot::config
