/// \file
/// The formulas that a term without mirror facets asks a shader for, called with numbers that count.
#pragma once

#include "brdf/term.hpp"

namespace brdfplot::choice::forms {

/// Whether it is a function of the half vector, or of l.v.
bool needs_half_vector(const TermDescription& term);

/// What depends on the viewer alone, and rho of each channel. \throws InputError for a term without a form
void flat_view(const TermDescription& term);
void flat_light(const TermDescription& term);

} // namespace brdfplot::choice::forms
