/// \file
/// Integrals over the facets by a rule that shares no code with the library's: no charts, no declared kinks, no
/// Gauss-Kronrod pairs. Only the integrand is the library's, whose values at single directions other tests compare with
/// multiprecision.
#pragma once

#include "brdf/evaluate.hpp"
#include "brdf/integrals/components.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace test {

/// What a rule found: the integral, and the sum of what its acceptances left open.
struct RayIntegral {
  double value = 0;
  double doubt = 0;
  std::size_t evaluations = 0;
};

/// f at n facets, per solid angle of the facet.
using FacetFunction = std::function<void(const std::vector<brdfplot::Direction>& facets, std::vector<double>& values)>;

/// The integral of f over the facets for which `inside` holds, about the mean facet of `map`, about which they are
/// star-shaped. Rays of slopes, mean + r L (cos psi, sin psi): the end of each by bisection of `inside`; along each,
/// panels that grow from the centre like r and shrink towards its end; over psi, panels that shrink towards the axes
/// of L and the azimuths of omega_o. On every panel Lobatto's rule of 10 nodes is compared with itself on both
/// halves, and accepted where they differ by less than `tolerance` shares; else the halves are taken for panels. Panels
/// along the rays begin in so many `parts`: where f is like a root along a curve that some rays just touch, only they
/// see what lies between.
RayIntegral integrate_rays(const brdfplot::SlopeMap& map, const brdfplot::Direction& omega_o,
                           const std::function<bool(const brdfplot::Direction& facet)>& inside, const FacetFunction& f,
                           double tolerance, int parts = 1);

} // namespace test
