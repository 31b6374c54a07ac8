#include "analysis/components.hpp"

namespace brdfplot {

const SlopeMap& Component::slopes() const {
  return std::visit([](const auto& d) -> const SlopeMap& { return d.slopes; }, distribution);
}

std::vector<Component> components(const Distribution& distribution) {
  return std::visit(
      []<class D>(const D& d) {
        std::vector<Component> all;
        if constexpr (requires { d.parts; })
          for (const auto& part : d.parts)
            std::visit([&](const auto& of_part) { all.push_back({part.weight, of_part}); }, part.distribution);
        else
          all.push_back({1, d});
        return all;
      },
      distribution);
}

NormalIntegrand share_of(const Component& component, const Distribution& all, const NormalIntegrand& integrand) {
  return [&component, &all, &integrand](const std::vector<Direction>& normals, std::vector<double>& values) {
    integrand(normals, values);
    const auto density = [](const Distribution& of, const Direction& m) {
      return std::visit([&](const auto& d) { return d.density(m); }, of);
    };
    for (std::size_t k = 0; k < normals.size(); ++k) {
      const double part = component.weight * density(component.distribution, normals[k]);
      values[k] = part > 0 && values[k] != 0 ? values[k] * (part / density(all, normals[k])) : 0;
    }
  };
}

} // namespace brdfplot
