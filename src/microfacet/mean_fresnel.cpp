#include "microfacet/mean_fresnel.hpp"

#include <vector>

namespace brdfplot {

Estimate mean_fresnel(const Fresnel& fresnel, std::size_t channel) {
  return std::visit(
      [&](const auto& term) {
        std::vector<double> cuts = {0, 1};
        if constexpr (requires { term.critical_cosine(channel); })
          if (const auto critical = term.critical_cosine(channel); critical && *critical > 0 && *critical < 1)
            cuts.insert(cuts.begin() + 1, *critical);
        const auto integrand = [&](const double* mu, double* y, std::size_t n) {
          term.reflectances(mu, channel, y, n);
          for (std::size_t k = 0; k < n; ++k) y[k] *= 2 * mu[k];
        };
        return integrate(integrand, cuts, {.absolute = 1e-13});
      },
      fresnel);
}

} // namespace brdfplot
