/// \file
/// Smith masking, microfacet distributions, BRDFs and reflectances over arrays, exact to a stated bound and fast.
///
/// Structure of arrays, float and double (reflectances: double). No allocation, no exceptions, no branch that depends
/// on the data, so that the compiler turns every loop into vector instructions. One source is compiled for several
/// instruction sets; which one runs is chosen at run time. The value of an element depends on that element alone, not
/// on n or on its place in the array: however the work is cut up, the bytes are the same. Between instruction sets the
/// last bits differ, unless said otherwise.
///
/// Output arrays must not overlap input arrays. Inputs must be finite. The parameters of a Stretch are rounded to the
/// type of the arrays first.
///
/// The error bounds stand in tests/accuracy/bounds.hpp, which the tests enforce, for 1e-6 <= alpha_x, alpha_y <= 1e3.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdfplot::kernels {

/// The map of slopes of a shape-invariant distribution (Heitz 2014, sections 5.3 to 5.5).
struct Stretch {
  double alpha_x = 1;
  double alpha_y = 1;
  double correlation = 0; ///< r_xy in (-1, 1)
  double mean_x = 0;      ///< slope of the mesosurface
  double mean_y = 0;
};

/// Vectors as three arrays.
template <class T>
struct Vectors {
  const T* x;
  const T* y;
  const T* z;
};

enum class Distribution { beckmann, ggx };

/// How masking and shadowing depend on each other (Heitz 2014, section 6); the forms are at `brdf`.
enum class Shadowing { none, separable, minimum, height_correlated };

/// \name Projection
/// c = z - x mean_x - y mean_y, the projected area of the mesosurface (Heitz 2014, section 5.5), and
/// s = sqrt((alpha_x x + r alpha_y y)^2 + (1 - r^2) alpha_y^2 y^2), the projected roughness alpha_o sin(theta) (Eq.
/// 97). The sums that cancel (a sheared horizon, |r| near 1) are carried in twice the working precision.
///@{
void project(const Stretch&, Vectors<double> omega, double* c, double* s, std::size_t n);
void project(const Stretch&, Vectors<float> omega, float* c, float* s, std::size_t n);
///@}

/// \name Masked area
/// tau = c Lambda(a), a = c / s: the projected area of the facets that are masked; sigma = c + tau is that of all that
/// face the direction (Heitz 2014, Eq. 41), and G1 = c / (c + tau). Finite everywhere: s / (2 sqrt(pi)) (Beckmann) and
/// s / 2 (GGX) at grazing, 0 for s = 0; subnormal results are right. For c < 0, by Lambda(-a) = -1 - Lambda(a),
/// tau = |c| + tau(|c|). Domain: s = 0 or 2^-1000 <= s <= 2^200 (float: 2^-120, 2^20), |c| < 2^1000 (float: 2^100).
///
/// - beckmann: Heitz 2014, Eq. 69, in the form of microfacet/beckmann_lambda.hpp; the rounding of c / s and of a^2 is
///   carried into the exponential, which would magnify it 2 a^2 times.
/// - ggx: Eq. 72 as s^2 / (2 (c + sqrt(c^2 + s^2))), without the difference that cancels for large a.
/// - beckmann_walter: the rational fit of Walter et al. 2007; a Lambda = (1 - 1.259 a + 0.396 a^2) / (3.535 + 2.181 a)
///   for a < 1.6, else 0.
///@{
void masked_area_beckmann(const double* c, const double* s, double* tau, std::size_t n);
void masked_area_beckmann(const float* c, const float* s, float* tau, std::size_t n);
void masked_area_ggx(const double* c, const double* s, double* tau, std::size_t n);
void masked_area_ggx(const float* c, const float* s, float* tau, std::size_t n);
void masked_area_beckmann_walter(const double* c, const double* s, double* tau, std::size_t n);
void masked_area_beckmann_walter(const float* c, const float* s, float* tau, std::size_t n);
///@}

/// \name Lambda
/// Lambda(c / s), as above, or Lambda(a); infinity for c <= 0, a <= 0. Domain: c / s, a <= 0 or >= 2^-1000 (float:
/// 2^-120).
///@{
void lambda_beckmann(const double* a, double* lambda, std::size_t n);
void lambda_beckmann(const float* a, float* lambda, std::size_t n);
void lambda_ggx(const double* a, double* lambda, std::size_t n);
void lambda_ggx(const float* a, float* lambda, std::size_t n);
void lambda_beckmann(const double* c, const double* s, double* lambda, std::size_t n);
void lambda_beckmann(const float* c, const float* s, float* lambda, std::size_t n);
void lambda_ggx(const double* c, const double* s, double* lambda, std::size_t n);
void lambda_ggx(const float* c, const float* s, float* lambda, std::size_t n);
void lambda_beckmann_walter(const double* c, const double* s, double* lambda, std::size_t n);
void lambda_beckmann_walter(const float* c, const float* s, float* lambda, std::size_t n);
///@}

/// \name Distribution of normals
/// D(omega_m) in 1/sr for unit normals (Heitz 2014, Eq. 64 with Eq. 95): with N2 = z^2 |u|^2 the scaled norm of the
/// slope in units of the roughness, and det = alpha_x alpha_y sqrt(1 - r^2), exp(-N2 / z^2) / (pi det z^4) for Beckmann
/// and 1 / (pi det (z^2 + N2)^2) for GGX; 0 for z <= 0.
///@{
void d_beckmann(const Stretch&, Vectors<double> omega_m, double* d, std::size_t n);
void d_beckmann(const Stretch&, Vectors<float> omega_m, float* d, std::size_t n);
void d_ggx(const Stretch&, Vectors<double> omega_m, double* d, std::size_t n);
void d_ggx(const Stretch&, Vectors<float> omega_m, float* d, std::size_t n);
///@}

/// \name BRDF
/// D(omega_h) G2 / (4 c_o c_i) in 1/sr (Heitz 2014, Eq. 29 with F = 1), for unit directions and Smith masking. Float
/// arrays are computed in double and rounded once.
///
/// | shadowing         | G2 / (c_o c_i)                                                 |
/// | ----------------- | -------------------------------------------------------------- |
/// | none              | 1 / (c_i (c_o + tau_o))                                        |
/// | separable         | 1 / ((c_o + tau_o) (c_i + tau_i))                              |
/// | minimum           | 1 / max(c_i (c_o + tau_o), c_o (c_i + tau_i))                  |
/// | height_correlated | 1 / (c_o c_i + c_i tau_o + c_o tau_i)                          |
///
/// 0 where c_o <= 0 or c_i <= 0, where the half vector is undefined (omega_i = -omega_o) or points below the surface.
/// Never NaN, never infinite: a value beyond the largest finite number is that number. The half vector is never
/// normalised, and the divisions of the last step are one. Beckmann: c_o, c_i <= 0 or >= 2^-200; nearer to the horizon
/// the factor exp(-E) counts as zero where E > 900, although the other factors may be large enough to show it.
///@{
void brdf(const Stretch&, Distribution, Shadowing, Vectors<double> omega_o, Vectors<double> omega_i, double* value,
          std::size_t n);
void brdf(const Stretch&, Distribution, Shadowing, Vectors<float> omega_o, Vectors<float> omega_i, float* value,
          std::size_t n);
///@}

/// \name Reflectance
/// Of unpolarised light at the cosines c in [0, 1], in [0, 1].
///
/// Dielectric and conductor: (|r_s|^2 + |r_p|^2) / 2 of Fresnel's equations for the relative index eta, or eta + i k,
/// 1e-6 <= eta <= 1e6, 0 <= k <= 1e6 (Born and Wolf 1999, sections 1.5.2 and 14.2); 1 under total internal reflection
/// (eta < 1), 0 for an index of 1, at grazing too. For eta = 1, where F is a function of c^2 / k, a k below 1e-140
/// counts as 0. The same bytes on every instruction set.
///
/// Schlick: f0 + (f90 - f0) (1 - c)^exponent (Schlick 1994, Eq. 24), f0 and f90 in [0, 1], 1e-3 <= exponent <= 1e3; an
/// exponent of 5 is the fastest, and has the same bytes on every instruction set.
///@{
void reflectance_dielectric(const double* c, double eta, double* f, std::size_t n);
void reflectance_conductor(const double* c, double eta, double k, double* f, std::size_t n);
void reflectance_schlick(const double* c, double f0, double f90, double exponent, double* f, std::size_t n);
///@}

/// The instruction sets that the kernels are compiled for, slowest first.
enum class Isa { baseline, avx2, avx512 };

/// The name that BRDFPLOT_ISA accepts.
std::string_view name(Isa isa);

/// Those that this build has and this processor runs, slowest first; `baseline` always.
std::vector<Isa> available_isas();

/// The instruction set in use: the last of `available_isas`, or the one that the environment variable BRDFPLOT_ISA
/// names when the first kernel runs.
Isa active_isa();

/// Why BRDFPLOT_ISA cannot be obeyed, naming what is accepted here; nothing when it is unset or in use. The kernels
/// then run as if it were unset; the caller that wants an error makes one of this.
std::optional<std::string> isa_request_error();

/// Switches all following calls; false, and no change, when `isa` is not available. For tests and benchmarks.
bool use_isa(Isa isa);

} // namespace brdfplot::kernels
