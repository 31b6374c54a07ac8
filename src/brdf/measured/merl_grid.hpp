/// \file
/// The cells of a MERL file.
#pragma once

#include "math/half_difference.hpp"

#include <cstddef>

namespace brdfplot {

/// Cells of half and difference angles (Matusik, Pfister, Brand, McMillan 2003): theta_h in [0, pi/2] by its square
/// root, so that they are narrow about the normal, theta_d in [0, pi/2] and phi_d in [0, pi) evenly; the other half of
/// phi_d is theirs by reciprocity. MERL's own files have 90, 90 and 180; the same formulas hold for any numbers.
struct MerlGrid {
  std::size_t theta_h = 90, theta_d = 90, phi_d = 180;

  std::size_t cells() const { return theta_h * theta_d * phi_d; }
  /// phi_d runs fastest, theta_h slowest.
  std::size_t index(std::size_t h, std::size_t d, std::size_t p) const { return (h * theta_d + d) * phi_d + p; }
  /// The cell in which a pair above the horizon lies.
  std::size_t cell_of(const HalfDifference& at) const;
  std::size_t index_of_theta_d(double angle) const;
  std::size_t index_of_phi_d(double angle) const; ///< of [-pi, pi]

  /// Angles at fractional coordinates: whole numbers are the edges of cells, halves their centres.
  double theta_h_at(double h) const;
  double theta_d_at(double d) const;
  double phi_d_at(double p) const;
};

/// Of one cell.
class MerlCell {
public:
  MerlCell(const MerlGrid& grid, std::size_t index);

  std::size_t h = 0, d = 0, p = 0;

  /// Whether a pair in it has both directions above the horizon, and whether every pair does: cos theta of the lower of
  /// the two is cos theta_h cos theta_d - sin theta_h sin theta_d |cos phi_d|, which falls along each of the three.
  bool reaches_above() const { return cosine(0) > horizon; }
  bool is_above() const { return cosine(2) > horizon; }
  /// The pair that stands for it: that at its centre; where this is below the horizon, one half way along the line from
  /// the highest corner to where it meets the horizon. Only where it reaches_above().
  HalfDifference sample() const;

private:
  static constexpr double horizon = 1e-12;

  /// t = 0: at the highest corner; 1: at the centre; 2: at the lowest corner.
  HalfDifference at(double t) const;
  double cosine(double t) const;

  MerlGrid grid_;
};

} // namespace brdfplot
