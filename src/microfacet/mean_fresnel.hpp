/// \file
/// The mean of a Fresnel term over the hemisphere.
#pragma once

#include "math/quadrature.hpp"
#include "microfacet/fresnel.hpp"

#include <cstddef>

namespace brdfplot {

/// 2 int F(mu) mu dmu over [0, 1], what facets reflect of uniform light (Heitz 2014, Eq. 105; Akenine-Moller et al.
/// 2018, Eq. 9.58), by quadrature to 1e-13, cut where F declares a critical angle. The error bounds the true one.
Estimate mean_fresnel(const Fresnel& fresnel, std::size_t channel);

} // namespace brdfplot
