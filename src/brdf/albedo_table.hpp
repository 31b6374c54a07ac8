/// \file
/// Tables of directional albedo.
#pragma once

#include "math/quadrature.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace brdfplot {

/// E(mu), the directional albedo as a function of the cosine mu of the viewer's polar angle, for up to three channels:
/// piecewise polynomials in sqrt(mu), through Chebyshev nodes, on pieces that are halved until their last coefficients
/// are below the tolerance.
class AlbedoTable {
public:
  /// E of each channel with its error, at a mu in (0, 1).
  using Albedo = std::function<ColourEstimate(double mu)>;

  AlbedoTable() = default;
  AlbedoTable(std::size_t channels, const Albedo& albedo, double tolerance);

  /// E(mu), mu in [0, 1].
  double albedo(std::size_t channel, double mu) const;
  /// 1 - E(mu), what is not reflected; 0 where E is above 1 by no more than its error.
  double loss(std::size_t channel, double mu) const;
  /// 1 - mean E = 2 int (1 - E) mu dmu over [0, 1] (cf. Kelemen and Szirmay-Kalos 2001, Eq. 5).
  double mean_loss(std::size_t channel) const { return mean_loss_[channel]; }
  double mean(std::size_t channel) const { return 1 - mean_loss_[channel]; }

  std::size_t channels() const { return channels_; }
  /// Bound of the error of E: of the integrals at the nodes and of what lies between.
  double error() const { return error_; }
  /// The largest value at a node, and the mu that it was found at.
  double largest() const { return largest_; }
  double mu_of_largest() const { return mu_of_largest_; }

private:
  static constexpr std::size_t nodes = 16;
  using Coefficients = std::array<double, nodes>;

  /// [from, to] of sqrt(mu).
  struct Piece {
    double from, to;
    std::array<Coefficients, 3> of_channel;
  };

  void add(double from, double to, const Albedo& albedo, double tolerance);
  const Piece& piece_at(double t) const;

  std::size_t channels_ = 0;
  std::vector<Piece> pieces_;
  std::array<double, 3> mean_loss_{};
  double error_ = 0, largest_ = 0, mu_of_largest_ = 0;
};

} // namespace brdfplot
