/// \file
/// The list of simplifications. A new one is one file here and one line in the list. They are made in its order; what
/// would change a term that is gone is no model of its own.
#pragma once

#include "choice/advise/options/anisotropy.hpp"
#include "choice/advise/options/coat.hpp"
#include "choice/advise/options/diffuse.hpp"
#include "choice/advise/options/distribution.hpp"
#include "choice/advise/options/drop.hpp"
#include "choice/advise/options/fresnel.hpp"
#include "choice/advise/options/numbers.hpp"
#include "choice/advise/options/visibility.hpp"

namespace brdfplot::choice {

template <class... Simplification>
std::vector<Option> options_by(const MaterialDescription& material) {
  std::vector<Option> out;
  const auto add = [&](const std::vector<Option>& more) { out.insert(out.end(), more.begin(), more.end()); };
  (add(Simplification::of(material)), ...);
  return out;
}

/// All that a material in canonical form has on a target.
inline std::vector<Option> options_of(const MaterialDescription& material, Target target) {
  std::vector<Option> out = options_by<FlatterDiffuse,    //
                                       LighterCoat,       //
                                       FewerTerms,        //
                                       SingleLobe,        //
                                       Level,             //
                                       Rounder,           //
                                       CheaperVisibility, //
                                       SimplerFresnel>(material);
  if (can_go_single(target)) out.push_back(SingleNumbers::of());
  return out;
}

} // namespace brdfplot::choice
