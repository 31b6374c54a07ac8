/// \file
/// The parts of a distribution, each with a frame of slopes of its own.
#pragma once

#include "analysis/slope_domain.hpp"

#include <vector>

namespace brdfplot {

/// A distribution D_k in a sum of w_k D_k.
struct Component {
  double weight = 1;
  Distribution distribution;

  const SlopeMap& slopes() const;
};

/// What a distribution is a sum of: the parts of a mixture, else itself.
std::vector<Component> components(const Distribution& distribution);

/// The share w_k D_k / D of an integrand that has D as a factor. The shares add up to the integrand, and each is narrow
/// in one place only, which its own frame knows: an integral over all of them finds the peak of a smooth part under the
/// tail of a rough one.
NormalIntegrand share_of(const Component& component, const Distribution& all, const NormalIntegrand& integrand);

} // namespace brdfplot
