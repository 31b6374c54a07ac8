#include "choice/advise/ladder.hpp"

#include "base/errors.hpp"
#include "choice/advise/options/options.hpp"
#include "choice/advise/single.hpp"

#include <algorithm>
#include <set>

namespace brdfplot::choice {

std::vector<MaterialDescription> variants_of(const AdvisedMaterial& material) {
  std::vector<MaterialDescription> out = {material.material};
  for (const auto& [key, values] : material.ranges)
    for (const double value : values) {
      MaterialDescription one = material.material;
      set_parameter(one, key, value);
      build(one);
      out.push_back(std::move(one));
    }
  return out;
}

namespace {

/// The next combination of levels, the last option fastest; false after the last one.
bool advance(std::vector<std::size_t>& levels, const std::vector<Option>& options) {
  for (std::size_t k = levels.size(); k-- > 0;) {
    if (++levels[k] <= options[k].steps.size()) return true;
    levels[k] = 0;
  }
  return false;
}

bool simplify(Draft& draft, const std::vector<Option>& options, const std::vector<std::size_t>& levels) {
  for (std::size_t k = 0; k < options.size(); ++k)
    if (levels[k] > 0 && !options[k].steps[levels[k] - 1].apply(draft)) return false;
  return true;
}

/// Some combinations are no material, such as a tint under a coat without an index of refraction.
bool can_be_built(const MaterialDescription& material) {
  try {
    build(material);
    return true;
  } catch (const MaterialError&) {
    return false;
  }
}

/// Terms of whose albedo a table is made keep their roughness: each other one would be another table.
void keep_tabulated_roughness(Draft& draft) {
  std::set<std::string> tabulated;
  for (const TermDescription& term : draft.material.terms) {
    if (!term.of_name.empty()) tabulated.insert(term.of_name);
    for (const LayerDescription& layer : term.layers)
      if (layer.values.has("attenuation") && layer.values.text("attenuation") == "albedo") tabulated.insert(layer.coat);
  }
  std::erase_if(draft.free,
                [&](const FreeParameter& one) { return one.key == "alpha" && tabulated.contains(one.term); });
}

std::vector<Draft> drafts_of(const Ladder& ladder, const std::vector<std::size_t>& levels, Precision precision) {
  std::vector<Draft> out;
  for (const MaterialDescription& variant : ladder.variants) {
    Draft draft{variant, {}, precision};
    if (!simplify(draft, ladder.options, levels) || !can_be_built(draft.material)) return {};
    keep_tabulated_roughness(draft);
    out.push_back(std::move(draft));
  }
  return out;
}

void require_few(std::size_t found, std::size_t most, const std::string& of, const AdvisedMaterial& material) {
  if (found > most)
    throw InputError(material.place, "its simplifications make " + std::to_string(found) + " " + of +
                                         "; accepted: at most " + std::to_string(most));
}

void require_single_forms(const MaterialDescription& full, const AdvisedMaterial& material) {
  for (const TermDescription& term : full.terms)
    if (!has_single_form(term))
      throw InputError(material.place,
                       "the term \"" + term.name +
                           "\" has no form in single precision; accepted: the target shader, double or double_simd");
}

void add_light_models(Ladder& ladder, const std::vector<AdviceLight>& lights) {
  const bool discs = std::ranges::any_of(lights, [](const AdviceLight& light) { return light.radius > 0; });
  const auto add = [&](const LightModel& model, const std::string& label) {
    ladder.lights.push_back(model);
    ladder.light_labels.push_back(label);
  };
  for (const std::size_t rings : std::initializer_list<std::size_t>{8, 4, 2, 1})
    if (discs)
      add({LightModel::Kind::points, rings}, "discs of light by " + std::to_string(4 * rings * rings) + " directions");
  if (discs) add({LightModel::Kind::nearest, 0}, "discs of light by the nearest direction (Karis 2013)");
  add({LightModel::Kind::punctual, 0}, discs ? "discs of light as punctual" : "punctual lights");
}

} // namespace

Ladder ladder_of(const AdvisedMaterial& material, const std::vector<AdviceLight>& lights, Target target) {
  Ladder ladder;
  for (const MaterialDescription& variant : variants_of(material)) ladder.variants.push_back(canonical(variant));
  ladder.options = options_of(ladder.variants[0], target);
  if (precision_of(target) == Precision::single) require_single_forms(ladder.variants[0], material);
  add_light_models(ladder, lights);
  std::size_t combinations = 1;
  for (const Option& option : ladder.options) {
    combinations *= option.steps.size() + 1;
    require_few(combinations, most_combinations, "combinations", material);
  }
  std::set<std::string> known;
  std::vector<std::size_t> levels(ladder.options.size());
  do {
    std::vector<Draft> drafts = drafts_of(ladder, levels, precision_of(target));
    if (drafts.empty() || !known.insert(identity_of(drafts[0])).second) continue;
    ladder.rungs.push_back({levels, std::move(drafts)});
  } while (advance(levels, ladder.options));
  require_few(ladder.rungs.size() * ladder.lights.size(), most_models, "models", material);
  return ladder;
}

} // namespace brdfplot::choice
