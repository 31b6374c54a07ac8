#include "brdf/integrals/reflected_light.hpp"

#include "brdf/integrals/reflected_moments.hpp"

#include "brdf/blocks/viewer_rows.hpp"
#include "brdf/evaluate.hpp"
#include "brdf/integrals/component_sum.hpp"
#include "integrate/hemisphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

namespace brdfplot {

namespace {

/// How many channels a term has under its coats.
template <class T>
std::size_t channels_of(const T& term, const std::vector<Coat>& coats) {
  const bool coloured = std::ranges::any_of(coats, [](const Coat& coat) { return coat.channels() > 1; });
  return coloured ? 3 : static_cast<std::size_t>(term.channels());
}

/// Multiplies rho of all channels by what its coats let through.
void attenuate(const std::vector<Coat>& coats, const Batch& batch, std::size_t channels, std::vector<double>& all) {
  if (coats.empty()) return;
  for (std::size_t k = all.size(); k < channels * batch.n; ++k) all.push_back(all[k - batch.n]);
  const auto factor = let_through(coats, batch.o, batch.i, batch.n, static_cast<int>(channels));
  for (std::size_t k = 0; k < factor.size(); ++k) all[k] = all[k] == 0 ? 0 : all[k] * factor[k];
}

/// Of what is about the half vector: over the normals that reflect the viewer into the light. All channels of a weight
/// stand together; there are at most three results.
template <class T>
ColourEstimate over_half_vectors(const T& term, const std::vector<Coat>& coats, const Direction& o, double tolerance,
                                 const ChannelRange& channels, std::span<const LightWeight> weights) {
  ViewerRows rows(o);
  std::vector<double> all;
  const NormalIntegrand integrand = [&](const std::vector<Direction>& h, std::vector<double>& out) {
    const std::size_t n = h.size();
    const Batch batch = rows.with_lights(n, [&](std::size_t k) { return reflected(o, h[k]); });
    all.resize(static_cast<std::size_t>(term.channels()) * n);
    evaluate_term(term, true, batch, all.data());
    attenuate(coats, batch, channels_of(term, coats), all);
    for (std::size_t k = 0; k < n; ++k) {
      // d omega_i = 4 (o.h) d omega_h.
      const double jacobian = 4 * dot(o, h[k]);
      for (std::size_t j = 0; j < weights.size(); ++j) {
        const double w = weights[j](batch.i[k]);
        for (std::size_t c = 0; c < channels.count; ++c)
          out[(j * channels.count + c) * n + k] = all[(channels.first + c) * n + k] * jacobian * w;
      }
    }
  };
  HalfVectorKinks kinks = term.kinks(o, term.channels() > 1 ? channels : ChannelRange{0, 1});
  for (const Coat& coat : coats) std::ranges::move(coat.kinks(o), std::back_inserter(kinks.switches));
  const Distribution& facets = term.facets();
  return sum_over_components(facets, o, tolerance, [&](const auto& component, const SlopeFrame& frame, double asked) {
    return integrate_lit(frame,
                         {share_of(facets, component, integrand), channels.count * weights.size(), kinks.switches,
                          kinks.in_plane_of_incidence, kinks.symmetric},
                         asked);
  });
}

/// Writes rho of a term that is a quadrature under its coats, and its errors.
template <class T>
void write_quadratures(const T& term, const std::vector<Coat>& coats, const Batch& batch, const Tolerance& tolerance,
                       const ChannelRange& channels, std::vector<double>& value, std::vector<double>& error) {
  const auto factor = let_through(coats, batch.o, batch.i, batch.n, 3);
  for (std::size_t k = 0; k < batch.n; ++k) {
    const Estimate white = term.brdf(batch.o[k], batch.i[k], tolerance);
    for (std::size_t c = 0; c < channels.count; ++c) {
      const std::size_t channel = channels.first + c;
      const double scale = term.albedo.value[channel] * (coats.empty() ? 1 : factor[channel * batch.n + k]);
      value[c * batch.n + k] = scale * white.value;
      error[c * batch.n + k] = scale * white.error;
    }
    if (std::isinf(white.error)) return; // and so is what it is part of
  }
}

/// Of what is smooth on the scale of the hemisphere.
template <class T>
ColourEstimate over_hemisphere(const T& term, const std::vector<Coat>& coats, const Direction& o, double tolerance,
                               const ChannelRange& channels, const LightWeight& weight) {
  ViewerRows rows(o);
  std::vector<double> all;
  constexpr bool lit_from_below = requires { term.bends(); };
  HemisphereIntegrand f{{}, channels.count, true, lit_from_below, {}};
  if constexpr (lit_from_below) f.bends = term.bends();
  f.rho = [&](const std::vector<Direction>& lights, const Tolerance& asked, std::vector<double>& value,
              std::vector<double>& error) {
    const std::size_t n = lights.size();
    const Batch batch = rows.with_lights(n, [&](std::size_t k) { return lights[k]; });
    if constexpr (requires { term.brdf(o, lights[0], asked); }) {
      write_quadratures(term, coats, batch, asked, channels, value, error);
    } else {
      all.resize(static_cast<std::size_t>(term.channels()) * n);
      evaluate_term(term, lit_from_below, batch, all.data());
      attenuate(coats, batch, channels_of(term, coats), all);
      for (std::size_t k = 0; k < channels.count * n; ++k) {
        value[k] = all[channels.first * n + k];
        error[k] = 1e-14 * (std::fabs(value[k]) + 1);
      }
    }
  };
  SlopeMap map;
  if constexpr (requires { term.surface; }) {
    map = term.surface.slopes();
    f.symmetric = map.alpha_x == map.alpha_y && map.correlation == 0 && is_mirrored(term.surface, o);
  } else if constexpr (requires { term.isotropic(); }) {
    f.symmetric = term.isotropic();
  }
  return integrate_hemisphere(map, f, o, tolerance, weight);
}

/// Of a term that brings a rule: what its coats let through, of each channel, goes with the weight of the light.
template <class T>
ColourEstimate by_its_own_rule(const T& term, const std::vector<Coat>& coats, const Direction& o, double tolerance,
                               const ChannelRange& channels, const LightWeight& weight) {
  if (coats.empty()) return term.reflected_light(o, tolerance, channels, weight);
  ColourEstimate all;
  for (std::size_t c = 0; c < channels.count; ++c) {
    const std::size_t channel = channels.first + c;
    const LightWeight seen = [&](const Direction& i) {
      return weight(i) * let_through(coats, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, 1, 3)[channel];
    };
    const Estimate one = term.reflected_light(o, tolerance, {channel, 1}, seen).channel(0);
    all.value[c] = one.value;
    all.error[c] = one.error;
    all.evaluations += one.evaluations;
  }
  return all;
}

ColourEstimate under_coats(const BrdfTerm& term, const std::vector<Coat>& coats, const Direction& omega_o,
                           double tolerance, const ChannelRange& channels, const LightWeight& weight) {
  return std::visit(
      [&](const auto& one) {
        if constexpr (requires { one.reflected_light(omega_o, tolerance, channels, weight); })
          return by_its_own_rule(one, coats, omega_o, tolerance, channels, weight);
        else if constexpr (requires { one.about_half_vector; })
          return over_half_vectors(one, coats, omega_o, tolerance, channels, std::span(&weight, 1));
        else
          return over_hemisphere(one, coats, omega_o, tolerance, channels, weight);
      },
      term);
}

/// reflected_moments() of one term without its weight.
ColourEstimate moments_of(const WeightedTerm& weighted, const Direction& omega_o, double tolerance, std::size_t channel,
                          const std::vector<LightWeight>& weights) {
  return std::visit(
      [&](const auto& one) {
        const ChannelRange own{channels_of(one, weighted.coats) > 1 ? channel : 0, 1};
        if constexpr (requires { one.about_half_vector; }) {
          return over_half_vectors(one, weighted.coats, omega_o, tolerance, own, weights);
        } else {
          ColourEstimate each;
          for (std::size_t k = 0; k < weights.size(); ++k) {
            const auto of_weight = under_coats(weighted.term, weighted.coats, omega_o, tolerance, own, weights[k]);
            each.value[k] = of_weight.value[0];
            each.error[k] = of_weight.error[0];
            each.evaluations += of_weight.evaluations;
          }
          return each;
        }
      },
      weighted.term);
}

} // namespace

bool is_measured(const BrdfTerm& term) {
  return std::visit(
      [](const auto& one) {
        return requires { one.reflected_light(Direction{}, 0.0, ChannelRange{}, every_direction); };
      },
      term);
}

ColourEstimate reflected_light(const BrdfTerm& term, const Direction& omega_o, double tolerance,
                               const ChannelRange& channels, const LightWeight& weight) {
  return under_coats(term, {}, omega_o, tolerance, channels, weight);
}

ColourEstimate reflected_light(const std::vector<const WeightedTerm*>& terms, const Direction& omega_o,
                               double tolerance, const ChannelRange& channels, const LightWeight& weight) {
  ColourEstimate sum;
  for (const WeightedTerm* weighted : terms) {
    std::array<double, 3> w{};
    for (std::size_t c = 0; c < channels.count; ++c) w[c] = weighted->weight.value[channels.first + c];
    const double most = std::max({w[0], w[1], w[2]});
    if (most == 0) continue;
    const double asked = tolerance / (most * static_cast<double>(terms.size()));
    const bool coloured =
        std::visit([&](const auto& t) { return channels_of(t, weighted->coats) > 1; }, weighted->term);
    const ChannelRange own = coloured ? channels : ChannelRange{0, 1};
    ColourEstimate one = under_coats(weighted->term, weighted->coats, omega_o, asked, own, weight);
    for (std::size_t c = own.count; c < channels.count; ++c) {
      one.value[c] = one.value[0];
      one.error[c] = one.error[0];
    }
    sum.add(one, w);
  }
  return sum;
}

ColourEstimate reflected_moments(const std::vector<const WeightedTerm*>& terms, const Direction& omega_o,
                                 double tolerance, std::size_t channel, const std::vector<LightWeight>& weights) {
  ColourEstimate sum;
  for (const WeightedTerm* weighted : terms) {
    const double w = weighted->weight.value[channel];
    if (w == 0) continue;
    const double asked = tolerance / (w * static_cast<double>(terms.size()));
    sum.add(moments_of(*weighted, omega_o, asked, channel, weights), {w, w, w});
  }
  return sum;
}

} // namespace brdfplot
