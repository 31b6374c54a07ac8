/// \file
/// The random walk on Smith's microsurface (Heitz et al. 2016): all bounces, on the surface that Smith's masking
/// assumes.
///
/// A ray in the direction omega at the height h meets the surface with a rate that makes
///   G1(omega, h) = C1(h)^Lambda(omega)   (their Eq. 5)
/// the chance to leave it, C1 the cumulative distribution of heights. The next height h' has
///   C1(h') = C1(h) (1 - xi)^(-1 / Lambda(omega))   (their Eq. 12), xi uniform; beyond 1 the ray has left,
/// where Lambda(-omega) = -1 - Lambda(omega) for rays that fall. So the walk is written in C1(h) alone, and is the same
/// for Gaussian, uniform and any other heights (which the tests show by walking through both in heights).
#pragma once

#include "brdf/material.hpp"
#include "math/direction.hpp"
#include "simulation/statistics.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace brdfplot::simulation {

/// What a mirror does with light that it does not reflect. Diffuse facets are the material's (`Facet`): they scatter
/// all light by Lambert's law.
enum class Facets {
  conductor,  ///< absorbs it; reflection is weighted by the material's Fresnel term
  dielectric, ///< refracts it; the Fresnel term must have a relative index: `dielectric`
};

/// Bounces are counted one by one up to here, the rest together.
inline constexpr std::size_t bounce_classes = 8;

struct WalkRequest {
  Direction omega_o{0, 0, 1};
  std::vector<Direction> omega_i; ///< where the lobe is wanted; below the horizon: what is transmitted
  std::size_t paths = 65536;      ///< rounded up to a multiple of the number of chunks
  std::uint64_t seed = 1;
  int threads = 1;
  std::size_t channel = 0; ///< of the Fresnel term
};

/// Paths go in so many chunks, one after the other within each: fixed, so that results do not depend on threads.
inline constexpr std::size_t walk_chunks = 32;

/// What a walk measured, for each quantity one estimate a chunk. Bounces first..last count from 1; bounce_classes as
/// the last one means: and all after.
struct WalkResult {
  using ByBounce = std::array<std::vector<double>, bounce_classes>;
  ByBounce reflected, transmitted; ///< energy that leaves upwards, downwards, after so many bounces
  ByBounce fresnel, hits; ///< sum of the reflectance at the k-th bounce over the rays that have one, and their share
  ByBounce lobe;          ///< rho(o, i) c_i of direction d: lobe[bounce][chunk * directions + d]
  std::size_t directions = 0;
  std::size_t paths = 0;
  std::size_t unfinished = 0; ///< paths that had not left after most_bounces; their energy is in no sum

  /// Energy, of `reflected` or `transmitted`; one point.
  static Estimates energy(const ByBounce& from, std::size_t first, std::size_t last);
  /// The lobe; a point for each direction.
  Estimates lobe_of(std::size_t first, std::size_t last) const;
  /// The mean Fresnel reflectance at these bounces of the rays that have one, linearised about the mean of all chunks;
  /// of the first bounce alone it is Eq. 105 of Heitz 2014.
  Estimates mean_fresnel(std::size_t first, std::size_t last) const;
};

inline constexpr int most_bounces = 10000;

/// \throws InputError when walk() cannot do it.
void check_walk(const Material& material, Facets facets, const Direction& omega_o);

/// Walks. The lobe is estimated at every vertex (phase function times G1), so that it is smooth: its values in
/// different directions come from the same walks. Domain: distributions that sample their visible normals (`beckmann`
/// and `ggx`), with any roughness, correlation and mean slope; omega_o above the horizon of the mesosurface; mirrors,
/// and diffuse facets. \throws InputError for others, and where `facets` do not go with the material's; Interrupted.
WalkResult walk(const Material& material, Facets facets, const WalkRequest& request);

} // namespace brdfplot::simulation
