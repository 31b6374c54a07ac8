/// \file
/// Integrals of what has a density of normals as a factor, as a sum over the components of the distribution.
#pragma once

#include "brdf/integrals/components.hpp"
#include "integrate/slope_domain.hpp"

namespace brdfplot {

/// The sum of integral(component, frame, tolerance) over the components of a distribution, each in its frame.
template <class Function>
auto sum_over_components(const Distribution& distribution, const Direction& omega_o, double tolerance,
                         const Function& integral) {
  const auto parts = components(distribution);
  const double of_part = tolerance / static_cast<double>(parts.size());
  decltype(integral(parts[0], parts[0].seen_from(omega_o), tolerance)) sum;
  for (const Component& component : parts) sum.add(integral(component, component.seen_from(omega_o), of_part));
  return sum;
}

/// `integrand`, which has D as a factor, or where there are several components, the share w_k D_k / D of one of them.
/// A reference to `distribution` is kept.
NormalIntegrand share_of(const Distribution& distribution, const Component& component, NormalIntegrand integrand);

} // namespace brdfplot
