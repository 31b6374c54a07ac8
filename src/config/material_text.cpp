#include "config/load.hpp"
#include "config/shapes.hpp"

#include <filesystem>

namespace brdfplot::config {

namespace {

Json to_json(const ModelChoice& choice);

Json to_json(const Value& value) {
  return std::visit(
      []<class T>(const T& v) -> Json {
        if constexpr (std::is_same_v<T, WeightedChoices>) {
          Json out = Json::array();
          for (const WeightedChoice& one : v)
            out.push_back({{"weight", one.weight}, {"distribution", to_json(one.model)}});
          return out;
        } else {
          return v;
        }
      },
      value);
}

void append(Json& out, const Values& values) {
  for (const auto& [key, value] : values.map()) out[key] = to_json(value);
}

Json to_json(const ModelChoice& choice) {
  Json out = {{"type", choice.type}};
  append(out, choice.values);
  return out;
}

bool is_one(const Value& weight) { return std::holds_alternative<double>(weight) && std::get<double>(weight) == 1; }

/// A term without the coated terms that it is part of.
Json to_json(const TermDescription& term) {
  Json out = Json::object();
  if (!term.name.empty() && term.name != term.type) out["name"] = term.name;
  out["type"] = term.type;
  if (!is_one(term.weight)) out["weight"] = to_json(term.weight);
  if (!term.distribution.type.empty()) {
    out["distribution"] = to_json(term.distribution);
    if (term.masking.type != "smith" || !term.masking.values.map().empty()) out["masking"] = to_json(term.masking);
    if (term.shadowing) out["shadowing"] = to_json(*term.shadowing);
  }
  if (term.fresnel.type != "none") out["fresnel"] = to_json(term.fresnel);
  if (!term.of_name.empty()) out["of"] = term.of_name;
  if (term.of_name.empty() && !term.of.empty()) out["of"] = to_json(term.of[0]);
  append(out, term.values);
  // Paths are relative to the file that names them, and this one may stand anywhere.
  if (out.contains("file")) out["file"] = std::filesystem::absolute(term.values.text("file")).string();
  return out;
}

/// The terms from `k` on that are beneath the same `depth` coats, each coated term as one; `k` then stands behind them.
Json terms_from(const std::vector<TermDescription>& terms, std::size_t& k, std::size_t depth) {
  Json out = Json::array();
  const std::size_t first = k;
  const auto group = [&](std::size_t at) { return depth == 0 ? std::string() : terms[at].layers[depth - 1].name; };
  const std::string own = group(first);
  while (k < terms.size() && terms[k].layers.size() >= depth && group(k) == own) {
    if (terms[k].layers.size() == depth) {
      out.push_back(to_json(terms[k++]));
      continue;
    }
    const LayerDescription& layer = terms[k].layers[depth];
    Json coated = {{"name", layer.name}, {"type", "coated"}};
    if (!is_one(layer.weight)) coated["weight"] = to_json(layer.weight);
    coated["coat"] = to_json(terms[k++]); // a coat stands before its base
    coated["base"] = terms_from(terms, k, depth + 1);
    append(coated, layer.values);
    out.push_back(std::move(coated));
  }
  return out;
}

} // namespace

std::string material_text(const MaterialDescription& material) {
  std::size_t k = 0;
  return Json{{"name", material.name}, {"terms", terms_from(material.terms, k, 0)}}.dump(2) + "\n";
}

} // namespace brdfplot::config
