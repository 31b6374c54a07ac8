/// \file
/// A microsurface: where Lambda, P22, D, G1, G2 and the distribution of visible normals live. It does not know how its
/// facets reflect; a term of a BRDF does (brdf/term.hpp).
#pragma once

#include "base/errors.hpp"
#include "microfacet/distributions.hpp"
#include "microfacet/masking.hpp"
#include "microfacet/shadowing.hpp"
#include "models/registry.hpp"

#include <optional>
#include <string>

namespace brdfplot {

/// What is wrong with a material, at a JSON pointer within it ("/distribution/alpha").
class MaterialError : public InputError {
public:
  MaterialError(std::string pointer, std::string what)
      : InputError("material: " + pointer, what), pointer_(std::move(pointer)), what_(std::move(what)) {}
  const std::string& pointer() const { return pointer_; }
  const std::string& reason() const { return what_; }

private:
  std::string pointer_;
  std::string what_;
};

/// Names and parameters of a microsurface, not yet checked.
struct MicrosurfaceDescription {
  ModelChoice distribution;
  ModelChoice masking{.type = "smith"};
  std::optional<ModelChoice> shadowing; ///< none given: default_shadowing of the masking function
};

struct Microsurface {
  Distribution distribution;
  Masking masking;
  Shadowing shadowing;

  /// Whether masking is written with a Lambda, independent of the normal.
  bool has_lambda() const;
  const SlopeMap& slopes() const;
};

/// Whether the slopes of a distribution, or of one of its parts, have an infinite mean, so that Lambda has none.
bool has_infinite_mean_slope(const Distribution& distribution);

/// Builds the model that `choice` names; `section` is its JSON key, for errors. \throws MaterialError
template <class List>
List make_or_throw(const std::string& section, const ModelChoice& choice) {
  auto made = make_model<List>(choice);
  if (const auto* error = std::get_if<ParameterError>(&made))
    throw MaterialError("/" + section + (error->key.empty() ? "" : "/" + error->key), error->what);
  return std::get<List>(std::move(made));
}

/// Shadowing defaults to `height_correlated` where the masking function has a Lambda, to `minimum` for `v_cavity`, and
/// to `separable` for those that are defined by a product (Heitz 2014, Eqs. 55, 58). \throws MaterialError
Microsurface build_microsurface(const MicrosurfaceDescription& description);

} // namespace brdfplot
