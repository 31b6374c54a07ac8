/// \file
/// Sums kept apart by realisations of the surface, and what can be said from them with its error.
#pragma once

#include "simulation/statistics.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace brdfplot::simulation {

/// What makes one run differ from another: surfaces are drawn and rays on them, or the surface is given.
enum class Drawn { surfaces, rays };

/// A row of sums for every tile, in two halves from independent rays. Rows are filled by any thread and added in their
/// order, so that the result does not depend on who filled them.
///
/// Tiles of one surface are no sample of surfaces. A period holds its mean squares of heights and slopes, so that what
/// one tile has more the others have less (their scatter then tells twice the error of a G1), a GGX surface is scaled
/// as a whole, the pairs of V-cavities are strata, and a shadow runs from tile to tile. Only realisations are
/// independent, and the errors are of their scatter.
class Tally {
public:
  /// `keep_tiles`: for error_of_rays(); without it a realisation that has ended is one row.
  explicit Tally(std::size_t width = 0, Drawn drawn = Drawn::surfaces, bool keep_tiles = true)
      : width_(width), drawn_(drawn), keep_tiles_(keep_tiles || drawn == Drawn::rays) {}

  void begin_realisation(std::size_t tiles);
  /// The sums of one half of a tile of the realisation, to be added to.
  std::span<double> half(std::size_t tile, std::size_t which);
  /// A tile that is not marked does not count.
  void mark_done(std::size_t tile) { done_[first_ + tile] = 1; }
  void end_realisation();

  using Function = std::function<double(std::span<const double> sums)>;

  /// A function, of degree 0 in the sums, of the given columns' totals. Its standard error is the jackknife's over the
  /// realisations (Quenouille, Tukey 1958): of the scatter between surfaces and of the rays. It is infinite where there
  /// are not two that tell. Of a given surface it is that of the rays.
  Measured estimate(const std::vector<std::size_t>& columns, const Function& f) const;

  /// The part of the error that is the rays' alone, for what a surface as a whole fixes: from the differences of the
  /// halves, by linear propagation.
  Measured estimate_of_rays(const std::vector<std::size_t>& columns, const Function& f) const;

  /// sums[0] / sums[1].
  static double ratio(std::span<const double> sums) { return sums[0] / sums[1]; }

private:
  std::span<const double> row(std::size_t tile, std::size_t which) const;
  std::vector<double> total(const std::vector<std::size_t>& columns) const;

  std::size_t width_;
  Drawn drawn_;
  bool keep_tiles_;
  std::vector<double> realisations_; ///< a row each
  std::size_t first_ = 0;            ///< tile of the realisation
  std::vector<double> sums_;
  std::vector<char> done_; // not bool: threads write neighbours
};

} // namespace brdfplot::simulation
