/// \file
/// The properties that Table 3 of Heitz 2014 lists, and those that go without saying, measured.
#pragma once

#include "brdf/material.hpp"

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace brdfplot {

/// What a masking function, a distribution or a BRDF ought to satisfy.
enum class Property {
  eq14,               ///< the visible facets project the area of the mesosurface: int G1 <o,m> D dm = c_o
  eq18,               ///< the visible normals are a distribution: int D_o dm = 1
  eq36,               ///< weak white furnace, specular facets
  eq37,               ///< weak white furnace, diffuse facets
  normalized,         ///< int (m.g) D dm = 1 (Eq. 9)
  eq9_22,             ///< int D <o,m> dm over all normals, those that face away counted negative, is c_o: a heightfield
  g1_range,           ///< 0 <= G1 <= 1
  g1_decreasing,      ///< G1 does not grow with theta_o
  g1_normal,          ///< G1 -> 1 at the normal
  stretch_invariance, ///< a stretched configuration has the same G1 (section 5.1)
  reciprocity,        ///< rho(o, i) = rho(i, o)
  energy,             ///< the white furnace, Eq. 34 with F = 1, is at most 1; of several terms, their albedo
};

struct PropertyInfo {
  Property property;
  std::string name;     ///< in files
  std::string title;    ///< in tables
  std::string doc;      ///< what the residual is
  std::string source{}; ///< which equations it tests, where it does
};

/// All, in the order of `Property`.
const std::vector<PropertyInfo>& properties();

/// The four of Table 3, that "physically based" stands for.
const std::vector<Property>& table3_properties();

/// What a material may claim: `physically_based`, or any property by its name.
std::vector<std::string> claim_names();

/// holds: residual + error <= tolerance everywhere; fails: residual - error > tolerance somewhere; unknown: the error
/// does not allow either; not_applicable: there is nothing to measure.
enum class Verdict { holds, fails, unknown, not_applicable };

/// The largest residual over the sampled configurations.
struct Residual {
  double max_residual = 0; ///< NaN: it could not be computed
  double error = 0;        ///< of the integral there, or of what is compared
  double alpha = 0;        ///< where: the roughness (along x) of the distribution,
  double theta_o = 0;      ///< and the viewer, about the normal of the mesosurface
  double phi_o = 0;
  Verdict verdict = Verdict::unknown;
  std::string reason{}; ///< why there is nothing to measure, where there is not
};

struct PropertyRow {
  std::string material;     ///< its name; none in a table's row
  std::string label;        ///< of the distribution, with its parameters
  std::string distribution; ///< types
  std::string masking;
  std::map<Property, Residual> residuals; ///< of what was measured
  std::string mistake{};                  ///< masking_mistake(), of a material by itself

  /// Of the four of Table 3: fails where one fails, holds where all hold, not_applicable where none applies. unknown
  /// where one was not measured.
  Verdict physically_based() const;
  /// Of one of claim_names().
  Verdict verdict(const std::string& claim) const;
};

/// Which configurations are tried.
struct PropertySearch {
  std::vector<double> theta_o = default_theta_o(); ///< rad, about the normal of the mesosurface
  double tolerance = 1e-6;                         ///< a residual up to this counts as zero

  /// 0, 15, 30, 45, 60, 75, 85 and 89 degrees.
  static std::vector<double> default_theta_o();
};

/// The worst over a family of materials (one, or one distribution at several roughnesses). Azimuths are tried in steps
/// of 30 degrees where the material is not isotropic.
/// What G1 is compared for (range, growth, stretching) is sampled every degree, and for normals out to three times the
/// roughness where it depends on them.
/// \throws MaterialError
Residual measure(Property property, const std::vector<MaterialDescription>& family, const PropertySearch& search);

/// Which combinations a table of properties covers, and where it looks for the largest residual.
struct PropertyTableDescription {
  std::string id;
  std::string title;
  std::string caption;
  std::vector<std::string> maskings;
  std::vector<ModelChoice> distributions; ///< without a roughness: each of `alpha` in turn
  std::vector<double> alpha;
  std::vector<double> theta_o; ///< rad
  double tolerance = 1e-6;     ///< a residual up to this counts as zero

  PropertySearch search() const { return {theta_o, tolerance}; }
};

/// A row of a table before it is measured.
struct PropertyFamily {
  std::string material; ///< none in a table's row
  std::string label;
  std::vector<MaterialDescription> members;
};

/// "gtr (gamma 1.5)": a distribution with the parameters that were given.
std::string describe(const ModelChoice& distribution);

/// A material by itself; where several of its terms have a microsurface, each of these by itself too.
std::vector<PropertyFamily> families_of(const MaterialDescription& material);

/// All rows of a table, masking functions outermost, as the paper orders them.
std::vector<PropertyFamily> families(const PropertyTableDescription& table);

/// The row of a family before it is measured.
PropertyRow row_of(const PropertyFamily& family);

PropertyRow measure(const PropertyFamily& family, const std::vector<Property>& which, const PropertySearch& search);

} // namespace brdfplot
