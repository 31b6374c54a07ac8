/// \file
/// A term as single precision computes it.
#pragma once

#include "brdf/term.hpp"
#include "choice/advise/shader/mirror_forms.hpp"

#include <array>
#include <optional>

namespace brdfplot::choice {

/// Whether SingleForm can tell what becomes of a term: of mirror facets, whose formulas cancel at small roughness,
/// those with GGX, Beckmann, Student's t, the sheen or a mixture of them; of other terms all but measured ones.
bool has_single_form(const TermDescription& term);

/// What a term is in single precision, of what it is in double. The directions are rounded; D, G2 / (c_o c_i) and F of
/// mirror facets are computed by the shader's formulas in floats and in doubles, and their ratio is the factor. What
/// has no cancelling formula (tables, flat terms, what coats take) is rounded once.
class SingleForm {
public:
  explicit SingleForm(const TermDescription& term);

  /// `values` are those of each channel at a pair of directions in the frame of the surface.
  void round(const Direction& o, const Direction& i, std::array<double, 3>& values) const;

private:
  template <class T>
  struct Constants {
    forms::Lobe<T> lobe;
    std::array<std::array<T, 3>, 3> fresnel{}; ///< of each channel
  };
  template <class T>
  static Constants<T> constants_of(const TermDescription& term);
  template <class T>
  std::array<T, 3> reflected(const Constants<T>& constants, const Direction& o, const Direction& i) const;

  TermDescription term_;
  bool facets_ = false, table_ = false; ///< whether it has facets; whether their Lambda is a table
  Constants<double> full_;
  Constants<float> single_;
};

} // namespace brdfplot::choice
