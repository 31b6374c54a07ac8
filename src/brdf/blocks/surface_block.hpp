/// \file
/// The factors of a microsurface, over blocks of directions.
#pragma once

#include "brdf/term.hpp"

#include <array>

namespace brdfplot {

using Buffer = std::array<double, PairBlock::capacity>;

/// Masking of one direction: c the projected area of the mesosurface, s the projected roughness.
struct MaskedSide {
  Buffer c, s;
  Buffer unmasked_area; ///< c / G1; without meaning where c <= 0
  Buffer masked_area;   ///< c Lambda; 0 where c <= 0
};

/// Rows are computed in blocks that stay in the first-level cache; each stage visits its model once a block, so that
/// the loop is over concrete code and the number of instantiations is the sum, not the product, of the lists' lengths.
///
/// What is computed stays for the next quantity of the same rows, until set_directions().
struct SurfaceBlock {
  struct Side {
    bool projected = false, masked = false;
  };
  struct Done {
    Side viewer, light;
    bool visibility = false, densities = false, white = false, reflectances = false;
  };

  std::size_t n = 0;
  Done done;
  Columns o, i, m;       ///< m may be that of half_x, half_y and half_z
  bool has_half = false; ///< m is the half vector, which both directions face where it is defined
  Buffer half_x, half_y, half_z;
  MaskedSide viewer, light;
  Buffer density;
  Buffer visibility; ///< G2 / (c_o c_i)
  Buffer white;      ///< the BRDF of mirrors with F = 1, where a kernel computes it whole
  std::array<Buffer, 3> reflectances;
};

/// Sets the directions of the block; without m, those of the half vectors of o and i, else the normal.
void set_directions(SurfaceBlock& block, std::size_t n, const Columns& o, const Columns& i, const Columns& m);

/// Computes the masking of the viewer's direction.
void compute_masking(const Microsurface& surface, SurfaceBlock& block);

/// Computes the masking of both directions.
void compute_both_maskings(const Microsurface& surface, SurfaceBlock& block);

/// Computes G2 / (c_o c_i): 0 where it is undefined or a side is hidden; and c and s of both directions, and their
/// masking unless the form of shadowing brings its own.
void compute_visibility(const Microsurface& surface, SurfaceBlock& block);

/// Computes D(m).
void compute_densities(const Microsurface& surface, SurfaceBlock& block);

/// Computes F(o.m) of each channel.
void compute_reflectances(const Fresnel& fresnel, SurfaceBlock& block);

inline kernels::Vectors<double> vectors(const Columns& columns) { return {columns.x, columns.y, columns.z}; }

} // namespace brdfplot
