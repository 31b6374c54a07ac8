#include "analysis/integrals.hpp"

#include "analysis/lobe_peak.hpp"
#include "analysis/mean_reflectance.hpp"
#include "base/number.hpp"
#include "brdf/blocks/viewer_rows.hpp"
#include "brdf/fresnel_term.hpp"
#include "brdf/integrals/component_sum.hpp"
#include "brdf/integrals/kinks.hpp"
#include "brdf/integrals/reflected_light.hpp"
#include "brdf/integrals/reflected_moments.hpp"
#include "integrate/visible_area.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace brdfplot {

namespace {

/// An integral over the normals that face the viewer. The integrands of Eqs. 13, 18 and 36 have the mirror image of
/// each frame where G1 does not depend on the normal, or through o.m / z_m alone.
Estimate integrate_visible(const Microsurface& surface, const Direction& o, double tolerance,
                           const NormalIntegrand& integrand) {
  const bool line = has_masking_line(surface);
  const bool symmetric = surface.has_lambda() || line || is_mirrored(surface, o);
  const auto switches = masking_kinks(surface, o);
  return sum_over_components(
      surface.distribution, o, tolerance, [&](const auto& component, const auto& frame, double asked) {
        return integrate_facing(
            frame, {share_of(surface.distribution, component, integrand), switches, line, symmetric}, asked);
      });
}

/// int D_o(m) dm over the facing normals.
Estimate visible(const Microsurface& surface, const Direction& o, double tolerance) {
  ViewerRows rows(o);
  const auto integrand = [&](const std::vector<Direction>& m, std::vector<double>& out) {
    const Batch batch = rows.with_normals(m.size(), [&](std::size_t k) { return m[k]; });
    evaluate(surface, Quantity::d_visible, batch, out.data());
  };
  return integrate_visible(surface, o, tolerance, integrand);
}

/// int G1 <o,m> D dm, each factor by itself.
Estimate projected_area(const Microsurface& surface, const Direction& o, double tolerance) {
  ViewerRows rows(o);
  std::vector<double> density;
  const auto integrand = [&](const std::vector<Direction>& m, std::vector<double>& out) {
    const Batch batch = rows.with_normals(m.size(), [&](std::size_t k) { return m[k]; });
    density.resize(m.size());
    evaluate(surface, {Quantity::d, Quantity::g1}, batch, {density.data(), out.data()});
    for (std::size_t k = 0; k < m.size(); ++k) out[k] *= std::max(0.0, dot(o, m[k])) * density[k];
  };
  return integrate_visible(surface, o, tolerance * surface.slopes().project(o).c, integrand);
}

/// The smallest width of a component along any axis, in slopes.
double narrowest_width(const Distribution& distribution) {
  double width = infinity;
  for (const Component& component : components(distribution)) {
    const SlopeMap& map = component.frame;
    width = std::min(width, std::min(map.alpha_x, map.alpha_y) * map.decorrelation());
  }
  return width;
}

/// What Eq. 36 has of facets so steep that omega_i does not tell them from horizontal ones. omega_i + omega_o is 2
/// cos theta_h (o.h) along the normal, and rounds to 0 where that is below half a unit in the last place of 1, or
/// 2^-54: cos theta_h (o.h) < 2^-55. Twice that is taken here: at azimuth phi from the viewer's, cos theta_h < z with
/// z (c z + s |cos phi|) = 2^-54, or as much beyond the horizon of the viewer; c is that of the mesosurface, which
/// stands for o_z. `integrand` as it is beside them, as large as anywhere. An estimate, not a bound.
double mass_of_steepest(const Direction& o, double c, const std::function<double(const Direction&)>& integrand) {
  constexpr double rounding = std::numeric_limits<double>::epsilon() / 4;
  constexpr int count = 16;
  const double s = std::hypot(o.x, o.y), viewer = std::atan2(o.y, o.x);
  double sum = 0;
  for (int k = 0; k < count; ++k) {
    const double phi = (k + 0.5) * 2 * std::numbers::pi / count, along = s * std::cos(phi);
    const double z = 2 * rounding / (std::fabs(along) + std::sqrt(along * along + 4 * c * rounding));
    const double horizon = std::max(0.0, -along) / c; // the tangent of its elevation, at this azimuth
    const double beside = std::min(1.0, 8 * z + horizon / std::hypot(1.0, horizon));
    sum += z * integrand(from_angles(std::acos(beside), viewer + phi));
  }
  return 2 * std::numbers::pi / count * sum;
}

/// Eq. 36 over omega_i, with d omega_i = 4 (o.h) d omega_h: the half vector is found again from omega_i.
Estimate weak_furnace(const Microsurface& surface, const Direction& o, double tolerance) {
  ViewerRows rows(o);
  const double c = surface.slopes().project(o).c;
  std::vector<double> density;
  const auto integrand = [&](const std::vector<Direction>& h, std::vector<double>& out) {
    const Batch batch = rows.with_lights(h.size(), [&](std::size_t k) { return reflected(o, h[k]); });
    density.resize(h.size());
    evaluate(surface, {Quantity::d, Quantity::g1}, batch, {density.data(), out.data()});
    for (std::size_t k = 0; k < h.size(); ++k) out[k] *= density[k] / (4 * c) * (4 * dot(o, h[k]));
  };
  std::vector<double> one(1);
  const double steepest = mass_of_steepest(o, c, [&](const Direction& h) {
    integrand({h}, one);
    return std::fabs(one[0]);
  });
  Estimate estimate = integrate_visible(surface, o, tolerance - std::min(steepest, 0.8 * tolerance), integrand);
  // o + i has a length of 2 o.h ~ 2 c, and the half vector that many roundings, of which D sees the ratio to its width.
  estimate.error += steepest + 8 * std::numeric_limits<double>::epsilon() * std::fabs(estimate.value) /
                                   (c * std::min(1.0, narrowest_width(surface.distribution)));
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
  const Estimate area = sum_over_components(surface.distribution, o, asked / scale, of_component);
  return {scale * area.value, scale * area.error, area.evaluations};
}

/// Of one term, with F = 1 or an albedo of 1; of the channels of what is measured, which cannot be made white, the
/// largest.
Estimate furnace(const WeightedTerm& weighted, const Direction& o, double tolerance) {
  const BrdfTerm white = std::visit([](const auto& term) -> BrdfTerm { return term.white(); }, weighted.term);
  const int channels = std::visit([](const auto& term) { return term.channels(); }, white);
  const ChannelRange all{0, static_cast<std::size_t>(channels)};
  const ColourEstimate light = reflected_light(white, o, tolerance, all, every_direction);
  const auto largest = std::ranges::max_element(light.value) - light.value.begin();
  return light.channel(static_cast<std::size_t>(largest));
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
  ViewerRows rows(o);
  double sum = 0;
  for (int row = 0; row * step <= std::numbers::pi; ++row) {
    const double sin_theta = std::sin(row * step), cos_theta = std::cos(row * step);
    const Batch batch = rows.with_lights(n, [&](std::size_t k) {
      return Direction{azimuths[k][0] * sin_theta, azimuths[k][1] * sin_theta, cos_theta};
    });
    evaluate(surface, {Quantity::g1, Quantity::d}, batch, {g1.data(), d.data()});
    for (std::size_t k = 0; k < n; ++k)
      if (g1[k] > 0) sum += sin_theta * g1[k] * d[k];
  }
  return sum * step * step / (4 * c);
}

/// atan2 of the mean horizontal and vertical component of omega_i, weighted by rho cos theta_i. What is dark is asked
/// for again, as much more accurately as it is darker.
Estimate mean_theta_i(const std::vector<const WeightedTerm*>& terms, const Direction& o, double tolerance,
                      std::size_t channel) {
  const Direction along = azimuth(o);
  const std::vector<LightWeight> parts = {[&](const Direction& i) { return dot(along, i); },
                                          [](const Direction& i) { return i.z; }};
  double length = 0;
  const auto mean = [&](double asked) -> Estimate {
    const ColourEstimate light = reflected_moments(terms, o, asked, channel, parts);
    const Estimate x = light.channel(0), z = light.channel(1);
    length = std::hypot(x.value, z.value);
    return {std::atan2(x.value, z.value), length > 0 ? (x.error + z.error) / length : infinity, light.evaluations};
  };
  const Estimate estimate = mean(0.1 * tolerance);
  return estimate.error <= tolerance || !(length > 0) || length >= 1 ? estimate : mean(0.1 * tolerance * length);
}

/// The smallest width of the distributions of a material, in slopes; 1 where it has none.
double narrowest_width(const Material& material) {
  double width = 1;
  for (const WeightedTerm& term : material.terms)
    if (const Distribution* facets = term.facets()) width = std::min(width, narrowest_width(*facets));
  return width;
}

bool is_of_surface(Integral integral) {
  return integral == Integral::projected_area || integral == Integral::visible_norm ||
         integral == Integral::weak_furnace || integral == Integral::weak_furnace_grid;
}

/// The term with a microsurface and a Fresnel term.
const WeightedTerm& mirror_term(const Material& material, const std::string& name) {
  const WeightedTerm& term = material.term_with_surface(name);
  if (term.fresnel() == nullptr) throw InputError(material.name, "the term \"" + term.name + "\" has no Fresnel term");
  return term;
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

/// Whether it is a place, which is as exact as it can be and has no tolerance.
bool is_peak(Integral integral) {
  return integral == Integral::peak_theta_i || integral == Integral::brdf_peak_theta_i;
}

/// \throws AccuracyError when the error estimate is above the tolerance.
double checked(const Estimate& estimate, Integral integral, const Material& material, const Direction& omega_o,
               double tolerance) {
  const std::string& name = integrals()[static_cast<std::size_t>(integral)].name;
  const std::string place = " at omega_o = (" + format_number(omega_o.x) + ", " + format_number(omega_o.y) + ", " +
                            format_number(omega_o.z) + ")";
  if (!std::isfinite(estimate.value))
    throw AccuracyError(name, "found " + format_number(estimate.value) + place + "; accepted: a finite number");
  const double scale =
      integral == Integral::projected_area ? std::max(0.0, material.mesosurface().project(omega_o).c) : 1;
  // Written so that a NaN does not pass.
  if (!(estimate.error <= tolerance * scale) && !is_peak(integral))
    throw AccuracyError(name, "reached an error estimate of " + format_number(estimate.error) +
                                  " (asked: " + format_number(tolerance * scale) + ")" + place);
  return estimate.value;
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
      {Integral::brdf_peak_theta_i, "brdf_peak_theta_i", "angle of the largest rho in the plane of incidence, rad",
       true},
      {Integral::mean_fresnel, "mean_fresnel", "mean of F over the visible normals, Eq. 105", true},
      {Integral::average_fresnel, "average_fresnel",
       "mean of F under light from everywhere [Akenine-Moller et al. 2018, Eqs. 9.58-9.60]", true},
  };
  return all;
}

void require(const Material& material, const IntegralInfo& info, const std::string& term) {
  if (is_of_surface(info.integral))
    (void)material.surface(term);
  else if (info.integral == Integral::mean_fresnel)
    (void)mirror_term(material, term);
  else if (info.integral == Integral::average_fresnel)
    (void)term_with_fresnel(material, term);
  else if (info.integral == Integral::furnace)
    (void)furnace_term(material, term);
  else
    (void)terms_of(material, term);
  if (!is_peak(info.integral)) return;
  for (const WeightedTerm& one : material.terms)
    if (std::visit(
            [](const auto& t) {
              return requires { t.piecewise_constant; };
            },
            one.term))
      throw InputError(material.name, "\"" + info.name + "\" is a place on a smooth lobe, and the term \"" + one.name +
                                          "\" has steps; accepted: a material without it");
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
  const auto c = static_cast<std::size_t>(channel);
  switch (integral) {
  case Integral::furnace: return furnace(furnace_term(material, term), omega_o, tolerance);
  case Integral::albedo:
    return reflected_light(terms_of(material, term), omega_o, tolerance, {c, 1}, every_direction).channel(0);
  case Integral::mean_theta_i: return mean_theta_i(terms_of(material, term), omega_o, tolerance, c);
  case Integral::mean_fresnel: return mean_visible_reflectance(mirror_term(material, term), omega_o, tolerance, c);
  case Integral::average_fresnel: return {mean_fresnel(*term_with_fresnel(material, term).fresnel(), c), 1e-12, 0};
  case Integral::brdf_peak_theta_i:
    return peak_theta_i(material, Quantity::brdf, omega_o, narrowest_width(material), channel);
  default: return peak_theta_i(material, Quantity::brdf_cos, omega_o, narrowest_width(material), channel);
  }
}

ColourEstimate compute_channels(Integral integral, const Material& material, const Direction& omega_o, double tolerance,
                                const std::string& term) {
  const bool coloured = integrals()[static_cast<std::size_t>(integral)].coloured;
  const std::size_t count = coloured ? static_cast<std::size_t>(material.channels()) : 1;
  if (integral == Integral::albedo && material.mesosurface().project(omega_o).c > 0)
    return reflected_light(terms_of(material, term), omega_o, tolerance, {0, count}, every_direction);
  ColourEstimate all;
  for (std::size_t c = 0; c < count; ++c) {
    const Estimate one = compute(integral, material, omega_o, tolerance, static_cast<int>(c), term);
    all.value[c] = one.value;
    all.error[c] = one.error;
    all.evaluations += one.evaluations;
  }
  return all;
}

double compute_or_throw(Integral integral, const Material& material, const Direction& omega_o, double tolerance,
                        int channel, const std::string& term) {
  return checked(compute(integral, material, omega_o, tolerance, channel, term), integral, material, omega_o,
                 tolerance);
}

Rgb compute_channels_or_throw(Integral integral, const Material& material, const Direction& omega_o, double tolerance,
                              const std::string& term) {
  const ColourEstimate all = compute_channels(integral, material, omega_o, tolerance, term);
  Rgb values{};
  for (std::size_t c = 0; c < values.size(); ++c)
    values[c] = checked(all.channel(c), integral, material, omega_o, tolerance);
  return values;
}

} // namespace brdfplot
