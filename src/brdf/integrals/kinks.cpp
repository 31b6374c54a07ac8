#include "brdf/integrals/kinks.hpp"

#include "brdf/blocks/surface_quantities.hpp"
#include "brdf/blocks/viewer_rows.hpp"
#include "brdf/integrals/components.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace brdfplot {

namespace {

/// A switch as a function of the half vector and the light.
template <class Function>
Switch switch_of(const Direction& o, const Function& function) {
  return {[o, function](const std::vector<Direction>& h, std::vector<double>& out) {
    for (std::size_t k = 0; k < h.size(); ++k) out[k] = function(h[k], reflected(o, h[k]));
  }};
}

/// The sign of a_i - a_o.
Switch elevation(const SlopeMap& map, const Direction& o) {
  const Projection viewer = map.project(o);
  return switch_of(o, [&map, viewer](const Direction&, const Direction& i) {
    const Projection light = map.project(i);
    return light.c * viewer.s - viewer.c * light.s;
  });
}

/// The sign of G1(i) - G1(o), of what masks in whatever way.
Switch masking_difference(const Microsurface& surface, const Direction& o) {
  const double constant = surface.has_lambda() ? evaluate(surface, Quantity::g1, o, std::nullopt, std::nullopt) : 0;
  return {[&surface, o, constant](const std::vector<Direction>& h, std::vector<double>& out) {
    const std::size_t n = h.size();
    DirectionArrays normals, viewer, light;
    for (DirectionArrays* arrays : {&normals, &viewer, &light}) arrays->resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      normals.set(k, h[k]);
      viewer.set(k, o);
      light.set(k, reflected(o, h[k]));
    }
    std::vector<double> of_viewer(n, constant);
    if (!surface.has_lambda())
      evaluate(surface, Quantity::g1, {n, viewer.view(), {}, normals.view()}, of_viewer.data());
    evaluate(surface, Quantity::g1, {n, light.view(), {}, normals.view()}, out.data());
    for (std::size_t k = 0; k < n; ++k) out[k] -= of_viewer[k];
  }};
}

/// Whether a Lambda is one of a = c / s of the distribution's own slopes alone.
bool is_of_one_a(const Microsurface& surface) {
  return components(surface.distribution).size() == 1 && !is_formula(surface.masking) &&
         !std::visit(
             [](const auto& m) {
               return requires { m.is_of_several_a; };
             },
             surface.masking);
}

/// What changes its sign where G1(o) = G1(i): c_i - c_o where G1 is a function of c and what both directions share, as
/// it is on isotropic surfaces; a_i - a_o where it is one of a.
Switch comparison(const Microsurface& surface, const Direction& o) {
  const SlopeMap& map = surface.slopes();
  const bool of_c = is_mirrored(surface, o) || !surface.has_lambda();
  if (of_c && !is_formula(surface.masking))
    return switch_of(o, [&map, viewer = map.project(o)](const Direction&, const Direction& i) {
      return map.project(i).c - viewer.c;
    });
  return is_of_one_a(surface) ? elevation(map, o) : masking_difference(surface, o);
}

/// Whether the factor that correlates the directions has a kink where a_i = a_o.
bool compares_elevations(const Shadowing& shadowing) {
  return std::visit(
      []<class S>(const S& s) {
        if constexpr (S::needs_azimuth)
          return s.lambda == DirectionFactor::fitted;
        else
          return false;
      },
      shadowing);
}

/// The slopes that a masking function is asked with: those of the parts of a mixture, else of the distribution.
std::vector<SlopeMap> masked_slopes(const Distribution& distribution) {
  return std::visit(
      [](const auto& d) {
        std::vector<SlopeMap> all;
        if constexpr (requires { d.parts; })
          for (const auto& part : d.parts) all.push_back(part.slopes());
        else
          all.push_back(d.slopes);
        return all;
      },
      distribution);
}

/// Whether the slopes of every component are.
bool is_centred(const Distribution& distribution) {
  return std::ranges::all_of(components(distribution), [](const Component& one) { return one.frame.centred(); });
}

/// The kinks of the masking of the viewer, in the normal.
std::vector<Switch> viewer_masking_kinks(const Microsurface& surface, const Direction& o) {
  std::vector<Switch> all;
  std::visit(
      [&]<class M>(const M&) {
        if constexpr (requires(const Projection& p) { M::kink(p, 1.0, 1.0); })
          all.push_back(switch_of(o, [o, viewer = surface.slopes().project(o)](const Direction& m, const Direction&) {
            return M::kink(viewer, dot(o, m), m.z);
          }));
      },
      surface.masking);
  return all;
}

/// The horizons of the parts of a mixture that lie on mesosurfaces of their own. Through them Smith's masked area is
/// smooth, and that of an approximation, which goes on by Lambda(-a) = -1 - Lambda(a), bends.
std::vector<Switch> horizons_of_parts(const Microsurface& surface, const Direction& o) {
  std::vector<Switch> all;
  if (!surface.has_lambda() || std::holds_alternative<Smith>(surface.masking)) return all;
  if (has_one_mesosurface(surface.distribution)) return all;
  for (const SlopeMap& map : masked_slopes(surface.distribution))
    all.push_back(switch_of(o, [map](const Direction&, const Direction& i) { return map.project(i).c; }));
  return all;
}

/// The kinks of the masking of the light, in the half vector.
std::vector<Switch> light_masking_kinks(const Microsurface& surface, const Direction& o) {
  std::vector<Switch> all = horizons_of_parts(surface, o);
  std::visit(
      [&]<class M>(const M&) {
        if constexpr (requires(const Projection& p) { M::kink(p); }) {
          for (const SlopeMap& map : masked_slopes(surface.distribution)) // of a part also from below
            all.push_back(switch_of(o, [map](const Direction&, const Direction& i) {
              const Projection p = map.project(i);
              return M::kink({std::fabs(p.c), p.s});
            }));
        } else if constexpr (requires(const Projection& p) { M::kink(p, 1.0, 1.0); }) {
          all.push_back(switch_of(o, [o, &map = surface.slopes()](const Direction& h, const Direction& i) {
            return M::kink(map.project(i), dot(o, h), h.z);
          }));
        }
      },
      surface.masking);
  return all;
}

} // namespace

bool is_formula(const Masking& masking) {
  return std::visit(
      [](const auto& m) {
        return requires { m.is_formula; };
      },
      masking);
}

bool is_mirrored(const Distribution& distribution, const Direction& omega_o) {
  return std::ranges::all_of(components(distribution), [&](const Component& component) {
    return SlopeFrame(component.frame, omega_o).symmetric();
  });
}

bool is_mirrored(const Microsurface& surface, const Direction& omega_o) {
  return !is_formula(surface.masking) && is_mirrored(surface.distribution, omega_o);
}

bool is_isotropic(const Distribution& distribution) {
  return std::ranges::all_of(components(distribution), [](const Component& component) {
    const SlopeMap& map = component.frame;
    return map.alpha_x == map.alpha_y && map.correlation == 0 && map.centred();
  });
}

bool is_aligned(const Distribution& distribution) {
  return std::ranges::all_of(components(distribution), [](const Component& component) {
    return component.frame.correlation == 0 && component.frame.centred();
  });
}

std::vector<Switch> masking_kinks(const Microsurface& surface, const Direction& omega_o) {
  return has_masking_line(surface) ? std::vector<Switch>{} : viewer_masking_kinks(surface, omega_o);
}

bool has_masking_line(const Microsurface& surface) {
  const auto has_radii = [](const Component& one) { return !one.radii.empty(); };
  if (std::ranges::any_of(components(surface.distribution), has_radii)) return false;
  return has_one_mesosurface(surface.distribution) && std::visit(
                                                          [](const auto& m) {
                                                            return requires { m.kink_is_line; };
                                                          },
                                                          surface.masking);
}

HalfVectorKinks kinks(const Microsurface& surface, const Fresnel& fresnel, const Direction& omega_o,
                      const ChannelRange& channels) {
  const SlopeMap& map = surface.slopes();
  const Direction o = omega_o;
  HalfVectorKinks out;
  out.symmetric = is_mirrored(surface, o);
  out.in_plane_of_incidence = std::visit([](const auto& s) { return s.needs_azimuth; }, surface.shadowing);
  std::vector<Switch>& all = out.switches;
  const auto append = [&](std::vector<Switch> more) { std::ranges::move(more, std::back_inserter(all)); };
  if (std::visit([](const auto& s) { return s.compares; }, surface.shadowing)) all.push_back(comparison(surface, o));
  append(viewer_masking_kinks(surface, o));
  append(light_masking_kinks(surface, o));
  append(fresnel_kinks(fresnel, o, channels));
  if (compares_elevations(surface.shadowing)) all.push_back(elevation(map, o));
  // The azimuth of the light turns around where it is at the normal: a corner for rectangles, on one of their edges.
  if (out.in_plane_of_incidence && o.x * o.x + o.y * o.y > 0)
    all.push_back(switch_of(o, [o](const Direction&, const Direction& i) { return o.x * i.x + o.y * i.y; }));
  if (out.in_plane_of_incidence && !is_centred(surface.distribution))
    all.push_back(switch_of(o, [o](const Direction&, const Direction& i) { return o.x * i.y - o.y * i.x; }));
  return out;
}

std::vector<double> kinks_of_viewers(const Microsurface& surface) {
  std::vector<double> all;
  std::visit(
      [&]<class M>(const M&) {
        if constexpr (requires(const Projection& p) { M::kink(p); })
          for (const SlopeMap& map : masked_slopes(surface.distribution)) {
            // From below 0 at the horizon to above at the normal: halved down to neighbouring numbers.
            const auto sign_at = [&](double mu) {
              return M::kink(map.project({std::sqrt((1 - mu) * (1 + mu)), 0, mu}));
            };
            double low = 0, high = 1;
            for (double mu = 0.5; low < mu && mu < high; mu = 0.5 * (low + high)) (sign_at(mu) < 0 ? low : high) = mu;
            all.push_back(high);
          }
      },
      surface.masking);
  return all;
}

std::vector<Switch> fresnel_kinks(const Fresnel& fresnel, const Direction& omega_o, const ChannelRange& channels) {
  std::vector<Switch> all;
  std::vector<double> known;
  std::visit(
      [&](const auto& term) {
        if constexpr (requires { term.critical_cosine(0); })
          for (std::size_t c = channels.first; c < channels.first + channels.count; ++c) {
            const auto critical = term.critical_cosine(c);
            if (!critical || std::ranges::find(known, *critical) != known.end()) continue;
            known.push_back(*critical);
            all.push_back(switch_of(omega_o, [omega_o, at = *critical](const Direction& h, const Direction&) {
              return dot(omega_o, h) - at;
            }));
            all.back().root = true;
          }
      },
      fresnel);
  return all;
}

} // namespace brdfplot
