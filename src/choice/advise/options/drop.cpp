#include "choice/advise/options/drop.hpp"

#include <algorithm>

namespace brdfplot::choice {

namespace {

bool is_coat(const TermDescription& term, const MaterialDescription& material) {
  return std::ranges::any_of(material.terms, [&](const TermDescription& other) {
    return std::ranges::any_of(other.layers, [&](const LayerDescription& layer) { return layer.coat == term.name; });
  });
}

bool drop(Draft& draft, const std::string& name) {
  if (draft.find(name) == nullptr || is_coat(*draft.find(name), draft.material)) return false;
  draft.remove([&](const TermDescription& term) { return term.name == name; });
  if (draft.material.terms.empty()) return false;
  free_colours(draft);
  return true;
}

} // namespace

void free_colours(Draft& draft) {
  for (const TermDescription& term : draft.material.terms)
    for (const char* key : {"albedo", "color"})
      if (term.values.has(key) && term.type != "disney_sheen") draft.set_free(term.name, key);
}

std::vector<Option> FewerTerms::of(const MaterialDescription& material) {
  std::vector<Option> out;
  if (material.terms.size() < 2) return out;
  for (const TermDescription& term : material.terms) {
    if (is_coat(term, material)) continue;
    const std::string name = term.name;
    const bool bounces = term.type == "multiple_bounce" || term.type == "turquin";
    const std::string part = bounces ? "multiple bounce" : "term " + name;
    out.push_back({part, {{part + ": left out", [name](Draft& draft) { return drop(draft, name); }}}});
  }
  return out;
}

} // namespace brdfplot::choice
