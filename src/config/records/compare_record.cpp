#include "config/load.hpp"
#include "config/shapes.hpp"

#include <nlohmann/json.hpp>

namespace brdfplot::config {

namespace {

Json direction_json(const Direction& d) { return Json::array({d.x, d.y, d.z}); }

Json pair_json(const choice::DifferentPair& pair) {
  return {{"omega_o", direction_json(pair.omega_o)},
          {"omega_i", direction_json(pair.omega_i)},
          {"channel", std::string(1, "rgb"[pair.channel])},
          {"a", pair.a},
          {"b", pair.b}};
}

} // namespace

std::string comparison_record(const std::string& a, const std::vector<choice::MaterialDifference>& all,
                              const std::vector<MaterialDescription>& refitted) {
  Json materials = Json::array();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const choice::MaterialDifference& one = all[k];
    Json albedo = Json::array();
    for (const auto& pair : one.albedo) albedo.push_back({{"theta_o", pair.theta_o}, {"a", pair.a}, {"b", pair.b}});
    Json out = {{"name", one.name},
                {"largest", pair_json(one.largest)},
                {"relative", one.relative},
                {"largest_relative", pair_json(one.largest_relative)},
                {"rms", {{"value", one.rms}, {"standard_error", one.rms_error}}},
                {"light", {{"value", one.light}, {"standard_error", one.light_error}}},
                {"delta_e", {{"p95", one.sphere.p95}, {"worst", one.sphere.worst}, {"light", one.sphere.energy}}},
                {"albedo", std::move(albedo)}};
    if (!refitted.empty()) out["material"] = Json::parse(material_text(refitted[k]));
    materials.push_back(std::move(out));
  }
  return Json{{"a", a}, {"materials", std::move(materials)}}.dump(2) + "\n";
}

} // namespace brdfplot::config
