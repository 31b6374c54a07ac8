/// \file
/// The quantities of a material at directions, over arrays of directions.
#pragma once

#include "brdf/material.hpp"
#include "math/direction.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace brdfplot {

enum class Quantity { lambda, p22, d, d_cos, g1, g2, d_visible, fresnel, brdf, brdf_cos };

/// Which directions a quantity is a function of.
struct Needs {
  bool o = false;
  bool i = false;
  bool m = false; ///< where i is given the half vector serves for it
};

struct QuantityInfo {
  Quantity quantity;
  std::string name;
  std::string doc;
  Needs needs;
  bool coloured; ///< has as many channels as the material
};

/// All quantities with a closed form, in the order of `Quantity`.
const std::vector<QuantityInfo>& quantities();

/// Directions as three arrays of n; null pointers: not given.
struct Columns {
  const double* x = nullptr;
  const double* y = nullptr;
  const double* z = nullptr;
  explicit operator bool() const { return x != nullptr; }
};

/// n rows of unit vectors (for `m`: within rounding; the half vector of o and i where it is not given).
struct Batch {
  std::size_t n = 0;
  Columns o, i, m;
};

/// Writes channel k of row r to out[k * n + r]. What is computed, with c the projected area of the mesosurface (cos
/// theta when centred), by Heitz 2014:
///   lambda    Lambda(o), Eqs. 69, 72; infinity at and below the horizon of the mesosurface (c <= 0)
///   p22       slope density at the slope of m, Eqs. 67-95
///   d, d_cos  D(m) of Eq. 64 (1/sr), and cos theta_m D(m)
///   g1        G1(o, m), Eqs. 43, 49, 55-60; without m, where the masking function has a Lambda, of facing normals
///   g2        G2(o, i, m), Eqs. 98-101
///   d_visible D_o(m), Eq. 16
///   fresnel   F(o.m)
///   brdf      F D(h) G2(o, i, h) / (4 c_o c_i), Eq. 29 (1/sr); of diffuse facets Eq. 31, by quadrature (diffuse.hpp)
///             with a relative error below 1e-9
///   brdf_cos  brdf times c_i
/// brdf and brdf_cos do not look at m. phi_o - phi_i is 0 where one of them is at the normal, which has no azimuth.
/// Where c_o <= 0 or c_i <= 0, o.m <= 0, z_m <= 0 or the half vector is undefined (i = -o): 0, never NaN or infinity
/// (but `brdf` with shadowing `none` grows like 1 / c_i towards the horizon).
/// Any n. The value of a row depends on that row alone, to the last bit.
/// \throws InputError when the material has no such quantity (Lambda of V-cavities); AccuracyError when a quadrature
/// (Lambda, or diffuse facets) misses its accuracy.
void evaluate(const Material& material, Quantity quantity, const Batch& batch, double* out);

/// A quantity, and where its values go.
struct Wanted {
  Quantity quantity;
  double* out;
};

/// Several quantities at once, to the last bit as one after the other: half vectors, masking, densities and
/// reflectances are computed once for all that need them.
void evaluate(const Material& material, std::span<const Wanted> wanted, const Batch& batch);

/// The batch without what `quantity` is no function of: a normal given beside o and i, for brdf and brdf_cos, whose
/// facets are those of the half vector.
Batch used_by(Quantity quantity, const Batch& batch);

/// Whether `value` can be one of `quantity`: finite, or the infinite lambda at and below the horizon. The last guard of
/// all that prints values.
bool is_told(Quantity quantity, double value);

/// One row; the first channel.
double evaluate(const Material& material, Quantity quantity, const Direction& o, const std::optional<Direction>& i,
                const std::optional<Direction>& m);

/// \throws InputError when `quantity` cannot be had from `material` with the directions given: which one is missing.
void require(const Material& material, const QuantityInfo& info, bool has_o, bool has_i, bool has_m);

} // namespace brdfplot
