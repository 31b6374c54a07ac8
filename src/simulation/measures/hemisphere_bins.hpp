/// \file
/// A hemisphere cut into bins of theta and phi.
#pragma once

#include "math/direction.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace brdfplot::simulation {

/// n rings of equal width in theta, each of 4 n bins in phi, which count from the positive x axis.
class HemisphereBins {
public:
  explicit HemisphereBins(std::size_t rings) : rings_(rings), sectors_(4 * rings) {}

  std::size_t count() const { return rings_ * sectors_; }

  std::size_t of(const Direction& omega) const {
    const double theta = std::acos(std::clamp(omega.z, 0.0, 1.0));
    const double phi = std::atan2(omega.y, omega.x);
    const auto ring = static_cast<std::size_t>(theta / ring_width());
    const auto sector = static_cast<std::size_t>((phi < 0 ? phi + 2 * std::numbers::pi : phi) / sector_width());
    return std::min(ring, rings_ - 1) * sectors_ + std::min(sector, sectors_ - 1);
  }
  double theta(std::size_t bin) const { return (ring_of(bin) + 0.5) * ring_width(); }
  double phi(std::size_t bin) const { return (static_cast<double>(bin % sectors_) + 0.5) * sector_width(); }
  double solid_angle(std::size_t bin) const {
    const double ring = ring_of(bin);
    return (std::cos(ring * ring_width()) - std::cos((ring + 1) * ring_width())) * sector_width();
  }

private:
  double ring_of(std::size_t bin) const {
    const std::size_t ring = bin / sectors_;
    return static_cast<double>(ring);
  }
  double ring_width() const { return std::numbers::pi / 2 / static_cast<double>(rings_); }
  double sector_width() const { return 2 * std::numbers::pi / static_cast<double>(sectors_); }
  std::size_t rings_;
  std::size_t sectors_;
};

} // namespace brdfplot::simulation
