/// \file
/// Directions of the light as a renderer draws them, with their density.
#pragma once

#include "brdf/blocks/viewer_rows.hpp"
#include "brdf/material.hpp"
#include "sampling/direct_lobe.hpp"
#include "sampling/facets.hpp"
#include "sampling/strategy.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot {

/// What a term can be drawn by: `cosine`; where it is about the half vector, `half_vector`; and where the facets' mean
/// slope is finite, `visible_normals`, of GGX `heitz_2018` too; and what its type brings (own_strategy.hpp).
std::vector<Strategy> strategies_of(const WeightedTerm& term);
/// `visible_normals` for mirrors with a Lambda, else `half_vector` for what is about it, else `cosine`.
Strategy default_strategy(const WeightedTerm& term);

/// What Sampler requires of `strategy`, without making its tables. \throws InputError as Sampler does.
void require_strategy(const Material& material, const std::string& strategy, const std::string& where = "--strategy");

/// Draws directions omega_i for a material, each a function of a point in [0, 1)^3 alone, without rejection.
///
/// A sum of terms is drawn from by the one-sample model (Veach 1997, section 9.2.4): a term is chosen, and the density
/// is that of all, weighted by their chances. The chance of term k is 0.9 w_k / sum w + 0.1 / K of K terms, w_k its
/// weight times its albedo or colour or its Fresnel reflectance at omega_o over the mean normal, as means of channels,
/// and 1 where it has none of these; so that no term is ever left to the others. By the strategy `kelemen`, of a term
/// and its `complement`, the albedo of each at omega_o, from the table, is w.
///
/// Mirrored directions may lie below the horizon, where the BRDF is 0; the density is over the whole sphere, and its
/// integral there is 1. From a viewer at or below the horizon of the mesosurface nothing is drawn: its density is 0.
class Sampler {
public:
  /// A reference to `material` is kept. `strategy`: one of strategy_names(), for all terms. \throws InputError where a
  /// term does not have it: which, and what each accepts; at `where` for an unknown name.
  Sampler(const Material& material, const std::string& strategy, const std::string& where = "--strategy");

  /// What is known once omega_o is.
  class Viewer {
  public:
    Viewer(const Sampler& sampler, const Direction& omega_o);
    /// Below the horizon of the viewer: the mean normal.
    Direction sample(const SamplePoint& point) const;

  private:
    friend class SampleBatches;

    const Sampler* sampler_;
    Direction omega_o_;
    std::vector<double> shares_;
    std::vector<std::optional<Facets::Viewer>> facets_;
  };

  /// Directions for a batch of points at one viewer: those of Viewer::sample but for rounding, by kernels where there
  /// are some (math/kernels/sampling.hpp).
  void sample(const Direction& omega_o, const std::vector<SamplePoint>& points, DirectionArrays& omega_i) const;
  /// The same, and the density of each: what densities() gives but for the rounding of o + i, which narrow lobes feel.
  void sample(const Direction& omega_o, const std::vector<SamplePoint>& points, DirectionArrays& omega_i,
              std::vector<double>& pdf) const;
  /// The density (1/sr) of each pair; 0 where o and i are opposite, where it is none.
  void densities(std::size_t n, const Columns& omega_o, const Columns& omega_i, double* out) const;

  /// The terms one by one, of which the density is a sum: what each adds to it, and the chances at a viewer.
  struct Lobe {
    Strategy strategy;
    std::shared_ptr<const Facets> facets;       ///< null: cosine
    double size;                                ///< weight and albedo
    const Fresnel* fresnel;                     ///< null: none
    std::shared_ptr<const DirectLobe> direct{}; ///< null: cosine, or facets
  };
  const std::vector<Lobe>& lobes() const { return lobes_; }
  std::vector<double> shares(const Direction& omega_o) const;
  /// That of one term alone.
  void lobe_densities(const Lobe& lobe, std::size_t n, const Columns& omega_o, const Columns& omega_i,
                      double* out) const;
  const SlopeMap& mesosurface() const { return map_; }

private:
  /// How much each term reflects, as far as that is known: term l of row k at l n + k.
  std::vector<double> sizes(std::size_t n, const Columns& omega_o) const;
  /// The chances of terms at each viewer, in the same order; 0 below the horizon.
  std::vector<double> shares_of_rows(std::size_t n, const Columns& omega_o) const;

  SlopeMap map_;
  Direction mean_normal_;
  std::vector<Lobe> lobes_;
  const AlbedoTable* other_ = nullptr; ///< of two terms, where it says how much either reflects
};

} // namespace brdfplot
