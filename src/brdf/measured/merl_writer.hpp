/// \file
/// A material as a MERL file.
#pragma once

#include "brdf/material.hpp"
#include "brdf/measured/merl_table.hpp"

#include <string>

namespace brdfplot {

/// The bytes of a MERL file (see read_merl()) with the BRDF of a material: in each cell its value at the cell's
/// sample(), which is the centre where that is above the horizon; three equal channels of a material that has one. What
/// the format cannot say is an error: the material has to be isotropic, with a mesosurface that is not tilted, which is
/// known of its terms, and reciprocal, which is tried: rho(o, i) and rho(i, o) of every 101st cell may differ by 1e-6
/// of their sum. The same bytes for any number of threads.
/// \throws InputError, and what evaluate() throws
std::string merl_bytes(const Material& material, int threads, const MerlGrid& grid = {});

} // namespace brdfplot
