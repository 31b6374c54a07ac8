/// \file
/// Tables of directional albedo.
#pragma once

#include "math/direction.hpp"
#include "math/quadrature.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace brdfplot {

/// E(omega), the directional albedo of what has the planes y = 0 and x = 0 for mirrors, for up to three channels:
/// piecewise polynomials in sqrt(cos theta) and in cos 2 phi, through Chebyshev nodes. Pieces are halved, and get more
/// nodes in cos 2 phi, until their last coefficients are below the tolerance. What is isotropic has one node there, and
/// is cut besides where it is not smooth: at given cosines, and ever finer towards the normal, where masking by a fit
/// may have a root.
class AlbedoTable {
public:
  /// E of each channel with its error, at a direction above the horizon.
  using Albedo = std::function<ColourEstimate(const Direction& omega)>;

  AlbedoTable() = default;
  /// `cuts` are cosines in (0, 1) at which E jumps or bends, for what is isotropic.
  AlbedoTable(std::size_t channels, bool isotropic, const Albedo& albedo, double tolerance,
              const std::vector<double>& cuts = {});

  /// E(omega), omega above the horizon.
  double albedo(std::size_t channel, const Direction& omega) const;
  /// 1 - E(omega), what is not reflected; 0 where E is above 1 by no more than its error.
  double loss(std::size_t channel, const Direction& omega) const;
  /// 1 - mean E, the mean over the hemisphere weighted by cos / pi (cf. Kelemen and Szirmay-Kalos 2001, Eq. 5).
  double mean_loss(std::size_t channel) const { return mean_loss_[channel]; }
  double mean(std::size_t channel) const { return 1 - mean_loss_[channel]; }

  std::size_t channels() const { return channels_; }
  bool isotropic() const { return isotropic_; }
  /// Bound of the error of E: of the integrals at the nodes and of what lies between.
  double error() const { return error_; }
  /// The largest value at a node, and the direction that it was found at.
  double largest() const { return largest_; }
  const Direction& where_largest() const { return where_largest_; }

private:
  static constexpr std::size_t nodes = 16;
  using Coefficients = std::array<double, nodes>; ///< in sqrt(cos theta)

  /// [from, to] of sqrt(cos theta): coefficients in cos 2 phi of coefficients in sqrt(cos theta).
  struct Piece {
    double from, to;
    std::array<std::vector<Coefficients>, 3> of_channel;
  };

  void add(double from, double to, std::size_t azimuths, const Albedo& albedo, double tolerance);
  Piece sampled(double from, double to, std::size_t azimuths, const Albedo& albedo, double& worst);
  const Piece& piece_at(double t) const;

  std::size_t channels_ = 0;
  bool isotropic_ = true;
  std::vector<Piece> pieces_;
  std::array<double, 3> mean_loss_{};
  double error_ = 0, largest_ = 0;
  Direction where_largest_{0, 0, 1};
};

} // namespace brdfplot
