/// \file
/// The largest errors that the accuracy tests allow, in units in the last place (ulp) of the exact result: the one
/// place where they stand, a constant for each function. A subnormal result is measured in units of the smallest
/// subnormal number.
#pragma once

namespace brdfplot::accuracy {

struct Bound {
  double ulp;
  /// Of distributions and BRDFs that contain exp(-E), E the squared norm of the slope: a relative change of 2^-53 of
  /// the direction's components or of the roughness, such as their own rounding, changes the result by up to 4 E units
  /// of 2^-53. That much and no more is granted on top: the bound is ulp + per_exponent E.
  double per_exponent = 0;
};

namespace bounds {

// Scalar functions, src/microfacet.
inline constexpr Bound scalar_lambda_beckmann{4};
inline constexpr Bound scalar_a_lambda_beckmann{4};
inline constexpr Bound scalar_a_lambda_ggx{4};
inline constexpr Bound scalar_sigma_beckmann{4};
inline constexpr Bound scalar_sigma_ggx{4};

// Kernels, double.
inline constexpr Bound projected_area{4};
inline constexpr Bound projected_roughness{4};
inline constexpr Bound lambda_beckmann{8};
inline constexpr Bound lambda_ggx{4};
inline constexpr Bound masked_area_beckmann{8};
inline constexpr Bound masked_area_ggx{4};
inline constexpr Bound sigma_beckmann{8};
inline constexpr Bound sigma_ggx{4};
inline constexpr Bound g1_beckmann{8};
inline constexpr Bound g1_ggx{8};
inline constexpr Bound d_beckmann{16, 8};
inline constexpr Bound d_ggx{16};
inline constexpr Bound brdf_beckmann{16, 8};
inline constexpr Bound brdf_ggx{16};
inline constexpr Bound schlick{8};
inline constexpr Bound dielectric{8};
inline constexpr Bound conductor{8};

// Evaluation of materials, src/brdf, double.
inline constexpr Bound p22_beckmann{16, 8};
inline constexpr Bound p22_ggx{16};
inline constexpr Bound d_visible_beckmann{16, 8};
inline constexpr Bound d_visible_ggx{16};
inline constexpr Bound g1_of_directions{8};
inline constexpr Bound g2{8};
/// With the factor 1 - exp(-E), E = 7.3 phi^2, of Ashikhmin et al.: its complement has an exponent of its own.
inline constexpr Bound g2_ashikhmin{8, 8};
inline constexpr Bound brdf_ggx_ashikhmin{16, 8};

// Kernels, float. Densities and BRDFs are computed in double and rounded once.
inline constexpr Bound float_projected_area{4};
inline constexpr Bound float_projected_roughness{4};
inline constexpr Bound float_lambda_beckmann{8};
inline constexpr Bound float_lambda_ggx{4};
inline constexpr Bound float_masked_area_beckmann{8};
inline constexpr Bound float_masked_area_ggx{4};
inline constexpr Bound float_sigma_beckmann{8};
inline constexpr Bound float_sigma_ggx{4};
inline constexpr Bound float_g1_beckmann{8};
inline constexpr Bound float_g1_ggx{8};
inline constexpr Bound float_d{1};
inline constexpr Bound float_brdf{1};

/// Walter's fit against its own formula. It has a root at a = 1.5475...: the error is in units of the largest of the
/// terms that cancel there.
inline constexpr Bound walter{8};

} // namespace bounds

} // namespace brdfplot::accuracy
