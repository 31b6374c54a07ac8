/// \file
/// How far apart two materials are: over all pairs of directions, in albedo, and as lit spheres look.
#pragma once

#include "choice/advise/images/errors.hpp"

#include <string>
#include <vector>

namespace brdfplot::choice {

/// A pair of directions with rho cos theta_i of both materials, of the channel that differs most.
struct DifferentPair {
  Direction omega_o, omega_i;
  int channel = 0;
  double a = 0, b = 0;
};

/// Albedos at one angle of the viewer; their three channels are equal where a material is grey.
struct AlbedoPair {
  double theta_o = 0;
  Rgb a{}, b{};
};

/// B against A. f = rho cos theta_i, viewers weighted by cos theta_o.
struct MaterialDifference {
  std::string name;               ///< of B
  DifferentPair largest;          ///< where |f_A - f_B| is largest
  DifferentPair largest_relative; ///< where it is over the larger of both, of those above a thousandth of A's largest f
  double relative = 0;            ///< its value there
  /// sqrt(int (f_A - f_B)^2 / int f_A^2) and int |f_A - f_B| / int f_A, over the hemispheres of both directions and all
  /// channels, with standard errors from independent sets of points.
  double rms = 0, rms_error = 0;
  double light = 0, light_error = 0;
  std::vector<AlbedoPair> albedo;
  PictureErrors sphere; ///< Delta E_ITP of a sphere under the lights of comparison_lights()
};

struct CompareOptions {
  std::size_t points = 4096; ///< directions of light for each viewer
  int threads = 1;
};

/// A key light at 45 degrees, a rim light at 140 and a fill at 70 from the other side, with discs of 3 degrees: they
/// reach half angles of 22 to 70 degrees, so that reflectance at grazing counts.
std::vector<AdviceLight> comparison_lights();

/// The directions of the light are drawn from both materials by turns (the balance of both densities), so that no lobe
/// of either is missed; 16 viewers by Gauss and Legendre's rule in cos theta_o, at 1 azimuth, or at 8 where one of the
/// materials is not isotropic. The largest differences are those found by a climb from the best of these pairs: lower
/// bounds of the true ones. \throws InputError, MaterialError, AccuracyError
MaterialDifference difference_of(const MaterialDescription& a, const MaterialDescription& b,
                                 const CompareOptions& options);

/// B with its free parameters (see FreeParameter: "alpha", "albedo", ...), of every term that has them, fitted to the
/// sphere of A. \throws InputError at --refit for a name that no term has
MaterialDescription refitted_to(const MaterialDescription& a, const MaterialDescription& b,
                                const std::vector<std::string>& free, int threads);

/// What is compared, and how it is, one of two cells a row.
std::vector<std::vector<std::string>> comparison_rows(const std::string& a, const MaterialDifference& one);
/// The same as people read it.
std::string comparison_text(const std::string& a, const std::vector<MaterialDifference>& all);
/// quantity,material,theta_o,channel,a,b,value rows of the same.
std::string comparison_csv(const std::vector<MaterialDifference>& all);

} // namespace brdfplot::choice
