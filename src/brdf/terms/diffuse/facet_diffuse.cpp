#include "brdf/terms/diffuse/facet_diffuse.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "brdf/diffuse.hpp"

#include <algorithm>

namespace brdfplot {

FacetDiffuse FacetDiffuse::from(const TermDescription& description) {
  return {build_microsurface(description), Colour::from(completed_values<FacetDiffuse>(description), "albedo")};
}

Estimate FacetDiffuse::brdf(const Direction& omega_o, const Direction& omega_i, const Tolerance& tolerance) const {
  return diffuse_brdf(surface, omega_o, omega_i, tolerance);
}

void FacetDiffuse::evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
  constexpr double accepted = 1e-9;
  for (std::size_t k = 0; k < block.n; ++k) {
    const Direction i = block.i[k];
    const Estimate rho = brdf(block.o[k], i, {.relative = 1e-10});
    if (!(rho.error <= accepted * std::fabs(rho.value)))
      throw AccuracyError("brdf", "reached an error estimate of " + format_number(rho.error) + " for a value of " +
                                      format_number(rho.value) + " (asked: a relative error of 1e-9)");
    const double value = rho.value * (block.times_cosine ? std::max(0.0, surface.slopes().project(i).c) : 1);
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels()); ++c) out.rho[c][k] = albedo.value[c] * value;
  }
}

} // namespace brdfplot
