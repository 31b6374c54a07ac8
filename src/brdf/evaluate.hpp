/// \file
/// The quantities of a material at directions, over arrays of directions.
#pragma once

#include "brdf/blocks/surface_block.hpp"
#include "brdf/blocks/surface_quantities.hpp"
#include "brdf/material.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>

namespace brdfplot {

/// How many channels a quantity has.
int channels_of(const Material& material, Quantity quantity, const std::string& term = "");

/// Writes channel k of row r to out[k * n + r]. What is computed, by what has it:
///   a microsurface  the quantities of surface_quantities.hpp: of the term of this name, or of the only one that has a
///                   microsurface
///   its facets      fresnel: F(o.m) of a term that has one
///   the material    brdf, the sum of its terms times their weights (1/sr), and brdf_cos, times c_i, the projected area
///                   of the mesosurface; with a name of that term alone. They do not look at m.
/// 0 where a direction is at or below the horizon of the mesosurface, never NaN or infinity (but `brdf` of a mirror
/// with shadowing `none` grows like 1 / c_i towards the horizon). Any n. The value of a row depends on that row alone,
/// to the last bit.
/// \throws InputError when the material has no such quantity; AccuracyError when a quadrature (Lambda, or diffuse
/// facets) misses its accuracy.
void evaluate(const Material& material, Quantity quantity, const Batch& batch, double* out,
              const std::string& term = "");

/// A quantity, and where its values go.
struct Wanted {
  Quantity quantity;
  double* out;
  std::string term{};
};

/// Several quantities at once, to the last bit as one after the other: half vectors, masking, densities and
/// reflectances are computed once for all that need them.
void evaluate(const Material& material, std::span<const Wanted> wanted, const Batch& batch);

/// One row; the first channel.
double evaluate(const Material& material, Quantity quantity, const Direction& o, const std::optional<Direction>& i,
                const std::optional<Direction>& m);

/// Writes rho of one term, or rho c_i, without its weight: channel k of row r to out[k * n + r].
template <class T>
void evaluate_term(const T& term, bool times_cosine, const Batch& batch, double* out) {
  SurfaceBlock work;
  if constexpr (requires { T::is_flat; })
    return term.evaluate({batch.n, batch.o, batch.i, times_cosine}, work, rows_from(out, 0, batch.n, term.channels()));
  for (std::size_t first = 0; first < batch.n; first += PairBlock::capacity) {
    const std::size_t n = std::min(PairBlock::capacity, batch.n - first);
    set_directions(work, n, batch.o.from(first), batch.i.from(first), {});
    term.evaluate({n, work.o, work.i, times_cosine}, work, rows_from(out, first, batch.n, term.channels()));
  }
}

/// \throws InputError when `quantity` cannot be had from `material` with the directions given: which one is missing.
void require(const Material& material, const QuantityInfo& info, bool has_o, bool has_i, bool has_m,
             const std::string& term = "");

} // namespace brdfplot
