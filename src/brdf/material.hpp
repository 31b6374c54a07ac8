/// \file
/// A material: a distribution of normals, a masking function, the joint masking-shadowing and a Fresnel term.
#pragma once

#include "math/errors.hpp"
#include "microfacet/distributions.hpp"
#include "microfacet/fresnel.hpp"
#include "microfacet/masking.hpp"
#include "microfacet/shadowing.hpp"

#include <optional>
#include <string>
#include <vector>

namespace brdfplot {

/// How a facet reflects.
enum class Facet {
  specular,               ///< a mirror (Heitz 2014, Eq. 29)
  diffuse,                ///< Lambertian with albedo 1 (Eq. 31); see diffuse.hpp
  oren_nayar,             ///< as diffuse, in V-cavities, by the full fit of Oren and Nayar 1994; see oren_nayar.hpp
  oren_nayar_direct,      ///< by its part for single scattering
  oren_nayar_qualitative, ///< by their simpler fit
};

/// Whether the BRDF is a published fit, which uses no microsurface.
constexpr bool is_fit(Facet facet) { return facet != Facet::specular && facet != Facet::diffuse; }

/// The names of `Facet`, in its order.
const std::vector<std::string>& facet_names();

/// A material as data: names and parameters, not yet checked. Figures sweep its parameters.
struct MaterialDescription {
  std::string name;
  ModelChoice distribution;
  ModelChoice masking{.type = "smith"};
  std::optional<ModelChoice> shadowing; ///< none given: default_shadowing of the masking function
  ModelChoice fresnel{.type = "none"};
  std::string facet = "specular";
  std::vector<std::string> claims{}; ///< properties that it is said to have (see analysis/properties.hpp)
};

/// A material that can be evaluated (see evaluate.hpp).
struct Material {
  std::string name;
  Distribution distribution;
  Masking masking;
  Shadowing shadowing;
  Fresnel fresnel;
  Facet facet = Facet::specular;

  /// 3 when the Fresnel term is given per channel, else 1.
  int channels() const;
  /// Whether masking is written with a Lambda, independent of the normal.
  bool has_lambda() const;
  const SlopeMap& slopes() const;
};

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

/// Builds a material. Shadowing defaults to `height_correlated` where the masking function has a Lambda, to `minimum`
/// for `v_cavity`, and to `separable` for those that are defined by a product (Heitz 2014, Eqs. 55, 58). A diffuse
/// facet has no Fresnel term; the fits of Oren and Nayar are for the V-cavities of the distribution `oren_nayar` alone.
/// \throws MaterialError
Material build(const MaterialDescription& description);

/// Sets the parameter `key` wherever the description's models have it: distribution, masking, shadowing, fresnel in
/// this order; the first that has it counts. Other keys of an alternative group are dropped ("alpha" replaces
/// "exponent"). \throws MaterialError when none has it.
void set_parameter(MaterialDescription& description, const std::string& key, double value);

} // namespace brdfplot
