/// \file
/// Sums kept apart by tiles of the surface, and what can be said from them with its error.
#pragma once

#include "simulation/statistics.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace brdfplot::simulation {

/// A row of sums for every tile, in two halves from independent rays. Rows are filled by any thread and added in their
/// order, so that the result does not depend on who filled them.
class Tally {
public:
  explicit Tally(std::size_t width = 0) : width_(width) {}

  void add_tiles(std::size_t count);
  std::size_t tiles() const { return done_.size(); }
  /// The sums of one half of a tile, to be added to.
  std::span<double> half(std::size_t tile, std::size_t which);
  /// A tile that is not marked does not count.
  void mark_done(std::size_t tile) { done_[tile] = 1; }

  using Function = std::function<double(std::span<const double> sums)>;

  /// A function, of degree 0 in the sums, of the given columns' totals. Its standard error is the jackknife's over the
  /// tiles (Quenouille, Tukey 1958): of the scatter between places of the surface and of the rays. It is infinite with
  /// fewer than two tiles. Tiles of one surface are taken for independent: they are many correlation lengths wide.
  Measured estimate(const std::vector<std::size_t>& columns, const Function& f) const;

  /// The part of the error that is the rays' alone, for what the surface as a whole fixes: from the differences of the
  /// halves, by linear propagation.
  Measured estimate_of_this_surface(const std::vector<std::size_t>& columns, const Function& f) const;

  /// sums[0] / sums[1].
  static double ratio(std::span<const double> sums) { return sums[0] / sums[1]; }

private:
  std::span<const double> half(std::size_t tile, std::size_t which) const;
  std::vector<double> total(const std::vector<std::size_t>& columns) const;

  std::size_t width_;
  std::vector<double> sums_;
  std::vector<char> done_; // not bool: threads write neighbours
};

} // namespace brdfplot::simulation
