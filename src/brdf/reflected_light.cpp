#include "brdf/reflected_light.hpp"

#include "brdf/component_sum.hpp"
#include "brdf/evaluate.hpp"
#include "brdf/viewer_rows.hpp"
#include "integrate/hemisphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brdfplot {

namespace {

/// Of what is about the half vector: over the normals that reflect the viewer into the light.
template <class T>
ColourEstimate over_half_vectors(const T& term, const Direction& o, double tolerance, const ChannelRange& channels,
                                 const LightWeight& weight) {
  ViewerRows rows(o);
  std::vector<double> all;
  const NormalIntegrand integrand = [&](const std::vector<Direction>& h, std::vector<double>& out) {
    const std::size_t n = h.size();
    const Batch batch = rows.with_lights(n, [&](std::size_t k) { return reflected(o, h[k]); });
    all.resize(static_cast<std::size_t>(term.channels()) * n);
    evaluate_term(term, true, batch, all.data());
    for (std::size_t k = 0; k < n; ++k) {
      // d omega_i = 4 (o.h) d omega_h.
      const double jacobian = 4 * dot(o, h[k]);
      const double w = weight(batch.i[k]);
      for (std::size_t c = 0; c < channels.count; ++c)
        out[c * n + k] = all[(channels.first + c) * n + k] * jacobian * w;
    }
  };
  const HalfVectorKinks kinks = term.kinks(o, channels);
  const Distribution& facets = term.facets();
  return sum_over_components(facets, o, tolerance, [&](const auto& component, const SlopeFrame& frame, double asked) {
    return integrate_lit(frame,
                         {share_of(facets, component, integrand), channels.count, kinks.switches,
                          kinks.in_plane_of_incidence, kinks.symmetric},
                         asked);
  });
}

/// Writes rho of a term that is a quadrature, and its errors.
template <class T>
void write_quadratures(const T& term, const Direction& o, const std::vector<Direction>& lights,
                       const Tolerance& tolerance, const ChannelRange& channels, std::vector<double>& value,
                       std::vector<double>& error) {
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const Estimate white = term.brdf(o, lights[k], tolerance);
    for (std::size_t c = 0; c < channels.count; ++c) {
      const double albedo = term.albedo.value[channels.first + c];
      value[c * lights.size() + k] = albedo * white.value;
      error[c * lights.size() + k] = albedo * white.error;
    }
  }
}

/// Of what is smooth on the scale of the hemisphere.
template <class T>
ColourEstimate over_hemisphere(const T& term, const Direction& o, double tolerance, const ChannelRange& channels,
                               const LightWeight& weight) {
  ViewerRows rows(o);
  std::vector<double> all;
  HemisphereIntegrand f{{}, channels.count, true};
  f.rho = [&](const std::vector<Direction>& lights, const Tolerance& asked, std::vector<double>& value,
              std::vector<double>& error) {
    const std::size_t n = lights.size();
    if constexpr (requires { term.brdf(o, lights[0], asked); }) {
      write_quadratures(term, o, lights, asked, channels, value, error);
    } else {
      all.resize(static_cast<std::size_t>(term.channels()) * n);
      evaluate_term(term, false, rows.with_lights(n, [&](std::size_t k) { return lights[k]; }), all.data());
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

} // namespace

ColourEstimate reflected_light(const BrdfTerm& term, const Direction& omega_o, double tolerance,
                               const ChannelRange& channels, const LightWeight& weight) {
  return std::visit(
      [&](const auto& one) {
        if constexpr (requires { one.reflected_light(omega_o, tolerance, channels, weight); })
          return one.reflected_light(omega_o, tolerance, channels, weight);
        else if constexpr (requires { one.about_half_vector; })
          return over_half_vectors(one, omega_o, tolerance, channels, weight);
        else
          return over_hemisphere(one, omega_o, tolerance, channels, weight);
      },
      term);
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
    const bool coloured = std::visit([](const auto& t) { return t.channels() > 1; }, weighted->term);
    const ChannelRange own = coloured ? channels : ChannelRange{0, 1};
    ColourEstimate one = reflected_light(weighted->term, omega_o, asked, own, weight);
    for (std::size_t c = own.count; c < channels.count; ++c) {
      one.value[c] = one.value[0];
      one.error[c] = one.error[0];
    }
    sum.add(one, w);
  }
  return sum;
}

} // namespace brdfplot
