#include "brdf/terms/kelemen.hpp"

#include "base/number.hpp"
#include "brdf/blocks/surface_block.hpp"
#include "brdf/integrals/component_sum.hpp"

#include <cmath>
#include <utility>

namespace brdfplot {

namespace {

/// int D(m) dm over the hemisphere.
double solid_angle_integral(const Distribution& distribution) {
  constexpr double accepted = 1e-11;
  const Direction normal{0, 0, 1};
  const NormalIntegrand density = [&](const std::vector<Direction>& m, std::vector<double>& out) {
    for (std::size_t k = 0; k < m.size(); ++k)
      out[k] = std::visit([&](const auto& d) { return d.density(m[k]); }, distribution);
  };
  const Estimate whole = sum_over_components(
      distribution, normal, 0.1 * accepted, [&](const auto& component, const auto& frame, double asked) {
        return integrate_facing(frame, {share_of(distribution, component, density), {}, false, false}, asked);
      });
  if (!(whole.error <= accepted * whole.value))
    throw MaterialError("/density", "\"normalised\" needs the integral of D over solid angle, which has reached an "
                                    "error of " +
                                        format_number(whole.error) + " (asked: 1e-11); accepted: projected, d");
  return whole.value;
}

} // namespace

ModelSpec Kelemen2001::spec() {
  return {.type = "kelemen",
          .doc = "specular part of the coupled model: P(h) F / (2 (1 + o.i))",
          .source = "Kelemen and Szirmay-Kalos 2001, Eq. 3",
          .parameters = {{.key = "density",
                          .kind = ParameterKind::choice,
                          .fallback = std::string("projected"),
                          .doc = "what P is: D cos theta_h (the paper's), D over its integral, or D",
                          .choices = {"projected", "normalised", "d"}}}};
}

Kelemen2001 Kelemen2001::from(const TermDescription& description) {
  const Values values = completed_values<Kelemen2001>(description);
  const std::string& density = values.text("density");
  Kelemen2001 made{make_or_throw<Distribution>("distribution", description.distribution),
                   make_or_throw<Fresnel>("fresnel", description.fresnel), density == "projected", 1};
  const SlopeMap& slopes = std::visit([](const auto& d) -> const SlopeMap& { return d.slopes; }, made.distribution);
  if (!slopes.centred())
    throw MaterialError("/distribution/mean_slope", "found one in a term \"kelemen\"; accepted: none");
  if (density == "normalised") made.scale = 1 / solid_angle_integral(made.distribution);
  return made;
}

int Kelemen2001::channels() const {
  return std::visit([](const auto& f) { return f.coloured(); }, fresnel) ? 3 : 1;
}

void Kelemen2001::evaluate(const PairBlock& pairs, SurfaceBlock& work, const ChannelRows& out) const {
  SurfaceBlock own; // of the half vectors, where the rows have other normals
  if (!work.has_half) set_directions(own, pairs.n, pairs.o, pairs.i, {});
  SurfaceBlock& block = work.has_half ? work : own;
  if (!std::exchange(block.done.densities, true))
    std::visit([&](const auto& d) { d.densities(vectors(block.m), block.density.data(), pairs.n); }, distribution);
  compute_reflectances(fresnel, block);
  Buffer value;
  for (std::size_t k = 0; k < pairs.n; ++k) {
    const Direction sum = pairs.o[k] + pairs.i[k]; // |o + i|^2 = 2 (1 + o.i) = 4 (o.h)^2
    const double p = scale * block.density[k] * (with_cosine ? block.m.z[k] : 1);
    const bool lit = pairs.o.z[k] > 0 && pairs.i.z[k] > 0 && p > 0;
    value[k] = lit ? p / dot(sum, sum) * (pairs.times_cosine ? pairs.i.z[k] : 1) : 0;
  }
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels()); ++c)
    for (std::size_t k = 0; k < pairs.n; ++k) out.rho[c][k] = value[k] == 0 ? 0 : block.reflectances[c][k] * value[k];
}

} // namespace brdfplot
