/// \file
/// A material: a sum of weighted terms.
#pragma once

#include "brdf/coat.hpp"
#include "brdf/terms.hpp"

#include <string>
#include <vector>

namespace brdfplot {

/// A material as data: names and parameters, not yet checked. Figures sweep its parameters.
struct MaterialDescription {
  MaterialDescription() = default;
  MaterialDescription(std::string of_name, std::vector<TermDescription> of_terms, bool as_list)
      : name(std::move(of_name)), terms(std::move(of_terms)), listed(as_list) {}
  /// A material of one term, which gives it its name.
  MaterialDescription(const TermDescription& term) : name(term.name), terms{term} {} // NOLINT(*-explicit-*)

  std::string name;
  std::vector<TermDescription> terms;
  bool listed = false;             ///< written as a list "terms", which places of errors then name
  std::vector<std::string> claims; ///< properties that it is said to have (see analysis/properties.hpp)
};

/// A term and what it is multiplied by.
struct WeightedTerm {
  std::string name;
  Colour weight;
  BrdfTerm term;
  std::vector<Coat> coats{};         ///< what lies over it
  std::vector<std::string> groups{}; ///< the coated terms that it is part of

  int channels() const;
  /// The microsurface that it is derived from; null: none.
  const Microsurface* surface() const;
  const Fresnel* fresnel() const;
  /// The distribution that its half vectors follow; null: none.
  const Distribution* facets() const;
  /// Whether rho is the same for every azimuth of the viewer.
  bool is_isotropic() const;
};

/// \throws MaterialError
WeightedTerm build_term(const TermDescription& description);

/// A material that can be evaluated (see evaluate.hpp). Its terms lie on one mesosurface.
struct Material {
  std::string name;
  std::vector<WeightedTerm> terms;

  /// 3 where a weight, a colour or a Fresnel term is given per channel, else 1.
  int channels() const;
  /// c = z - x mean_x - y mean_y of it is what all terms mean by cos theta.
  const SlopeMap& mesosurface() const;
  /// The term that has a microsurface, or the one of this name. \throws InputError when there is none or are several:
  /// which names may be given.
  const WeightedTerm& term_with_surface(const std::string& term = "") const;
  const Microsurface& surface(const std::string& term = "") const;
};

/// The terms that count: all, the one of this name, or the parts of the coated term of this name. \throws InputError
/// when there is none.
std::vector<const WeightedTerm*> terms_of(const Material& material, const std::string& name);

/// What a list of terms knows of one of its types before one is made.
struct TermSpec {
  ModelSpec spec;
  bool has_distribution = false;
  bool has_surface = false; ///< masking and shadowing beside the distribution
  bool has_fresnel = false;
  bool of_another = false; ///< takes a term, or the name of one beside it, as "of"
  bool of_layers = false;  ///< takes a term as "coat" and a list of them as "base": no term itself, but several
};

/// Of every type of term, in the order of the list.
const std::vector<TermSpec>& term_specs();

/// Builds a material. Names of terms must differ, and their mean slopes be one. \throws MaterialError
Material build(const MaterialDescription& description);

Material build(const TermDescription& term);

/// Where term `index` stands in the JSON of a material.
std::string pointer_of_term(const MaterialDescription& description, std::size_t index);

/// Whether the term is derived from a microsurface.
bool has_surface(const TermDescription& description);

/// The index of the only term that has a microsurface. \throws MaterialError when there is none or are several.
std::size_t term_with_surface(const MaterialDescription& description);

/// Sets the parameter `key` of a term wherever it has it: weight, distribution, masking, shadowing, fresnel and its own
/// in this order; the first that has it counts. Other keys of an alternative group are dropped ("alpha" replaces
/// "exponent"). \throws MaterialError when none has it.
void set_parameter(TermDescription& description, const std::string& key, double value);
/// The same of a material: `key` is "term.parameter", or a parameter alone where there is one term.
void set_parameter(MaterialDescription& description, const std::string& key, double value);

/// All that set_parameter() takes.
std::vector<std::string> parameter_keys(const MaterialDescription& description);

} // namespace brdfplot
