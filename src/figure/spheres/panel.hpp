/// \file
/// A lit sphere as a panel: its picture, and the radiance along one diameter for the CSV.
#pragma once

#include "figure/description.hpp"

#include <optional>

namespace brdfplot::plot {

inline constexpr int fewest_pixels = 16, most_pixels = 2048; ///< along each side

/// What is wrong with a sphere, if anything is. The material is built where its settings have been tried.
std::optional<ParameterError> problem_of(const SphereDescription& sphere);

/// The radius of a sphere, in sides of its picture: some ground is seen about it.
inline constexpr double radius_in_picture = 0.46;

/// A sphere seen along z from far away (parallel projection), in sRGB. Pixels at its edge are shaded by the distance of
/// their middle from it. Where there is an environment, it is seen around the sphere (blended as linear light); else
/// the picture is transparent there.
/// Radiance at the middles of pixels, at those of the edge in the middle of the part that is covered; see radiance()
/// for its error. Material and lights of one channel give grey.
/// The series `radiance` (or r, g and b) are linear, before the exposure, along the diameter towards the first light
/// that has a direction (else to the right), x from -1 to 1. A note tells which share of the pixels is cut at white.
/// \throws InputError, AccuracyError
Panel sphere_panel(const PanelDescription& description, int threads);

} // namespace brdfplot::plot
