/// \file
/// A microsurface in profile as a panel: what is drawn of it, in which parts, and what is measured on it.
#pragma once

#include "figure/description.hpp"
#include "figure/profile/surface.hpp"

#include <string>
#include <vector>

namespace brdfplot::plot {

/// What a profile's arrows may be.
const std::vector<std::string>& profile_arrows();

/// What may be measured: `g1`, the visible share of the facets that face omega_o, beside the model's; `g2`, the visible
/// and lit share of those that face omega_o and omega_i, beside Smith's separable and height-correlated (Eqs. 98, 99);
/// `projected_area`, that of what is visible, beside the mesosurface's (Heitz 2014, Eqs. 10, 11); `autocorrelation` of
/// heights at the correlation length; `theta_m` of V-cavities.
const std::vector<std::string>& profile_numbers();

/// What is wrong with a profile, if anything is; the key may go on into the surface ("surface/alpha").
std::optional<ParameterError> problem_of(const ProfileDescription& description);

/// The panel: series of equal sight ("visible", "masked", ...) as polylines, rounded to millionths of a facet.
/// \throws InputError
Panel profile_panel(const PanelDescription& description);

} // namespace brdfplot::plot
