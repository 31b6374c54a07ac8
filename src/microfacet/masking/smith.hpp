/// \file
/// Smith's masking function (Heitz 2014, Eqs. 43, 69, 72).
#pragma once

#include "microfacet/distributions/beckmann.hpp"
#include "microfacet/distributions/ggx.hpp"

#include <string>

namespace brdfplot {

/// G1 = 1 / (1 + Lambda), exact; Lambda of the distribution itself or, as Walter et al. 2007 suggest for Phong, of
/// another shape at about the same roughness.
struct Smith {
  enum class LambdaOf { itself, beckmann, ggx } lambda_of = LambdaOf::itself;

  static ModelSpec spec() {
    return {.type = "smith",
            .doc = "exact for heights independent of normals",
            .source = "Smith 1967; Heitz 2014, Eqs. 38-43; Akenine-Moller et al. 2018, Eqs. 9.24-9.25",
            .parameters = {{.key = "lambda_of",
                            .kind = ParameterKind::choice,
                            .fallback = std::string("itself"),
                            .doc = "whose Lambda to use; other than `itself` it is an approximation",
                            .choices = {"itself", "beckmann", "ggx"}}}};
  }
  static Smith from(const Values& values) {
    const std::string name = values.text("lambda_of");
    return {name == "beckmann" ? LambdaOf::beckmann : name == "ggx" ? LambdaOf::ggx : LambdaOf::itself};
  }
  static constexpr bool has_lambda = true;
  bool takes_lambda_of_distribution() const { return lambda_of == LambdaOf::itself; }

  /// c Lambda over arrays.
  template <class D>
  void masked_areas(const D& distribution, const double* c, const double* s, double* t, std::size_t n) const {
    switch (lambda_of) {
    case LambdaOf::itself: return distribution.masked_areas(c, s, t, n);
    case LambdaOf::beckmann: return BeckmannShape::masked_areas(c, s, t, n);
    case LambdaOf::ggx: return GgxShape::masked_areas(c, s, t, n);
    }
  }
};

} // namespace brdfplot
