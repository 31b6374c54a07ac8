/// \file
/// A material that is being made simpler.
#pragma once

#include "brdf/material.hpp"
#include "choice/advise/target.hpp"

#include <functional>
#include <string>
#include <vector>

namespace brdfplot::choice {

/// A parameter that is fitted anew after a simplification: of a term by name `alpha` (alpha_x and alpha_y by one
/// factor), `weight`, a Fresnel term's `f0`, or a colour of its own (`albedo`, `color`).
struct FreeParameter {
  std::string term;
  std::string key;
  friend bool operator==(const FreeParameter&, const FreeParameter&) = default;
};

struct Draft {
  MaterialDescription material;
  std::vector<FreeParameter> free{};
  Precision precision = Precision::full; ///< that it is computed in

  TermDescription* find(const std::string& term);
  /// Adds it unless it is there.
  void set_free(const std::string& term, const std::string& key);
  /// Takes out terms, and what is made of them.
  void remove(const std::function<bool(const TermDescription&)>& which);
};

/// One level of a simplification, from the one before it or from the material in full.
struct Step {
  std::string label; ///< "F of coat: Schlick (was dielectric)"
  /// Makes the change, or returns false where there is nothing to change.
  std::function<bool(Draft&)> apply;
};

/// A simplification of one part of a material: level 0 is as given, level k is steps[k - 1].
struct Option {
  std::string name; ///< "F of coat"
  std::vector<Step> steps;
};

/// The same material with every term named, and roughness as alpha, or alpha_x and alpha_y.
MaterialDescription canonical(MaterialDescription material);

/// A text that is the same for equal descriptions alone.
std::string identity_of(const TermDescription& term);
std::string identity_of(const MaterialDescription& material);
std::string identity_of(const Draft& draft);

} // namespace brdfplot::choice
