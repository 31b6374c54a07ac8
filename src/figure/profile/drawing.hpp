/// \file
/// What is drawn of a profile: its parts by what becomes of them, and the rays and arrows about it. The lower left
/// corner of what is drawn is the left end of the mesosurface.
#pragma once

#include "figure/description.hpp"
#include "figure/profile/profile.hpp"

#include <vector>

namespace brdfplot::plot {

/// A value to millionths (of a facet): the last bits of a Fourier transform may differ between machines.
double rounded_coordinate(double value);

/// The parts of the surface that are visible, masked, and so on: polylines, broken by NaN in y.
std::vector<Series> parts_of(const ProfileDescription& description, const Profile& profile);

/// What stands about them.
Sketch sketch_of(const ProfileDescription& description, const Profile& profile);

} // namespace brdfplot::plot
