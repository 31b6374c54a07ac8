/// \file
/// What a term of a BRDF is, before and after it is made.
#pragma once

#include "math/direction.hpp"
#include "math/quadrature.hpp"
#include "microfacet/fresnel.hpp"
#include "microfacet/microsurface.hpp"

#include <concepts>
#include <cstddef>
#include <string>
#include <vector>

namespace brdfplot {

/// Directions as three arrays of n; null pointers: not given.
struct Columns {
  const double* x = nullptr;
  const double* y = nullptr;
  const double* z = nullptr;
  explicit operator bool() const { return x != nullptr; }

  Direction operator[](std::size_t k) const { return {x[k], y[k], z[k]}; }
  Columns from(std::size_t first) const { return x != nullptr ? Columns{x + first, y + first, z + first} : Columns{}; }
};

/// A term "coated" that another term is part of, not yet checked.
struct LayerDescription {
  std::string name;    ///< of the coated term: its weight and tint are set and swept by it, its BRDF is asked for
  Value weight = 1.0;  ///< multiplies every part of it
  std::string coat{};  ///< the name of the term that lies over this one; none: this one is the coat
  Values values{};     ///< of the coated term: attenuation, tint
  std::string place{}; ///< where it stands in the JSON of the material
};

/// Names and parameters of a term, not yet checked. Which of the models it has, and which values, its type says.
struct TermDescription : MicrosurfaceDescription {
  std::string name{};          ///< how its parameters are set and swept ("coat.alpha"); none: its type
  std::string type = "mirror"; ///< one of the list in terms.hpp
  Value weight = 1.0;          ///< a number, or one a channel
  ModelChoice fresnel{.type = "none"};
  Values values{};                        ///< what the type has beside models: albedo, sigma, ...
  std::string of_name{};                  ///< of a term that is of another: the name of one beside it,
  std::vector<TermDescription> of{};      ///< or it itself, one
  std::vector<LayerDescription> layers{}; ///< the coated terms that it is part of, the outermost first
  std::string place{};                    ///< where it stands in the JSON of the material, where it is part of one
};

/// The description of the other term. \throws MaterialError where there is none
const TermDescription& another_of(const TermDescription& description);

/// Rows of unit vectors above the mesosurface or not, at most block_size of them, and which factor goes with rho.
struct PairBlock {
  static constexpr std::size_t capacity = 256; ///< stays in the first-level cache
  std::size_t n = 0;
  Columns o, i;
  bool times_cosine = false; ///< rho c_i instead of rho, c the projected area of the mesosurface
};

struct SurfaceBlock; // surface_block.hpp

/// Where a term writes rho of a block: channel k of row r at rho[k][r].
struct ChannelRows {
  double* rho[3];
};

/// The channels of the rows from `first` on, of n.
inline ChannelRows rows_from(double* out, std::size_t first, std::size_t n, int channels) {
  ChannelRows rows{};
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) rows.rho[c] = out + c * n + first;
  return rows;
}

/// What a term has to give. Beyond it, by `requires`:
///   surface                  its microsurface, if it is derived from one
///   distribution             its distribution of normals alone, if that is what it has
///   isotropic()              whether rho is the same for every azimuth of the viewer, where the surface or the
///                            distribution does not say it; else it is
///   of_another               it is made of the albedo of another term
///   fresnel                  its Fresnel term, if it has one
///   about_half_vector        rho has D(h) as a factor, and integrals over the light follow it: facets() is the
///                            distribution, kinks(omega_o, channels) where the rest is not smooth; else rho is smooth
///                            on the scale of the hemisphere
///   bends()                 rho c_i is not 0 below the horizon, but down to the lowest of these cosines of the light;
///                           rho is 0 there
///   reflected_light(o, tolerance, channels, weight)  its own rule for integrals over the light (reflected_light.hpp)
///   is_flat                  evaluate() looks at the rows alone, any number of them at once: at no `work`
///   piecewise_constant       rho has steps and no slope: where it is largest is a range, not a place
///   brdf(o, i, tolerance)    rho of albedo 1 with an error, where it is a quadrature; else rho is a closed form
template <class T>
concept TermModel = requires(const T& term, const PairBlock& pairs, SurfaceBlock& work, const ChannelRows& out,
                             const TermDescription& d) {
  { T::spec() } -> std::same_as<ModelSpec>;
  { T::from(d) } -> std::same_as<T>; // \throws MaterialError
  { term.channels() } -> std::same_as<int>;
  // rho (1/sr) of each pair, for each channel; 0 where a direction is at or below the horizon.
  // `work` has the same directions, and what other quantities of the term have left there.
  { term.evaluate(pairs, work, out) } -> std::same_as<void>;
  // The same with F = 1, or with an albedo of 1, where F0 is part of a diffuse term and stays: what the furnace tests.
  { term.white() } -> std::same_as<T>;
};

} // namespace brdfplot
