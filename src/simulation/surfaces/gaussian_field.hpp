/// \file
/// Periodic Gaussian random fields by spectral synthesis, whose facets have exactly the slopes that are asked.
#pragma once

#include <cstdint>
#include <vector>

namespace brdfplot::simulation {

/// Of the two components of a slope.
struct Covariance {
  double xx = 0;
  double xy = 0;
  double yy = 0;
};

/// Shapes of an autocorrelation over rho, the distance in correlation lengths: exp(-rho^2), exp(-rho).
enum class Autocorrelation { gaussian, exponential };

struct FieldRequest {
  int nx = 0;
  int ny = 0;
  Autocorrelation autocorrelation = Autocorrelation::gaussian;
  /// In cells, along the axis of the steepest slopes. Along the other one it follows from the slopes.
  double correlation_length = 0;
  Covariance slopes; ///< of the facets, as differences of neighbouring heights; positive definite
};

/// Heights in cells, at [iy * nx + ix], and their root mean square.
struct Field {
  std::vector<double> heights;
  double rms_height = 0;
};

/// A realisation of a stationary Gaussian field, h = sum_k A_k cos(k.x + phi_k): the amplitudes are those of the
/// spectrum, pi L^2 exp(-k^2 L^2 / 4) or 2 pi L^2 (1 + k^2 L^2)^(-3/2), the phases uniform. So the mean squares of
/// heights and slopes are those asked in every realisation, not only on average; heights and slopes are Gaussian by the
/// number of waves, about (side / L)^2.
///
/// A facet's slope is a difference over a cell, whose variance falls short of the derivative's by a quarter of
/// (cell / L)^2; the spectrum of the differences is known, sum_k A_k^2 |e^(ik) - 1|^2 / 2 and alike, and height and
/// anisotropy are solved for until it is what is asked (to 1e-10). With an exponential autocorrelation the derivative
/// has no variance at all, and the cell is part of what is asked.
///
/// Depends on the request, seed and realisation alone.
Field gaussian_field(const FieldRequest& request, std::uint64_t seed, std::uint64_t realisation);

} // namespace brdfplot::simulation
