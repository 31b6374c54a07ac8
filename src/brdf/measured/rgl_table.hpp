/// \file
/// Reflectance measured in the adaptive parameterisation of Dupuy and Jakob 2018, and its file.
#pragma once

#include "math/direction.hpp"
#include "models/parameters.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace brdfplot {

class TensorFile;

/// Numbers on a grid over the unit square, bilinear between them; the index of x runs fastest.
class Bilinear {
public:
  Bilinear() = default;
  Bilinear(std::size_t nx, std::size_t ny, std::vector<float> values) : nx_(nx), ny_(ny), values_(std::move(values)) {}

  std::size_t nx() const { return nx_; }
  std::size_t ny() const { return ny_; }
  /// `slice`: which of several grids that follow each other.
  double at(const Vec2& u, std::size_t slice = 0) const;
  const float* row(std::size_t slice, std::size_t y) const { return &values_[(slice * ny_ + y) * nx_]; }

private:
  std::size_t nx_ = 0, ny_ = 0;
  std::vector<float> values_;
};

/// A BRDF as the file has it. The unit square stands for directions by u = (sqrt(2 theta / pi), (phi + pi) / (2 pi)),
/// phi that of a half vector from that of omega_i where the file is isotropic. With D the distribution of normals of
/// the microsurface, sigma its projected area and V the visible normals as seen from omega_i (over u, and per slice of
/// phi_i and theta_i, between which everything is linear),
///   rho(o, i) cos theta_o = D(h) / (4 sigma(i)) M(s),  s the place to which the distribution function of V takes h:
/// s_y that of the marginal of V over rows, s_x that of the row; M is the array "rgb". Outside the range of theta_i its
/// nearest end counts. M below 0, where a colour is outside the gamut of sRGB, counts as 0.
class RglTable {
public:
  /// rho cos theta_o in three channels; both directions above the horizon.
  Rgb value(const Direction& omega_i, const Direction& omega_o) const;
  /// Whether it is tabulated for one azimuth of omega_i only.
  bool isotropic() const { return phi_i_.size() == 1; }

  /// Where the distribution function of V takes the place u of a half vector: [0, 1]^2 to itself.
  Vec2 placed(const Direction& omega_i, const Vec2& u) const;
  /// The place of a half vector, as seen from omega_i.
  Vec2 place_of(const Direction& h, const Direction& omega_i) const;

private:
  friend RglTable read_rgl(const std::string& path);
  /// What a slice counts of those that are tabulated for directions omega_i.
  struct Share {
    std::size_t slice = 0;
    double weight = 0;
  };
  using Shares = std::array<Share, 4>;

  void check_axes(const TensorFile& file);
  void normalise(const TensorFile& file, std::vector<float> values, std::size_t nx, std::size_t ny);
  Shares shares(const Direction& omega_i) const;
  Vec2 placed(const Shares& shares, const Vec2& u) const;

  std::vector<float> phi_i_, theta_i_;
  bool relative_ = true; ///< azimuths of half vectors are those from omega_i's
  double middle_ = 0;    ///< of the azimuths of a file that has a half or a quarter of them
  int copies_ = 1;       ///< of what it has, that make the whole: 1, 2 or 4
  Bilinear ndf_, sigma_, vndf_, rgb_;
  std::vector<double> row_sums_, marginal_; ///< of vndf_, by slice: integral of each row, and of those before it
};

/// Reads a .bsdf of the RGL database, or one with nothing but what is used of it: arrays of floats phi_i, theta_i, ndf
/// and sigma [y, x], vndf [phi_i, theta_i, y, x] and rgb [phi_i, theta_i, 3, y, x], and the byte jacobian, 1. phi_i has
/// one or two values (isotropic), or spans the circle, a half of it (which is turned about the normal into the other
/// one) or a quarter (which is mirrored). Lengths and places are compared with the file's before memory is taken.
/// \throws FileError: cannot be read, or there is no memory; InputError: what is wrong
RglTable read_rgl(const std::string& path);

} // namespace brdfplot
