#include "config/figure/levels.hpp"

#include "base/errors.hpp"
#include "base/threads/interrupt.hpp"
#include "base/warnings.hpp"

#include <algorithm>

namespace brdfplot::config {

void mind_degrees(const JsonFile& file, const std::string& variable, const Json& value, const std::string& pointer) {
  if (value.is_number() && (variable.starts_with("theta_") || variable.starts_with("phi_")))
    warn_of_degrees(file.where(pointer), variable, value.get<double>());
}

std::string worded(const JsonFile& file, const Json& object, const std::string& pointer, const std::string& key,
                   const Scope& scope) {
  std::string text = substituted(object.value(key, ""), scope.words);
  for (const std::string& name : plot::names_in(text)) {
    std::vector<std::string> names;
    for (const auto& [variable, word] : scope.words) names.push_back(variable);
    file.fail(step(pointer, key), unknown_name("variable of for_each", name, names));
  }
  return text;
}

std::vector<Json> loops_of(const Json& object) {
  if (!object.contains("for_each")) return {};
  const Json& loops = object["for_each"];
  return loops.is_array() ? loops.get<std::vector<Json>>() : std::vector<Json>{loops};
}

Levels::Levels(const JsonFile& file) : file_(file) {
  const Json materials = file.root().value("materials", Json::object());
  for (const auto& [name, value] : materials.items())
    materials_.emplace(name, read_material(file, value, step("/materials", name)));
}

void Levels::enter(Scope& scope, const Json& object, const std::string& pointer) const {
  if (object.contains("material")) {
    const Json& value = object["material"];
    if (value.is_object()) {
      scope.material = read_material(file_, value, pointer + "/material");
      scope.material_name = scope.material->name;
    } else {
      scope.material_name = value.get<std::string>();
      std::vector<std::string> names;
      for (const auto& [key, material] : materials_) names.push_back(key);
      const auto found = materials_.find(scope.material_name);
      if (found == materials_.end())
        file_.fail(pointer + "/material", unknown_name("material", scope.material_name, names));
      scope.material = found->second;
    }
  }
  if (object.contains("channel")) {
    const auto channel = object["channel"].get<std::string>();
    scope.each_channel = channel == "rgb";
    if (!scope.each_channel) scope.set({"channel", channel}, step(pointer, "channel"));
  }
  if (!object.contains("at")) return;
  for (const auto& [variable, value] : object["at"].items()) {
    const std::string place = step(pointer + "/at", variable);
    mind_degrees(file_, variable, value, place);
    scope.set(to_setting(variable, value), place);
  }
}

void Levels::for_each(const Json& object, const std::string& pointer, const Scope& scope, const Make& make) const {
  std::vector<Loop> loops;
  const std::vector<Json> all = loops_of(object);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool listed = object["for_each"].is_array();
    loops.push_back({all[k], pointer + "/for_each" + (listed ? "/" + std::to_string(k) : "")});
  }
  nest(loops, 0, scope, {}, make);
}

void Levels::nest(const std::vector<Loop>& loops, std::size_t depth, const Scope& scope, std::optional<double> ramp,
                  const Make& make) const {
  if (depth == loops.size()) return make(scope, ramp);
  const Json& loop = loops[depth].json;
  const std::string& place = loops[depth].place;
  const auto variable = loop["variable"].get<std::string>();
  const Json& values = loop["values"];
  if (loop.contains("labels") && loop["labels"].size() != values.size())
    file_.fail(place + "/labels", "found " + std::to_string(loop["labels"].size()) + " labels for " +
                                      std::to_string(values.size()) + " values, accepted: as many");
  const bool family = loops.size() == 1 && values.size() >= 5 && std::ranges::all_of(values, is_numeric);
  for (std::size_t k = 0; k < values.size(); ++k) {
    throw_if_interrupted();
    const std::string here = place + "/values/" + std::to_string(k);
    Scope inner = scope;
    mind_degrees(file_, variable, values[k], here);
    inner.set(to_setting(variable, values[k]), here);
    inner.words[variable] = loop.contains("labels") ? loop["labels"][k].get<std::string>() : word_for(values[k]);
    nest(loops, depth + 1, inner,
         family ? std::optional(static_cast<double>(k) / static_cast<double>(values.size() - 1)) : ramp, make);
  }
}

} // namespace brdfplot::config
