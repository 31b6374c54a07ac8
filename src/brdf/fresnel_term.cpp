#include "brdf/fresnel_term.hpp"

#include <vector>

namespace brdfplot {

const WeightedTerm& term_with_fresnel(const Material& material, const std::string& name) {
  std::vector<const WeightedTerm*> with_surface, all;
  std::string names;
  for (const WeightedTerm& term : material.terms) {
    if (term.fresnel() == nullptr || term.facets() == nullptr) continue;
    names += (names.empty() ? "" : ", ") + term.name;
    if (!name.empty() && term.name != name) continue;
    all.push_back(&term);
    if (term.surface() != nullptr) with_surface.push_back(&term);
  }
  if (with_surface.size() == 1) return *with_surface[0];
  if (all.size() == 1) return *all[0];
  if (names.empty()) throw InputError(material.name, "none of its terms has facets with a Fresnel term");
  if (name.empty())
    throw InputError(material.name, "several terms have a Fresnel term; accepted: TERM. before the name, of " + names);
  throw InputError(material.name, "no term \"" + name + "\" with a Fresnel term; accepted: " + names);
}

} // namespace brdfplot
