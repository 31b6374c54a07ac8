/// \file
/// A density on a line that is known at nodes, and the inverse of its cumulative distribution.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace brdfplot {

/// A density in pieces, each the polynomial through its values at Gauss's nodes.
class PiecewiseDensity {
public:
  static constexpr std::size_t nodes = 8;

  /// From x = from to x = to. With `root` the density leaves its value at `from` like a power of sqrt(x - from), and
  /// the polynomial is one in that root.
  struct Piece {
    double from = 0, to = 0;
    bool root = false;
    std::array<double, nodes> values{}; ///< at node(0) ... node(nodes - 1)

    double node(std::size_t k) const;
    double integral() const;
  };

  /// Pieces must be added from left to right; one may start beyond the end of the last.
  void add(const Piece& piece);
  double total() const { return ends_.empty() ? 0 : ends_.back(); }
  /// x below which a share u of the whole lies, u in [0, 1). \pre total() > 0
  double inverse(double u) const;

private:
  std::vector<Piece> pieces_;
  std::vector<double> ends_; ///< the integral up to the end of each piece
};

} // namespace brdfplot
