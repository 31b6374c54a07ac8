/// \file
/// Directions over arrays of pairs. Like kernels.hpp, which says what holds of every kernel.
#pragma once

#include "math/kernels/kernels.hpp"

#include <cstddef>

namespace brdfplot::kernels {

/// The half vectors of unit vectors; 0 where they are undefined (i = -o). The same bytes on every instruction set.
void half_vectors(Vectors<double> o, Vectors<double> i, double* x, double* y, double* z, std::size_t n);

/// u.v with the rounding of every step added at the end (Ogita, Rump, Oishi 2005): right where the two are all but
/// perpendicular, and the terms cancel. The same bytes on every instruction set.
void careful_dots(Vectors<double> u, Vectors<double> v, double* out, std::size_t n);

} // namespace brdfplot::kernels
