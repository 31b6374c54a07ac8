/// \file
/// Walter's rational fit of Smith's masking function for Beckmann.
#pragma once

#include "microfacet/slopes.hpp"

namespace brdfplot {

/// The fit of Beckmann's Lambda, whatever the distribution is, at its (equivalent) roughness:
/// a Lambda = (1 - 1.259 a + 0.396 a^2) / (3.535 + 2.181 a) for a < 1.6, else 0. Relative error of G1 <= 0.313 %, of
/// Lambda itself 4.6 % for a < 1 and over 100 % near a = 1.6, where it is negative (to -6e-5).
struct SmithRational {
  static ModelSpec spec() {
    return {.type = "smith_rational",
            .doc = "rational fit of Beckmann's Lambda, used with any distribution",
            .source = "Walter et al. 2007; Heitz 2014, section 5.3; Akenine-Moller et al. 2018, Eq. 9.39"};
  }
  static SmithRational from(const Values&) { return {}; }
  static constexpr bool has_lambda = true;
  static constexpr double end = 1.6; ///< a from which on Lambda is 0
  /// Changes its sign there (see masking.hpp).
  static double kink(const Projection& p) { return p.c - end * p.s; }

  /// c Lambda over arrays.
  template <class D>
  void masked_areas(const D&, const double* c, const double* s, double* t, std::size_t n) const {
    kernels::masked_area_beckmann_walter(c, s, t, n);
  }
};

} // namespace brdfplot
