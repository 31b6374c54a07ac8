#include "analysis/integrals.hpp"

#include "analysis/lobe_peak.hpp"
#include "base/number.hpp"
#include "brdf/components.hpp"
#include "integrate/hemisphere.hpp"
#include "integrate/slope_domain.hpp"
#include "integrate/visible_area.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace brdfplot {

namespace {

/// Arrays of directions for evaluate(), refilled for every rule.
struct Columns3 {
  std::vector<double> x, y, z;
  void resize(std::size_t n) {
    x.resize(n);
    y.resize(n);
    z.resize(n);
  }
  void set(std::size_t k, const Direction& d) {
    x[k] = d.x;
    y[k] = d.y;
    z[k] = d.z;
  }
  Columns view() const { return {x.data(), y.data(), z.data()}; }
};

/// Rows that share omega_o.
struct Rows {
  explicit Rows(const Direction& omega_o) : o_(omega_o) {}

  template <class Fill>
  Batch fill(std::size_t n, bool has_i, bool has_m, const Fill& direction_of) {
    o.resize(n);
    (has_i ? i : m).resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      o.set(k, o_);
      (has_i ? i : m).set(k, direction_of(k));
    }
    return {n, o.view(), has_i ? i.view() : Columns{}, has_m ? m.view() : Columns{}};
  }

private:
  Direction o_;
  Columns3 o, i, m;
};

/// The sum of an integral over the components of a material's distribution, each in its frame: integral(component,
/// frame, tolerance).
template <class Function>
Estimate over_components(const Microsurface& surface, const Direction& o, double tolerance, const Function& integral) {
  const auto parts = components(surface.distribution);
  Estimate sum;
  for (const Component& component : parts) {
    const SlopeFrame frame(component.frame, o);
    const Estimate one = integral(component, frame, tolerance / static_cast<double>(parts.size()));
    sum.value += one.value;
    sum.error += one.error;
    sum.evaluations += one.evaluations;
  }
  return sum;
}

/// `integrand`, which has D as a factor, or where there are several components, the share w_k D_k / D of one.
NormalIntegrand part_of(const Microsurface& surface, const Component& component, const NormalIntegrand& integrand) {
  if (component.weight == 1) return integrand;
  return [&](const std::vector<Direction>& normals, std::vector<double>& values) {
    integrand(normals, values);
    for (std::size_t k = 0; k < normals.size(); ++k) {
      const double part = component.density(normals[k]);
      const auto all = [&] {
        return std::visit([&](const auto& d) { return d.density(normals[k]); }, surface.distribution);
      };
      values[k] = part > 0 && values[k] != 0 ? values[k] * (part / all()) : 0;
    }
  };
}

/// Whether everything about a material has the mirror image of the plane of incidence.
bool mirrored(const Microsurface& surface, const Direction& o) {
  if (std::holds_alternative<CustomMasking>(surface.masking)) return false;
  return std::ranges::all_of(components(surface.distribution),
                             [&](const Component& component) { return SlopeFrame(component.frame, o).symmetric(); });
}

/// An integral over the normals that face the viewer. The integrands of Eqs. 13, 18 and 36 have the mirror image of
/// each frame where G1 does not depend on the normal, or through o.m / z_m alone.
Estimate integrate_visible(const Microsurface& surface, const Direction& o, double tolerance,
                           const NormalIntegrand& integrand) {
  const bool cavity = std::holds_alternative<VCavity>(surface.masking);
  const bool symmetric = surface.has_lambda() || cavity || mirrored(surface, o);
  return over_components(surface, o, tolerance, [&](const auto& component, const SlopeFrame& frame, double asked) {
    return integrate_facing(frame, {part_of(surface, component, integrand), symmetric, cavity}, asked);
  });
}

/// int D_o(m) dm over the facing normals.
Estimate visible(const Microsurface& surface, const Direction& o, double tolerance) {
  Rows rows(o);
  const auto integrand = [&](const std::vector<Direction>& m, std::vector<double>& out) {
    const Batch batch = rows.fill(m.size(), false, true, [&](std::size_t k) { return m[k]; });
    evaluate(surface, Quantity::d_visible, batch, out.data());
  };
  return integrate_visible(surface, o, tolerance, integrand);
}

/// int G1 <o,m> D dm, each factor by itself.
Estimate projected_area(const Microsurface& surface, const Direction& o, double tolerance) {
  Rows rows(o);
  std::vector<double> density;
  const auto integrand = [&](const std::vector<Direction>& m, std::vector<double>& out) {
    const Batch batch = rows.fill(m.size(), false, true, [&](std::size_t k) { return m[k]; });
    density.resize(m.size());
    evaluate(surface, Quantity::d, batch, density.data());
    evaluate(surface, Quantity::g1, batch, out.data());
    for (std::size_t k = 0; k < m.size(); ++k) out[k] *= std::max(0.0, dot(o, m[k])) * density[k];
  };
  return integrate_visible(surface, o, tolerance * surface.slopes().project(o).c, integrand);
}

/// The smallest width of a component along any axis, in slopes.
double narrowest_width(const Microsurface& surface) {
  double width = infinity;
  for (const Component& component : components(surface.distribution)) {
    const SlopeMap& map = component.frame;
    width = std::min(width, std::min(map.alpha_x, map.alpha_y) * map.decorrelation());
  }
  return width;
}

/// Eq. 36 over omega_i, with d omega_i = 4 (o.h) d omega_h: the half vector is found again from omega_i.
Estimate weak_furnace(const Microsurface& surface, const Direction& o, double tolerance) {
  Rows rows(o);
  const double c = surface.slopes().project(o).c;
  std::vector<double> density;
  const auto integrand = [&](const std::vector<Direction>& h, std::vector<double>& out) {
    const Batch batch = rows.fill(h.size(), true, false, [&](std::size_t k) { return reflected(o, h[k]); });
    density.resize(h.size());
    evaluate(surface, Quantity::d, batch, density.data());
    evaluate(surface, Quantity::g1, batch, out.data());
    for (std::size_t k = 0; k < h.size(); ++k) out[k] *= density[k] / (4 * c) * (4 * dot(o, h[k]));
  };
  Estimate estimate = integrate_visible(surface, o, tolerance, integrand);
  // o + i has a length of 2 o.h ~ 2 c, and the half vector that many roundings, of which D sees the ratio to its width.
  estimate.error += 8 * std::numeric_limits<double>::epsilon() * std::fabs(estimate.value) /
                    (c * std::min(1.0, narrowest_width(surface)));
  return estimate;
}

/// Eqs. 13, 18 and 36 where G1 is one number: G1 / c times the area of the facing normals, times c for Eq. 13.
Estimate visible_of_lambda(Integral integral, const Microsurface& surface, const Direction& o, double tolerance) {
  const double c = surface.slopes().project(o).c;
  const double g1 = evaluate(surface, Quantity::g1, o, std::nullopt, std::nullopt);
  const double scale = integral == Integral::projected_area ? g1 : g1 / c;
  const double asked = integral == Integral::projected_area ? tolerance * c : tolerance;
  const auto of_component = [&](const Component& component, const SlopeFrame& frame, double enough) {
    Estimate one = visible_area(component.distribution, frame, enough / component.weight);
    one.value *= component.weight;
    one.error *= component.weight;
    return one;
  };
  const Estimate area = over_components(surface, o, asked / scale, of_component);
  return {scale * area.value, scale * area.error, area.evaluations};
}

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
    Columns3 normals, viewer, light;
    for (Columns3* columns : {&normals, &viewer, &light}) columns->resize(n);
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

/// What changes its sign where G1(o) = G1(i): c_i - c_o where G1 is a function of c and what both directions share, as
/// it is on isotropic surfaces; a_i - a_o where it is one of a.
Switch comparison(const Microsurface& surface, const Direction& o) {
  const SlopeMap& map = surface.slopes();
  const Projection viewer = map.project(o);
  const bool own = std::holds_alternative<CustomMasking>(surface.masking);
  const bool of_c = mirrored(surface, o) || !surface.has_lambda();
  if (of_c && !own)
    return switch_of(o, [&map, viewer](const Direction&, const Direction& i) { return map.project(i).c - viewer.c; });
  const bool several = components(surface.distribution).size() > 1;
  if (own || several || std::holds_alternative<SchlickSmithRational>(surface.masking)) // of more than one a
    return masking_difference(surface, o);
  return elevation(map, o);
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

/// The kinks that a masking function declares: in the light, and where the normal is part of it, in the viewer.
void add_kinks_of_masking(const Microsurface& surface, const Direction& o, std::vector<Switch>& all) {
  std::visit(
      [&]<class M>(const M&) {
        if constexpr (requires(const Projection& p) { M::kink(p); }) {
          for (const SlopeMap& map : masked_slopes(surface.distribution))
            all.push_back(
                switch_of(o, [map](const Direction&, const Direction& i) { return M::kink(map.project(i)); }));
        } else if constexpr (requires(const Projection& p) { M::kink(p, 1.0, 1.0); }) {
          const SlopeMap& map = surface.slopes();
          all.push_back(switch_of(o, [o, viewer = map.project(o)](const Direction& h, const Direction&) {
            return M::kink(viewer, dot(o, h), h.z);
          }));
          all.push_back(switch_of(o, [o, &map](const Direction& h, const Direction& i) {
            return M::kink(map.project(i), dot(o, h), h.z);
          }));
        }
      },
      surface.masking);
}

/// The angle at which a Fresnel term declares that it is not smooth.
void add_critical_angle(const Fresnel& fresnel, const Direction& o, int channel, std::vector<Switch>& all) {
  std::visit(
      [&](const auto& term) {
        if constexpr (requires { term.critical_cosine(0); })
          if (const auto critical = term.critical_cosine(static_cast<std::size_t>(channel))) {
            all.push_back(
                switch_of(o, [o, critical](const Direction& h, const Direction&) { return dot(o, h) - *critical; }));
            all.back().root = true;
          }
      },
      fresnel);
}

/// Where the masking, shadowing and Fresnel terms of a material are not smooth.
std::vector<Switch> switches(const Mirror& mirror, const Direction& o, int channel) {
  const Microsurface& surface = mirror.surface;
  const SlopeMap& map = surface.slopes();
  std::vector<Switch> all;
  if (std::visit([](const auto& s) { return s.compares; }, surface.shadowing)) all.push_back(comparison(surface, o));
  add_kinks_of_masking(surface, o, all);
  add_critical_angle(mirror.fresnel, o, channel, all);
  if (compares_elevations(surface.shadowing)) all.push_back(elevation(map, o));
  const bool azimuth = std::visit([](const auto& s) { return s.needs_azimuth; }, surface.shadowing);
  // The azimuth of the light turns around where it is at the normal: a corner for rectangles, on one of their edges.
  if (azimuth && o.x * o.x + o.y * o.y > 0)
    all.push_back(switch_of(o, [o](const Direction&, const Direction& i) { return o.x * i.x + o.y * i.y; }));
  if (azimuth && !map.centred())
    all.push_back(switch_of(o, [o](const Direction&, const Direction& i) { return o.x * i.y - o.y * i.x; }));
  return all;
}

using Weight = std::function<double(const Direction&)>;

/// int rho c_i w(i) di of mirrors, over the half vectors.
Estimate reflected_by(const Mirror& mirror, const Direction& o, double tolerance, int channel, const Weight& weight) {
  const Microsurface& surface = mirror.surface;
  Rows rows(o);
  std::vector<double> all;
  const NormalIntegrand integrand = [&](const std::vector<Direction>& h, std::vector<double>& out) {
    const std::size_t n = h.size();
    const Batch batch = rows.fill(n, true, false, [&](std::size_t k) { return reflected(o, h[k]); });
    all.resize(static_cast<std::size_t>(mirror.channels()) * n);
    evaluate_term(mirror, true, batch, all.data());
    const double* of_channel = all.data() + (mirror.channels() > 1 ? static_cast<std::size_t>(channel) * n : 0);
    for (std::size_t k = 0; k < n; ++k) out[k] = of_channel[k] * 4 * dot(o, h[k]) * weight(reflected(o, h[k]));
  };
  const bool azimuth = std::visit([](const auto& s) { return s.needs_azimuth; }, surface.shadowing);
  const auto kinks = switches(mirror, o, mirror.channels() > 1 ? channel : 0);
  const bool symmetric = mirrored(surface, o);
  return over_components(surface, o, tolerance, [&](const auto& component, const SlopeFrame& frame, double asked) {
    return integrate_lit(frame, {part_of(surface, component, integrand), kinks, azimuth, symmetric}, asked);
  });
}

/// The same of what is smooth on the scale of the hemisphere, over the light.
template <class T>
Estimate reflected_by(const T& term, const Direction& o, double tolerance, int channel, const Weight& weight) {
  const auto c = static_cast<std::size_t>(channel);
  const PairFunction rho = [&](const Direction& i, const Tolerance& asked) -> Estimate {
    if constexpr (requires { term.brdf(o, i, asked); }) {
      const Estimate white = term.brdf(o, i, asked);
      const double albedo = term.albedo.value[c];
      return {albedo * white.value, albedo * white.error, white.evaluations};
    } else {
      std::array<double, 3> value{};
      evaluate_term(term, false, {1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, {}}, value.data());
      const double here = value[term.channels() > 1 ? c : 0];
      return {here, 1e-14 * (std::fabs(here) + 1), 1};
    }
  };
  SlopeMap map;
  bool symmetric = true;
  if constexpr (requires { term.surface; }) {
    map = term.surface.slopes();
    symmetric = map.alpha_x == map.alpha_y && map.correlation == 0 && map.centred() &&
                !std::holds_alternative<CustomMasking>(term.surface.masking);
  }
  return integrate_hemisphere(map, symmetric, rho, o, tolerance, weight);
}

/// The sum over the terms, with their weights.
Estimate reflected_light(const std::vector<const WeightedTerm*>& terms, const Direction& o, double tolerance,
                         int channel, const Weight& weight) {
  Estimate sum;
  for (const WeightedTerm* weighted : terms) {
    const double w = weighted->weight.value[static_cast<std::size_t>(channel)];
    if (w == 0) continue;
    const double asked = tolerance / (w * static_cast<double>(terms.size()));
    const Estimate one =
        std::visit([&](const auto& term) { return reflected_by(term, o, asked, channel, weight); }, weighted->term);
    sum.value += w * one.value;
    sum.error += w * one.error;
    sum.evaluations += one.evaluations;
  }
  return sum;
}

double one(const Direction&) { return 1; }

/// Of one term, with F = 1 or an albedo of 1.
Estimate furnace(const WeightedTerm& weighted, const Direction& o, double tolerance) {
  return std::visit([&](const auto& term) { return reflected_by(term.white(), o, tolerance, 0, one); }, weighted.term);
}

/// Appendix C: theta over the whole sphere and phi, both in steps of 0.05.
double weak_furnace_on_grid(const Microsurface& surface, const Direction& o) {
  constexpr double step = 0.05;
  const double c = surface.slopes().project(o).c;
  std::vector<Vec2> azimuths;
  for (int column = 0; column * step <= 2 * std::numbers::pi; ++column)
    azimuths.push_back({std::cos(column * step), std::sin(column * step)});
  const std::size_t n = azimuths.size();
  std::vector<double> g1(n), d(n);
  Rows rows(o);
  double sum = 0;
  for (int row = 0; row * step <= std::numbers::pi; ++row) {
    const double sin_theta = std::sin(row * step), cos_theta = std::cos(row * step);
    const Batch batch = rows.fill(n, true, false, [&](std::size_t k) {
      return Direction{azimuths[k][0] * sin_theta, azimuths[k][1] * sin_theta, cos_theta};
    });
    evaluate(surface, Quantity::g1, batch, g1.data());
    evaluate(surface, Quantity::d, batch, d.data());
    for (std::size_t k = 0; k < n; ++k)
      if (g1[k] > 0) sum += sin_theta * g1[k] * d[k];
  }
  return sum * step * step / (4 * c);
}

/// atan2 of the mean horizontal and vertical component of omega_i, weighted by rho cos theta_i. What is dark is asked
/// for again, as much more accurately as it is darker.
Estimate mean_theta_i(const std::vector<const WeightedTerm*>& terms, const Direction& o, double tolerance,
                      int channel) {
  const Direction along = azimuth(o);
  const auto sideways = [&](const Direction& i) { return dot(along, i); };
  double length = 0;
  const auto mean = [&](double asked) -> Estimate {
    const auto x = reflected_light(terms, o, asked, channel, sideways);
    const auto z = reflected_light(terms, o, asked, channel, [](const Direction& i) { return i.z; });
    length = std::hypot(x.value, z.value);
    return {std::atan2(x.value, z.value), length > 0 ? (x.error + z.error) / length : infinity,
            x.evaluations + z.evaluations};
  };
  const Estimate estimate = mean(0.1 * tolerance);
  return estimate.error <= tolerance || !(length > 0) || length >= 1 ? estimate : mean(0.1 * tolerance * length);
}

/// The smallest width of the distributions of a material, in slopes; 1 where it has none.
double narrowest_width(const Material& material) {
  double width = 1;
  for (const WeightedTerm& term : material.terms)
    if (const Microsurface* surface = term.surface()) width = std::min(width, narrowest_width(*surface));
  return width;
}

bool is_of_surface(Integral integral) {
  return integral == Integral::projected_area || integral == Integral::visible_norm ||
         integral == Integral::weak_furnace || integral == Integral::weak_furnace_grid;
}

/// The term of the furnace: the one of this name, or the only one.
const WeightedTerm& furnace_term(const Material& material, const std::string& name) {
  const auto terms = terms_of(material, name);
  if (terms.size() == 1) return *terms[0];
  std::string names;
  for (const WeightedTerm* term : terms) names += (names.empty() ? "" : ", ") + term->name;
  throw InputError(material.name, "\"furnace\" is of one term; accepted: TERM. before the name, of " + names);
}

Estimate compute_of_surface(Integral integral, const Microsurface& surface, const Direction& o, double tolerance) {
  switch (integral) {
  case Integral::projected_area: return projected_area(surface, o, tolerance);
  case Integral::visible_norm: return visible(surface, o, tolerance);
  case Integral::weak_furnace: return weak_furnace(surface, o, tolerance);
  default: return {weak_furnace_on_grid(surface, o), 0, std::size_t{63} * 126};
  }
}

} // namespace

const std::vector<IntegralInfo>& integrals() {
  static const std::vector<IntegralInfo> all = {
      {Integral::projected_area, "projected_area", "projected area of the visible microsurface, Eq. 13", false},
      {Integral::visible_norm, "visible_norm", "integral of D_o, Eq. 18", false},
      {Integral::weak_furnace, "weak_furnace", "weak white furnace, Eq. 36", false},
      {Integral::furnace, "furnace", "white furnace, Eq. 34 with F = 1", false},
      {Integral::albedo, "albedo", "directional albedo, integral of rho cos theta_i", true},
      {Integral::weak_furnace_grid, "weak_furnace_grid", "Eq. 36 summed on the 0.05 rad grid of Appendix C", false},
      {Integral::mean_theta_i, "mean_theta_i", "polar angle of the mean reflected direction, rad", true},
      {Integral::peak_theta_i, "peak_theta_i", "angle of the largest rho cos theta_i in the plane of incidence, rad",
       true},
  };
  return all;
}

void require(const Material& material, const IntegralInfo& info, const std::string& term) {
  if (is_of_surface(info.integral))
    (void)material.surface(term);
  else if (info.integral == Integral::furnace)
    (void)furnace_term(material, term);
  else
    (void)terms_of(material, term);
}

Estimate compute(Integral integral, const Material& material, const Direction& omega_o, double tolerance, int channel,
                 const std::string& term) {
  const bool visible_one = is_of_surface(integral) && integral != Integral::weak_furnace_grid;
  if (!visible_one || !material.surface(term).has_lambda())
    return compute_in_plane(integral, material, omega_o, tolerance, channel, term);
  if (!(material.mesosurface().project(omega_o).c > 0)) return {};
  return visible_of_lambda(integral, material.surface(term), omega_o, tolerance);
}

Estimate compute_in_plane(Integral integral, const Material& material, const Direction& omega_o, double tolerance,
                          int channel, const std::string& term) {
  if (!(material.mesosurface().project(omega_o).c > 0)) return {};
  if (is_of_surface(integral)) return compute_of_surface(integral, material.surface(term), omega_o, tolerance);
  switch (integral) {
  case Integral::furnace: return furnace(furnace_term(material, term), omega_o, tolerance);
  case Integral::albedo: return reflected_light(terms_of(material, term), omega_o, tolerance, channel, one);
  case Integral::mean_theta_i: return mean_theta_i(terms_of(material, term), omega_o, tolerance, channel);
  default: return peak_theta_i(material, omega_o, narrowest_width(material), channel);
  }
}

double compute_or_throw(Integral integral, const Material& material, const Direction& omega_o, double tolerance,
                        int channel, const std::string& term) {
  const Estimate estimate = compute(integral, material, omega_o, tolerance, channel, term);
  const std::string& name = integrals()[static_cast<std::size_t>(integral)].name;
  const std::string place = " at omega_o = (" + format_number(omega_o.x) + ", " + format_number(omega_o.y) + ", " +
                            format_number(omega_o.z) + ")";
  if (!std::isfinite(estimate.value))
    throw AccuracyError(name, "found " + format_number(estimate.value) + place + "; accepted: a finite number");
  const double scale =
      integral == Integral::projected_area ? std::max(0.0, material.mesosurface().project(omega_o).c) : 1;
  // Written so that a NaN does not pass.
  if (!(estimate.error <= tolerance * scale) && integral != Integral::peak_theta_i)
    throw AccuracyError(name, "reached an error estimate of " + format_number(estimate.error) +
                                  " (asked: " + format_number(tolerance * scale) + ")" + place);
  return estimate.value;
}

} // namespace brdfplot
