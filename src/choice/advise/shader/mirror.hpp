/// \file
/// The formulas that a term of mirror facets asks a shader for, called with numbers that count.
#pragma once

#include "brdf/term.hpp"
#include "choice/advise/shader/forms.hpp"
#include "choice/methods/counted.hpp"

namespace brdfplot::choice::forms {

using Counted3 = Vector<Counted>;

/// Directions in the branches that take longest.
inline Counted3 viewer() { return {Counted(0.1), Counted(0.7), Counted(0.7)}; }
inline Counted3 light() { return {Counted(0.2), Counted(0.7), Counted(0.6)}; }

inline void read_table(std::size_t count) { Counted::operations().table_reads += count; }

/// 3 where a Fresnel term is coloured, else 1.
int channels_of(const ModelChoice& fresnel);
/// Schlick's term with f90 = f0.
bool is_constant(const ModelChoice& fresnel);
/// F of each channel that it has; nothing of a constant.
void fresnel(const ModelChoice& of);

/// Of `mirror` and `kelemen`: what depends on the viewer alone, and rho / c_i of each channel.
void mirror_view(const TermDescription& term);
void mirror_light(const TermDescription& term);

} // namespace brdfplot::choice::forms
