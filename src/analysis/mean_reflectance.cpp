#include "analysis/mean_reflectance.hpp"

#include "brdf/blocks/surface_quantities.hpp"
#include "brdf/blocks/viewer_rows.hpp"
#include "brdf/integrals/component_sum.hpp"
#include "brdf/integrals/kinks.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace brdfplot {

Estimate mean_visible_reflectance(const WeightedTerm& term, const Direction& omega_o, double tolerance,
                                  std::size_t channel) {
  const Microsurface& surface = *term.surface();
  const Fresnel& fresnel = *term.fresnel();
  const Direction& o = omega_o;
  ViewerRows rows(o);
  std::vector<double> cosine, reflectance;
  const NormalIntegrand integrand = [&](const std::vector<Direction>& m, std::vector<double>& out) {
    const Batch batch = rows.with_normals(m.size(), [&](std::size_t k) { return m[k]; });
    evaluate(surface, Quantity::d_visible, batch, out.data());
    cosine.resize(m.size());
    reflectance.resize(m.size());
    for (std::size_t k = 0; k < m.size(); ++k) cosine[k] = std::clamp(dot(o, m[k]), 0.0, 1.0);
    std::visit([&](const auto& f) { f.reflectances(cosine.data(), channel, reflectance.data(), m.size()); }, fresnel);
    for (std::size_t k = 0; k < m.size(); ++k) out[k] *= reflectance[k];
  };
  const bool line = has_masking_line(surface);
  std::vector<Switch> switches = masking_kinks(surface, o);
  std::ranges::move(fresnel_kinks(fresnel, o, {channel, 1}), std::back_inserter(switches));
  const bool symmetric = surface.has_lambda() || line || is_mirrored(surface, o);
  return sum_over_components(
      surface.distribution, o, tolerance, [&](const auto& component, const auto& frame, double asked) {
        return integrate_facing(
            frame, {share_of(surface.distribution, component, integrand), switches, line, symmetric}, asked);
      });
}

} // namespace brdfplot
