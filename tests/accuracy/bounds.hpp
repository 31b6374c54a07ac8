/// \file
/// The largest errors that the accuracy tests allow, in units in the last place (ulp) of the exact result: the one
/// place where they stand. A subnormal result is measured in units of the smallest subnormal number.
#pragma once

namespace brdfplot::accuracy {

struct Bound {
  double ulp;
  /// Of distributions and BRDFs that contain exp(-E), E the squared norm of the slope: a relative change of 2^-53 of
  /// the direction's components or of the roughness, such as their own rounding, changes the result by up to 4 E units
  /// of 2^-53. That much and no more is granted on top: the bound is ulp + per_exponent E.
  double per_exponent = 0;
};

// Scalar functions, src/microfacet.
inline constexpr Bound scalar_lambda{4};
inline constexpr Bound fresnel{8};

// Kernels, double.
inline constexpr Bound projection{4};
inline constexpr Bound lambda{8};
inline constexpr Bound masked_area{8};
inline constexpr Bound sigma{8};
inline constexpr Bound g1{8};
inline constexpr Bound density{16};
inline constexpr Bound density_beckmann{16, 8};
inline constexpr Bound brdf{16};
inline constexpr Bound brdf_beckmann{16, 8};

// Kernels, float. Densities and BRDFs are computed in double and rounded once.
inline constexpr Bound float_projection{4};
inline constexpr Bound float_masking{8};
inline constexpr Bound float_density{1};
inline constexpr Bound float_brdf{1};

/// Walter's fit against its own formula. It has a root at a = 1.5475...: the error is in units of the largest of the
/// terms that cancel there.
inline constexpr Bound walter{8};

} // namespace brdfplot::accuracy
