#include "simulation/scene.hpp"

#include "base/echo.hpp"
#include "base/hash.hpp"
#include "base/number.hpp"
#include "base/text_files.hpp"
#include "models/registry.hpp"
#include "simulation/measures.hpp"
#include "simulation/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace brdfplot::simulation {

namespace {

const MeasureSpec& spec_of(const MeasureDescription& measure, const std::string& pointer) {
  std::vector<std::string> names;
  for (const MeasureType& type : measure_types()) {
    if (type.spec.type == measure.type) return type.spec;
    names.push_back(type.spec.type);
  }
  throw SceneError(pointer + "/type", unknown_name("type", measure.type, names));
}

void check_angles(const std::vector<double>& angles, double most, const std::string& pointer) {
  for (std::size_t k = 0; k < angles.size(); ++k)
    if (!(std::fabs(angles[k]) <= most && (most > 2 || (angles[k] >= 0 && angles[k] < most))))
      throw SceneError(pointer + "/" + std::to_string(k),
                       "found " + format_number(angles[k]) +
                           ", accepted: " + (most > 2 ? "an angle within a turn of 0" : "an angle in [0, 90deg)"));
}

void check_measure(const MeasureDescription& measure, const std::string& pointer) {
  const MeasureSpec& spec = spec_of(measure, pointer);
  constexpr double quarter = std::numbers::pi / 2, turn = 2 * std::numbers::pi;
  if (measure.theta_o.empty()) throw SceneError(pointer + "/theta_o", "is empty; accepted: at least 1 angle");
  check_angles(measure.theta_o, quarter, pointer + "/theta_o");
  check_angles(measure.theta_i, quarter, pointer + "/theta_i");
  check_angles(measure.phi_o, turn, pointer + "/phi_o");
  check_angles(measure.delta_phi, turn, pointer + "/delta_phi");
  if (std::ranges::find(spec.keys, "delta_phi") != spec.keys.end() && measure.delta_phi.empty())
    throw SceneError(pointer, "\"delta_phi\" is missing: azimuths between omega_o and omega_i; accepted: angles");
}

std::string text_of(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return format_number(*number);
  if (const auto* pair = std::get_if<Vec2>(&value)) return format_number((*pair)[0]) + "," + format_number((*pair)[1]);
  return std::get<std::string>(value);
}

std::string text_of(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ",") + format_number(value);
  return text;
}

Values completed(const ModelChoice& choice) {
  for (const ModelSpec& spec : specs_of<Surface>()) {
    if (spec.type != choice.type) continue;
    auto all = complete(spec, choice.values);
    if (const auto* error = std::get_if<ParameterError>(&all))
      throw SceneError("/surface" + (error->key.empty() ? "" : "/" + error->key), error->what);
    return std::get<Values>(std::move(all));
  }
  throw SceneError("/surface/type", unknown_name("type", choice.type, names_of(specs_of<Surface>())));
}

} // namespace

std::vector<MeasureSpec> measure_specs() {
  std::vector<MeasureSpec> specs;
  for (const MeasureType& type : measure_types()) specs.push_back(type.spec);
  return specs;
}

Surface build_surface(const ModelChoice& choice) {
  completed(choice);
  auto surface = std::get<Surface>(make_model<Surface>(choice));
  if (const auto problem = std::visit([](const auto& s) { return s.problem(); }, surface))
    throw SceneError("/surface/" + problem->key, problem->what);
  return surface;
}

void check(const SceneDescription& scene) {
  build_surface(scene.surface);
  std::set<std::string> ids;
  for (std::size_t k = 0; k < scene.measures.size(); ++k) {
    const std::string pointer = "/measures/" + std::to_string(k);
    check_measure(scene.measures[k], pointer);
    const std::string& id = scene.measures[k].id;
    if (id == "surface") throw SceneError(pointer + "/id", "\"surface\" is the table of the surface");
    if (!ids.insert(id).second)
      throw SceneError(pointer + "/id", "the id \"" + echo(id) + "\" stands twice in this scene");
  }
}

std::string canonical_text(const SceneDescription& scene) {
  check(scene);
  std::string text = "surface " + scene.surface.type;
  const Values values = completed(scene.surface);
  for (const auto& [key, value] : values.map()) {
    if (key == "file") // another path to the same heights gives the same results
      text += " digest=" + std::to_string(hash(read_text_file(std::get<std::string>(value))));
    else
      text += " " + key + "=" + text_of(value);
  }
  text += "\nseed " + std::to_string(scene.seed) + " realisations " + std::to_string(scene.realisations) + "\n";
  for (const MeasureDescription& m : scene.measures)
    text += m.type + " theta_o=" + text_of(m.theta_o) + " phi_o=" + text_of(m.phi_o) +
            " theta_i=" + text_of(m.theta_i) + " delta_phi=" + text_of(m.delta_phi) +
            " half_width=" + format_number(m.half_width) + " bins=" + std::to_string(m.bins) +
            " bounces=" + std::to_string(m.bounces) + " rays=" + format_number(m.rays) + "\n";
  return text;
}

} // namespace brdfplot::simulation
