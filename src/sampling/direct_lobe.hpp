/// \file
/// Densities of the light that are about the normal and not about the half vector.
#pragma once

#include "brdf/material.hpp"
#include "sampling/facets.hpp"

#include <memory>

namespace brdfplot {

/// Directions omega_i above the horizon z = 0, drawn from one viewer above it.
class DirectLobe {
public:
  virtual ~DirectLobe() = default;
  virtual Direction sample(const Direction& omega_o, const SamplePoint& point) const = 0;
  /// 1/sr; 0 below the horizon of either.
  virtual double density(const Direction& omega_o, const Direction& omega_i) const = 0;
};

/// That of the term `eon`, for any term with its roughness (Portsmouth, Kutz and Hill 2024, section 5): Lambert's lobe
/// cut off by a plane and sheared by a matrix that is a fit in cos theta_o and the roughness, and the uniform density
/// with a chance that is a fit too. A closed form: exact whatever the fits are worth.
std::shared_ptr<const DirectLobe> eon_lobe(double roughness);

/// That of the term `complement`, where the albedo of the other term is the same for every azimuth: cos theta_i times
/// what is not reflected, 1 - E(theta_i), as a mean of channels, by the inverse of its cumulative distribution (Kelemen
/// and Szirmay-Kalos 2001, section 4; with the sine of the solid angle, which the printed integral lacks). The density
/// is a polynomial of degree 7 in sqrt(cos theta) on each of 64 pieces; its integral is 1 within 1e-9.
std::shared_ptr<const DirectLobe> matte_lobe(const TermAlbedo& other);

} // namespace brdfplot
