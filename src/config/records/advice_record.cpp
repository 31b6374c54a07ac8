#include "config/load.hpp"
#include "config/shapes.hpp"

#include <nlohmann/json.hpp>

namespace brdfplot::config {

namespace {

Json errors_json(const choice::PictureErrors& errors) {
  return {{"error", errors.decisive()}, {"p95", errors.p95}, {"worst", errors.worst}, {"light", errors.energy}};
}

Json model_json(const choice::MaterialAdvice& advice, const std::optional<std::size_t>& k) {
  if (!k) return nullptr;
  const choice::Model& model = advice.models[*k];
  Json out = {
      {"cost", model.cost}, {"model", choice::simplifications(advice, model)}, {"at", errors_json(model.errors)}};
  if (model.dense) out["verified"] = errors_json(*model.dense);
  return out;
}

Json examined_json(const choice::Examination& of) {
  Json out = Json::object();
  if (of.single) out["single"] = errors_json(*of.single);
  if (of.finer)
    out["finer_directions"] = {
        {"directions", of.finer->directions}, {"answer", of.finer->answer}, {"next_cheaper", of.finer->next_cheaper}};
  for (const choice::Break& at : of.breaks)
    out["breaks"].push_back({{"alpha_factor", at.alpha_factor},
                             {"difference", at.difference},
                             {"theta_o", at.theta_o},
                             {"theta_i", at.theta_i},
                             {"azimuth", at.azimuth}});
  if (of.walk)
    out["walk"] = {{"places", of.walk->places},
                   {"light", of.walk->light.value},
                   {"light_standard_error", of.walk->light.standard_error},
                   {"largest", of.walk->largest.value},
                   {"largest_standard_error", of.walk->largest.standard_error}};
  return out;
}

} // namespace

std::string advice_record(const choice::AdviceScene& scene, const std::vector<choice::MaterialAdvice>& all) {
  Json materials = Json::array();
  for (const choice::MaterialAdvice& one : all) {
    Json out = {{"name", one.name},
                {"models", one.models.size()},
                {"places", one.places},
                {"dense_places", one.dense_places},
                {"within", one.within_budget(scene)},
                {"full", model_json(one, one.full)},
                {"answer", model_json(one, one.answer)},
                {"next_cheaper", model_json(one, one.next_cheaper)},
                {"best_cheaper", model_json(one, one.best_cheaper)},
                {"best_in_budget", model_json(one, one.best_in_budget)}};
    if (one.examined) out["examined"] = examined_json(*one.examined);
    if (one.answer) out["material"] = Json::parse(material_text(one.models[*one.answer].materials[0]));
    materials.push_back(std::move(out));
  }
  Json out = {{"scene", scene.name},
              {"metric", scene.tolerance.metric == choice::Metric::delta_e ? "delta_e" : "relative"},
              {"tolerance", scene.tolerance.value},
              {"target", choice::target_names()[static_cast<std::size_t>(scene.target)]},
              {"cost_unit", choice::cost_unit(scene.target)}};
  if (scene.budget) out["budget"] = *scene.budget;
  out["materials"] = std::move(materials);
  return out.dump(2) + "\n";
}

} // namespace brdfplot::config
