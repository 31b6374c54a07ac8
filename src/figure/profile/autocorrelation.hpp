/// \file
/// The autocorrelation of a surface's heights as a panel, beside the surface in profile.
#pragma once

#include "figure/description.hpp"

#include <optional>

namespace brdfplot::plot {

/// What is wrong, if anything is; the key may go on into the surface ("surface/alpha").
std::optional<ParameterError> problem_of(const AutocorrelationDescription& description);

/// Series "measured", at whole numbers of facets within the range of x, and where it is known the law with which the
/// surface was made. \throws InputError
Panel autocorrelation_panel(const PanelDescription& description);

} // namespace brdfplot::plot
