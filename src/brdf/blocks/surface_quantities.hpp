/// \file
/// The quantities of a microsurface at directions, over arrays of directions.
#pragma once

#include "brdf/quantity.hpp"

#include <array>
#include <optional>

namespace brdfplot {

/// Writes row r to out[r]. What is computed, with c the projected area of the mesosurface (cos theta when centred), by
/// Heitz 2014:
///   lambda    Lambda(o), Eqs. 69, 72; infinity at and below the horizon of the mesosurface (c <= 0)
///   p22       slope density at the slope of m, Eqs. 67-95
///   d, d_cos  D(m) of Eq. 64 (1/sr), and cos theta_m D(m)
///   g1        G1(o, m), Eqs. 43, 49, 55-60; without m, where the masking function has a Lambda, of facing normals
///   g2        G2(o, i, m), Eqs. 98-101
///   d_visible D_o(m), Eq. 16
/// phi_o - phi_i is 0 where one of them is at the normal, which has no azimuth. Where c_o <= 0 or c_i <= 0, o.m <= 0,
/// z_m <= 0 or the half vector is undefined (i = -o): 0, never NaN or infinity.
/// Any n. The value of a row depends on that row alone, to the last bit. `quantity` must be one of Owner::microsurface,
/// and the directions that it needs be given.
/// \throws AccuracyError when a quadrature (Lambda) misses its accuracy.
void evaluate(const Microsurface& surface, Quantity quantity, const Batch& batch, double* out);

/// The same of two quantities, which share half vectors and masking.
void evaluate(const Microsurface& surface, const std::array<Quantity, 2>& quantities, const Batch& batch,
              const std::array<double*, 2>& out);

/// The same of one block, whose directions are set; `has_m`: a normal is given, or half vectors.
struct SurfaceBlock;
void evaluate(const Microsurface& surface, Quantity quantity, bool has_m, SurfaceBlock& block, double* out);

/// One row.
double evaluate(const Microsurface& surface, Quantity quantity, const Direction& o, const std::optional<Direction>& i,
                const std::optional<Direction>& m);

/// \throws InputError at `where` when `quantity` cannot be had from the microsurface with the directions given: which
/// one is missing.
void require(const Microsurface& surface, const std::string& where, Quantity quantity, bool has_o, bool has_i,
             bool has_m);

} // namespace brdfplot
