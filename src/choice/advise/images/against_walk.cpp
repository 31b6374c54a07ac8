#include "choice/advise/images/against_walk.hpp"

#include "base/errors.hpp"
#include "brdf/evaluate.hpp"
#include "simulation/walk.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

namespace {

using simulation::Measured;

constexpr std::size_t walked_places = 8, walked_paths = 16384;

bool is_bounce(const TermDescription& term) { return term.type == "multiple_bounce" || term.type == "turquin"; }

/// Both terms, without weights, and the first one alone.
struct Bounced {
  MaterialDescription both, first;
};

std::optional<Bounced> bounced_of(const MaterialDescription& full) {
  const auto bounce = std::ranges::find_if(full.terms, is_bounce);
  if (bounce == full.terms.end() || bounce->of_name.empty()) return std::nullopt;
  const auto first = std::ranges::find(full.terms, bounce->of_name, &TermDescription::name);
  if (first == full.terms.end() || first->type != "mirror") return std::nullopt;
  std::vector<TermDescription> terms = {*first, *bounce};
  for (TermDescription& term : terms) {
    term.weight = 1.0;
    term.layers.clear();
  }
  return Bounced{{full.name, terms, true}, {full.name, {terms[0]}, true}};
}

/// Lit places at the middles of equal shares of what is lit.
std::vector<sphere::Place> spread_places(const Reference& reference) {
  const Places& places = reference.renderer->places();
  const std::size_t n = places.at.size();
  double lit = 0;
  const auto is_lit = [&](std::size_t k) { return luminance(colour_at(reference.picture, n, k)) > 0; };
  for (std::size_t k = 0; k < n; ++k) lit += is_lit(k) ? places.share[k] : 0;
  std::vector<sphere::Place> out;
  double sum = 0;
  for (std::size_t k = 0; k < n && out.size() < walked_places; ++k) {
    if (!is_lit(k)) continue;
    sum += places.share[k];
    if (sum > lit * (static_cast<double>(out.size()) + 0.5) / walked_places) out.push_back(places.at[k]);
  }
  return out;
}

/// Directions at a place, and what comes from each.
struct Lit {
  Direction omega_o;
  std::vector<Direction> omega_i;
  std::vector<Rgb> irradiance;
};

Lit lit_at(const AdviceScene& scene, const sphere::Place& place) {
  const std::array<sphere::Place, 1> places = {place};
  sphere::Frames frames(places);
  Lit out{frames.omega_o(0), {}, {}};
  for (const AdviceLight& light : scene.lights) {
    frames.set_light(from_angles(light.theta, light.phi));
    if (!(frames.omega_i()[0].z > 0)) continue;
    out.omega_i.push_back(frames.omega_i()[0]);
    out.irradiance.push_back(light.irradiance.value);
  }
  return out;
}

/// Of one channel: what the walk sends to the viewer.
Measured walked(const Material& material, const Lit& lit, std::size_t channel, std::size_t seed, int threads) {
  simulation::WalkRequest request{.omega_o = lit.omega_o, .omega_i = lit.omega_i};
  request.paths = walked_paths;
  request.seed = seed;
  request.threads = threads;
  request.channel = channel;
  const auto lobe = walk(material, simulation::Facets::conductor, request).lobe_of(1, simulation::bounce_classes);
  std::vector<double> sums(lobe.count());
  for (std::size_t k = 0; k < sums.size(); ++k)
    for (std::size_t d = 0; d < lit.omega_i.size(); ++d)
      sums[k] += lobe.values[k * lobe.points + d] * lit.irradiance[d][channel];
  return simulation::mean_of(sums);
}

double computed(const Material& material, const Lit& lit, std::size_t channel) {
  const auto channels = static_cast<std::size_t>(channels_of(material, Quantity::brdf_cos));
  double sum = 0;
  for (std::size_t d = 0; d < lit.omega_i.size(); ++d) {
    const Direction &o = lit.omega_o, &i = lit.omega_i[d];
    std::array<double, 3> rho{};
    evaluate(material, Quantity::brdf_cos, {1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, {}}, rho.data());
    sum += rho[channels > 1 ? channel : 0] * lit.irradiance[d][channel];
  }
  return sum;
}

} // namespace

std::optional<AgainstWalk> against_walk(const AdviceScene& scene, const MaterialDescription& full,
                                        const Reference& reference, int threads) {
  const std::optional<Bounced> bounced = bounced_of(full);
  if (!bounced) return std::nullopt;
  const Material both = build(bounced->both), first = build(bounced->first);
  AgainstWalk out;
  double sum = 0, sum_walked = 0, variance = 0;
  try {
    for (const sphere::Place& place : spread_places(reference)) {
      const Lit lit = lit_at(scene, place);
      if (lit.omega_i.empty()) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const Measured walk = walked(first, lit, c, out.places + 1, threads);
        const double here = computed(both, lit, c), relative = here / walk.value - 1;
        sum += here;
        sum_walked += walk.value;
        variance += walk.standard_error * walk.standard_error;
        if (!(std::fabs(relative) > std::fabs(out.largest.value))) continue;
        out.largest = {relative, walk.standard_error / walk.value};
        out.where = place;
      }
      ++out.places;
    }
  } catch (const InputError&) {
    return std::nullopt; // a surface that no walk knows
  }
  if (out.places == 0) return std::nullopt;
  out.light = {sum / sum_walked - 1, std::sqrt(variance) / sum_walked};
  return out;
}

} // namespace brdfplot::choice
