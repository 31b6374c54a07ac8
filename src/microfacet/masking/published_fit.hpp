/// \file
/// Fits of Lambda as their authors printed them, each for one distribution.
#pragma once

#include "microfacet/distributions/isotropic/sheen.hpp"
#include "microfacet/distributions/student_t.hpp"

#include <limits>
#include <type_traits>

namespace brdfplot {

/// What the fits share: build() refuses them beside any other distribution than `Only`.
template <class Fit, class Only>
struct PublishedFit {
  using FitsOnly = Only;
  static constexpr bool has_lambda = true;
  static Fit from(const Values&) { return {}; }

  /// c Lambda over arrays.
  template <class D>
  void masked_areas([[maybe_unused]] const D& distribution, [[maybe_unused]] const double* c,
                    [[maybe_unused]] const double* s, double* t, std::size_t n) const {
    for (std::size_t k = 0; k < n; ++k) {
      if constexpr (std::is_same_v<D, Only>)
        t[k] = Fit::masked_area(distribution, {c[k], s[k]});
      else
        t[k] = std::numeric_limits<double>::quiet_NaN();
    }
  }
};

/// Estevez and Kulla 2017: Lambda = exp L(c) for c < 1/2, else exp(2 L(1/2) - L(1 - c)), c = cos theta, L(x) = a / (1 +
/// b x^c) + d x + e, with parameters interpolated in (1 - r)^2 between r = 0 and r = 1. Without their softened
/// terminator. G1 is off by up to 0.05 for r >= 0.1 and by 0.33 at r = 0.01.
struct SheenFit : PublishedFit<SheenFit, Sheen> {
  static ModelSpec spec();
  static double masked_area(const Sheen& sheen, const Projection& p);
  /// Changes its sign where the second derivative jumps, at c = 1/2 (see masking.hpp).
  static double kink(const Projection& p) { return p.c - 0.5; }
};

/// Ribardiere et al. 2017, Eqs. 22-23, with 2F1 by their rational fits. G1 is off by up to 0.7 %; Lambda falls to
/// -0.0045 for large a. Printed for gamma in (3/2, 40].
struct StudentTFit : PublishedFit<StudentTFit, StudentT> {
  static ModelSpec spec();
  static double masked_area(const StudentT& distribution, const Projection& p);
};

} // namespace brdfplot
