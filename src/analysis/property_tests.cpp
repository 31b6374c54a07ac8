#include "analysis/property_tests.hpp"

#include "analysis/integrals.hpp"
#include "brdf/diffuse.hpp"
#include "brdf/integrals/components.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Relative error of what evaluate() gives: of a Lambda by quadrature, the worst there is.
constexpr double value_error = 1e-10;

/// Whether rho of all terms is a closed form.
bool is_closed_form(const Material& material) {
  return std::ranges::all_of(material.terms, [](const WeightedTerm& weighted) {
    return std::visit(
        [](const auto& term) {
          return !requires(const Direction& d) { term.brdf(d, d, Tolerance{}); };
        },
        weighted.term);
  });
}

template <class Measure>
void at_viewers(const PropertySubject& subject, const PropertySearch& search, const Measure& measure) {
  for (const double phi : subject.azimuths)
    for (const double theta : search.theta_o) measure(subject.viewer(theta, phi), theta, phi);
}

/// |integral / expected - 1|, where `integral_of(o, tolerance)` is to be `expected_of(o)`.
template <class IntegralOf>
void test_integral(const PropertySubject& subject, const PropertySearch& search, WorstResidual& worst,
                   bool expect_projected_area, const IntegralOf& integral_of) {
  at_viewers(subject, search, [&](const Direction& o, double theta, double phi) {
    const double expected = expect_projected_area ? subject.material.mesosurface().project(o).c : 1;
    const Estimate estimate = integral_of(o, 0.01 * search.tolerance);
    worst.take(std::fabs(estimate.value / expected - 1), estimate.error / expected, theta, phi);
  });
}

void test_weak_furnace(Property property, const PropertySubject& subject, const PropertySearch& search,
                       WorstResidual& worst) {
  const Material& material = subject.material;
  const auto by = [&](Integral integral) {
    return [&material, integral](const Direction& o, double tolerance) {
      return compute(integral, material, o, tolerance);
    };
  };
  if (property == Property::eq14)
    test_integral(subject, search, worst, true, by(Integral::projected_area));
  else if (property == Property::eq18)
    test_integral(subject, search, worst, false, by(Integral::visible_norm));
  else if (property == Property::eq36)
    test_integral(subject, search, worst, false, by(Integral::weak_furnace));
  else
    test_integral(subject, search, worst, false, [&](const Direction& o, double tolerance) {
      return diffuse_weak_furnace(*subject.surface, o, tolerance);
    });
}

void test_energy(const PropertySubject& subject, const PropertySearch& search, WorstResidual& worst) {
  // Integrals of a quadrature have four dimensions: to a tenth of the tolerance is enough to tell.
  const double tolerance = (is_closed_form(subject.material) ? 0.01 : 0.1) * search.tolerance;
  const bool one = subject.material.terms.size() == 1;
  at_viewers(subject, search, [&](const Direction& o, double theta, double phi) {
    const Integral integral = one ? Integral::furnace : Integral::albedo;
    const ColourEstimate all = compute_channels(integral, subject.material, o, tolerance);
    for (std::size_t c = 0; c < static_cast<std::size_t>(one ? 1 : subject.material.channels()); ++c) {
      const double value = all.value[c];
      worst.take(std::isnan(value) ? value : std::fmax(0, value - 1), all.error[c], theta, phi);
    }
  });
}

/// Normals out to three times the roughness, where G1 depends on them; else one that stands for all that face.
std::vector<std::optional<Direction>> normals_of(const Microsurface& surface) {
  if (surface.has_lambda()) return {std::nullopt};
  std::vector<std::optional<Direction>> normals;
  for (const Component& component : components(surface.distribution)) {
    const SlopeMap& map = component.frame;
    for (const double r : {0.0, 0.3, 1.0, 3.0})
      for (int k = 0; k < (r > 0 ? 12 : 1); ++k) {
        const auto [x, y] = map.slope(r * std::cos(30 * degree * k), r * std::sin(30 * degree * k));
        normals.emplace_back(normalized({-x, -y, 1}));
      }
  }
  return normals;
}

bool faces(const std::optional<Direction>& m, const Direction& o) { return !m || dot(*m, o) > 0; }

double g1_of(const Microsurface& surface, const Direction& o, const std::optional<Direction>& m) {
  return evaluate(surface, Quantity::g1, o, std::nullopt, m);
}

/// Every degree, and closer to grazing.
std::vector<double> fine_theta() {
  std::vector<double> theta;
  for (int k = 0; k < 90; ++k) theta.push_back(k * degree);
  for (const double degrees : {89.5, 89.9, 89.99}) theta.push_back(degrees * degree);
  return theta;
}

/// Azimuths in steps of 30 degrees even of what is isotropic, for G1 may depend on the normal's.
template <class Measure>
void at_fine_viewers(const PropertySubject& subject, const Measure& measure) {
  for (const auto& m : normals_of(*subject.surface))
    for (const double phi : subject.azimuths) measure(m, phi);
}

void test_g1(Property property, const PropertySubject& subject, WorstResidual& worst) {
  const std::vector<double> thetas = fine_theta();
  at_fine_viewers(subject, [&](const std::optional<Direction>& m, double phi) {
    double before = std::numeric_limits<double>::infinity();
    for (const double theta : thetas) {
      const Direction o = subject.viewer(theta, phi);
      if (!faces(m, o)) continue;
      const double g1 = g1_of(*subject.surface, o, m);
      const double outside = std::isnan(g1) ? g1 : std::fmax(0, std::fmax(-g1, g1 - 1));
      const double growth = std::isnan(g1) ? g1 : std::fmax(0, g1 - before);
      worst.take(property == Property::g1_range ? outside : growth, value_error, theta, phi);
      before = g1;
    }
  });
}

void test_g1_at_normal(const PropertySubject& subject, WorstResidual& worst) {
  at_fine_viewers(subject, [&](const std::optional<Direction>& m, double phi) {
    for (const double theta : {0.0, 1e-10}) {
      const Direction o = subject.viewer(theta, phi);
      if (faces(m, o)) worst.take(std::fabs(g1_of(*subject.surface, o, m) - 1), value_error, theta, phi);
    }
  });
}

/// Heitz 2014, section 5.1, with S = diag(x, y, 1): directions by S, normals by its inverse, roughnesses and slopes
/// divided.
Microsurface stretched(const PropertySubject& subject, double x, double y) {
  const SlopeMap& map = subject.surface->slopes();
  const auto with_surface = [](const TermDescription& t) { return has_surface(t); };
  TermDescription description = *std::ranges::find_if(subject.description.terms, with_surface);
  set_parameter(description, "alpha_x", map.alpha_x / x);
  set_parameter(description, "alpha_y", map.alpha_y / y);
  description.distribution.values.set("correlation", map.correlation);
  description.distribution.values.set("mean_slope", Vec2{map.mean_x / x, map.mean_y / y});
  return build_microsurface(description);
}

void test_stretching(const PropertySubject& subject, WorstResidual& worst) {
  const bool applies =
      std::visit([](const auto& distribution) { return distribution.shape_invariant; }, subject.surface->distribution);
  if (!applies) return;
  for (const auto& [x, y] : {Vec2{2, 1}, Vec2{1, 3}, Vec2{0.5, 0.25}}) {
    const Microsurface after = stretched(subject, x, y);
    at_fine_viewers(subject, [&, x = x, y = y](const std::optional<Direction>& m, double phi) {
      for (int k = 0; k < 90; k += 5) {
        const double theta = k * degree;
        const Direction o = subject.viewer(theta, phi);
        if (!faces(m, o)) continue;
        const auto m_after = m ? std::optional(normalized({m->x / x, m->y / y, m->z})) : std::nullopt;
        const double difference =
            g1_of(after, normalized({o.x * x, o.y * y, o.z}), m_after) - g1_of(*subject.surface, o, m);
        worst.take(std::fabs(difference), value_error, theta, phi);
      }
    });
  }
}

/// The left side of Eq. 9.22 is o.v with v = int D m dm: linear in o, so that the largest difference is |v - g|, g the
/// normal of the mesosurface with g_z = 1, at the o along it.
void test_projection(const PropertySubject& subject, const PropertySearch& search, WorstResidual& worst) {
  if (has_infinite_mean_slope(subject.surface->distribution)) return;
  const SlopeMap& map = subject.surface->slopes();
  const std::array<double, 3> expected = {-map.mean_x, -map.mean_y, 1};
  double residual = 0, error = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Estimate e = sum_of_normals(*subject.surface, axis, 0.003 * search.tolerance);
    residual = std::hypot(residual, e.value - expected[axis]);
    error += e.error;
  }
  worst.take(residual, error, 0, 0);
}

void test_reciprocity(const PropertySubject& subject, WorstResidual& worst) {
  constexpr std::array<double, 5> thetas = {5, 30, 60, 80, 88};
  constexpr std::array<double, 4> phis = {0, 40, 130, 200};
  // A quadrature for each value, of diffuse facets; evaluate() keeps 1e-9.
  const bool closed_form = is_closed_form(subject.material);
  const double error = closed_form ? value_error : 1e-9;
  for (const double theta_o : thetas)
    for (const double theta_i : thetas)
      for (const double phi_o : phis)
        for (const double phi_i : phis) {
          if (theta_i < theta_o || (!closed_form && phi_o != 0)) continue;
          const Direction o = subject.viewer(theta_o * degree, phi_o * degree);
          const Direction i = subject.viewer(theta_i * degree, phi_i * degree);
          const Columns viewer{&o.x, &o.y, &o.z}, light{&i.x, &i.y, &i.z};
          std::array<double, 3> there{}, back{};
          evaluate(subject.material, Quantity::brdf, {1, viewer, light, {}}, there.data());
          evaluate(subject.material, Quantity::brdf, {1, light, viewer, {}}, back.data());
          double residual = 0;
          for (std::size_t c = 0; c < there.size(); ++c)
            if (there[c] != back[c])
              residual =
                  std::fmax(residual, std::fabs(there[c] - back[c]) / (std::fabs(there[c]) + std::fabs(back[c])));
          worst.take(residual, error, theta_o * degree, phi_o * degree);
        }
}

} // namespace

void WorstResidual::take(double residual, double error, double theta_o, double phi_o) {
  if (!(residual + error <= tolerance_)) all_hold_ = false;
  if (residual - error > tolerance_) one_fails_ = true;
  const bool first = !any_;
  any_ = true;
  // Of equals, as mirror images are but for rounding, the first.
  if (!first && (std::isnan(worst_.max_residual) || residual <= worst_.max_residual * (1 + 1e-9))) return;
  worst_ = {residual, error, alpha_, theta_o, phi_o, Verdict::unknown, {}};
}

Residual WorstResidual::residual() const {
  Residual out = worst_;
  out.verdict = !any_        ? Verdict::not_applicable
                : one_fails_ ? Verdict::fails
                : all_hold_  ? Verdict::holds
                             : Verdict::unknown;
  return out;
}

PropertySubject::PropertySubject(const MaterialDescription& from) : description(from), material(build(from)) {
  std::size_t surfaces = 0;
  bool formula = false, round = true, half_turn = material.mesosurface().centred();
  for (const WeightedTerm& term : material.terms) {
    round = round && term.is_isotropic();
    const Microsurface* own = term.surface();
    const Distribution* facets = own == nullptr ? term.facets() : &own->distribution;
    half_turn = half_turn && (facets == nullptr || has_one_mesosurface(*facets));
    if (own == nullptr) continue;
    ++surfaces;
    surface = own;
    formula = formula || is_formula(own->masking);
  }
  if (surfaces > 1) surface = nullptr;
  // Without a Lambda, G1 depends on the azimuth between viewer and normal, but the integrals do not on the viewer's.
  const int count = round ? 1 : half_turn && !formula ? 6 : 12;
  for (int k = 0; k < count; ++k) azimuths.push_back(30 * degree * k);
}

Direction PropertySubject::viewer(double theta, double phi) const {
  const SlopeMap& map = material.mesosurface();
  const Direction level = from_angles(theta, phi);
  return normalized({level.x, level.y, level.z + level.x * map.mean_x + level.y * map.mean_y});
}

void test_property(Property property, const PropertySubject& subject, const PropertySearch& search,
                   WorstResidual& worst) {
  switch (property) {
  case Property::eq14:
  case Property::eq18:
  case Property::eq36:
  case Property::eq37: return test_weak_furnace(property, subject, search, worst);
  case Property::normalized: {
    const Estimate e = ground_area(*subject.surface, 0.01 * search.tolerance);
    return worst.take(std::fabs(e.value - 1), e.error, 0, 0);
  }
  case Property::eq9_22: return test_projection(subject, search, worst);
  case Property::g1_range:
  case Property::g1_decreasing: return test_g1(property, subject, worst);
  case Property::g1_normal: return test_g1_at_normal(subject, worst);
  case Property::stretch_invariance: return test_stretching(subject, worst);
  case Property::reciprocity: return test_reciprocity(subject, worst);
  case Property::energy: return test_energy(subject, search, worst);
  }
}

} // namespace brdfplot
