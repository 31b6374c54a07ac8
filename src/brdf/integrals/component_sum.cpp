#include "brdf/integrals/component_sum.hpp"

#include <utility>

namespace brdfplot {

NormalIntegrand share_of(const Distribution& distribution, const Component& component, NormalIntegrand integrand) {
  if (component.weight == 1) return integrand;
  return [&distribution, component, integrand = std::move(integrand)](const std::vector<Direction>& normals,
                                                                      std::vector<double>& values) {
    integrand(normals, values);
    const std::size_t n = normals.size();
    for (std::size_t k = 0; k < n; ++k) {
      const double part = component.density(normals[k]);
      const double share =
          part > 0 ? part / std::visit([&](const auto& d) { return d.density(normals[k]); }, distribution) : 0;
      for (std::size_t at = k; at < values.size(); at += n)
        values[at] = part > 0 && values[at] != 0 ? values[at] * share : 0;
    }
  };
}

} // namespace brdfplot
