#include "config/load.hpp"
#include "config/model_json.hpp"
#include "config/shapes.hpp"
#include "simulation/surface.hpp"

#include <algorithm>
#include <filesystem>

namespace brdfplot::config {

namespace {

ShapePtr angles() { return either({angle(), array(angle(), 1, 1000)}); }

ShapePtr measure_shape(const simulation::MeasureSpec& spec) {
  std::vector<Field> fields = {
      {"type", text(), true, spec.doc},
      {"id", file_stem(), false, "names its table and files; default: the type"},
      {"theta_o", angles(), true, "angles of the viewer, below 90 degrees"},
      {"phi_o", angles(), false, "azimuths of the viewer; default 0"},
      {"rays", number({.min = 64, .max = 1e12}), false, "points or paths for every direction; default 1e6"}};
  const std::vector<Field> more = {
      {"theta_i", angles(), false, "angles of the light; default: those of the viewer"},
      {"delta_phi", angles(), true, "azimuths between viewer and light"},
      {"bins", whole_number(2, 720), false, "bins over a half circle, or rings of the hemisphere"},
      {"bounces", whole_number(1, 1000), false, "most bounces of a path; default 32"}};
  for (const Field& field : more)
    if (std::ranges::find(spec.keys, field.key) != spec.keys.end()) fields.push_back(field);
  return object(std::move(fields));
}

ShapePtr measure_shape() {
  return named("measure", [] {
    std::vector<std::pair<std::string, ShapePtr>> types;
    for (const auto& spec : simulation::measure_specs()) types.emplace_back(spec.type, measure_shape(spec));
    return tagged(std::move(types));
  });
}

std::vector<double> to_angles(const Json& value, const std::string& key, std::vector<double> otherwise) {
  if (!value.contains(key)) return otherwise;
  const Json& angles = value[key];
  if (!angles.is_array()) return {to_number(angles)};
  std::vector<double> out;
  for (const Json& angle : angles) out.push_back(to_number(angle));
  return out;
}

simulation::MeasureDescription to_measure(const Json& value) {
  simulation::MeasureDescription measure;
  measure.type = value["type"].get<std::string>();
  measure.id = value.value("id", measure.type);
  measure.theta_o = to_angles(value, "theta_o", {});
  measure.phi_o = to_angles(value, "phi_o", {0});
  measure.theta_i = to_angles(value, "theta_i", {});
  measure.delta_phi = to_angles(value, "delta_phi", {});
  measure.rays = value.value("rays", measure.rays);
  measure.bins = static_cast<int>(value.value("bins", 0.0));
  measure.bounces = static_cast<int>(value.value("bounces", static_cast<double>(measure.bounces)));
  return measure;
}

} // namespace

ShapePtr scene_shape() {
  return object(
      {{"name", text(), false, "what progress calls it; default: the name of the file"},
       {"surface", named("surface", [] { return model(specs_of<simulation::Surface>()); }), true, "what is traced"},
       {"seed", whole_number(0, 2147483647), false, "of the random numbers; default 1"},
       {"realisations", whole_number(1, 100000), false,
        "independent surfaces to average over, whose scatter is the standard error: one has none; default 8"},
       {"measures", array(measure_shape(), 0, 256), true, "what is measured, a table each"}},
      true);
}

simulation::SceneDescription load_scene(const std::string& path) {
  const JsonFile file(path);
  expect_kind(file, "scene");
  static const ShapePtr shape = scene_shape();
  file.check(*shape);
  const Json& root = file.root();
  simulation::SceneDescription scene;
  scene.name = root.value("name", std::filesystem::path(path).stem().string());
  scene.surface = to_choice<simulation::Surface>(root["surface"]);
  if (root["surface"].contains("file")) {
    const std::filesystem::path here = file.file("/surface/file");
    scene.surface.values.set("file", (here.parent_path() / root["surface"]["file"].get<std::string>()).string());
  }
  scene.seed = static_cast<std::uint64_t>(root.value("seed", 1.0));
  scene.realisations = static_cast<int>(root.value("realisations", static_cast<double>(scene.realisations)));
  for (const Json& measure : root["measures"]) scene.measures.push_back(to_measure(measure));
  try {
    check(scene);
  } catch (const simulation::SceneError& error) {
    file.fail(error.pointer(), error.reason());
  }
  return scene;
}

} // namespace brdfplot::config
