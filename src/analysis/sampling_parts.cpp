#include "analysis/sampling_parts.hpp"

#include "brdf/blocks/viewer_rows.hpp"
#include "integrate/hemisphere.hpp"
#include "integrate/slope_domain.hpp"
#include "sampling/cosine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

constexpr std::size_t sectors = 16;        ///< cells along the azimuth
constexpr std::size_t most_midpoints = 16; ///< across a cell, each way

/// Edges of cells along u: evenly, and towards 1, where slopes grow without bound, by quarters of what is left.
std::vector<double> graded_edges() {
  std::vector<double> edges;
  for (int k = 0; k < 16; ++k) edges.push_back(k / 16.0);
  for (double left = 1 / 64.0; left > 1e-6; left /= 4) edges.push_back(1 - left);
  edges.push_back(1);
  return edges;
}

/// The slope of m in the frame: its norm and azimuth there.
std::pair<double, double> slope_in_frame(const SlopeMap& frame, const Direction& m) {
  const double u = (-m.x / m.z - frame.mean_x) / frame.alpha_x;
  const double v = (-m.y / m.z - frame.mean_y) / frame.alpha_y;
  const double w = (v - frame.correlation * u) / frame.decorrelation();
  return {std::hypot(u, w), std::atan2(w, u)};
}

/// The axes of sample_cosine() about n.
std::array<Direction, 2> axes_about(const Direction& n) {
  const double a = -1 / (1 + n.z), b = n.x * n.y * a;
  return {Direction{1 + n.x * n.x * a, b, -n.x}, Direction{b, 1 + n.y * n.y * a, -n.y}};
}

} // namespace

SamplingPart::SamplingPart(const Sampler& sampler, std::size_t lobe, std::size_t component, const Direction& omega_o)
    : sampler_(sampler), lobe_(sampler.lobes()[lobe]), component_(component), omega_o_(omega_o),
      share_(sampler.shares(omega_o)[lobe]),
      mean_normal_(normalized({-sampler.mesosurface().mean_x, -sampler.mesosurface().mean_y, 1})) {
  if (lobe_.facets == nullptr) {
    for (int k = 0; k <= 16; ++k) edges_.push_back(k / 16.0);
    return;
  }
  slopes_.emplace_back(*this->component());
  edges_ = graded_edges();
  for (const double edge : edges_) norms_.push_back(edge < 1 ? slopes_[0].within(edge) : infinity);
}

const Component* SamplingPart::component() const { return &lobe_.facets->components()[component_]; }

void SamplingPart::densities(const std::vector<Direction>& omega_i, std::vector<double>& out) const {
  ViewerRows rows(omega_o_);
  const Batch batch = rows.with_lights(omega_i.size(), [&](std::size_t k) { return omega_i[k]; });
  out.resize(omega_i.size());
  sampler_.lobe_densities(lobe_, batch.n, batch.o, batch.i, out.data());
  for (double& value : out) value *= share_;
  if (lobe_.facets == nullptr || lobe_.facets->components().size() == 1) return;
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (!(out[k] > 0)) continue;
    Direction m = half_vector(omega_o_, omega_i[k]);
    if (m.z < 0) m = -1.0 * m;
    double all = 0;
    for (const Component& one : lobe_.facets->components()) all += one.density(m);
    out[k] *= component()->density(m) / all;
  }
}

Estimate SamplingPart::over_hemisphere(const LightDensity& f, double tolerance) const {
  std::vector<double> values;
  HemisphereIntegrand integrand{{}, 1, false};
  integrand.rho = [&](const std::vector<Direction>& omega_i, const Tolerance&, std::vector<double>& value,
                      std::vector<double>& error) {
    f(omega_i, values);
    for (std::size_t k = 0; k < omega_i.size(); ++k) {
      value[k] = values[k] / sampler_.mesosurface().project(omega_i[k]).c;
      error[k] = 1e-14 * (std::fabs(value[k]) + 1);
    }
  };
  return integrate_hemisphere(sampler_.mesosurface(), integrand, omega_o_, tolerance,
                              [](const Direction&) { return 1.0; })
      .channel(0);
}

NormalIntegrand SamplingPart::over_normals(const LightDensity& f) const {
  return [this, f, lights = std::vector<Direction>(),
          values = std::vector<double>()](const std::vector<Direction>& m, std::vector<double>& out) mutable {
    lights.resize(m.size());
    for (std::size_t k = 0; k < m.size(); ++k) lights[k] = normalized(reflected(omega_o_, m[k]));
    f(lights, values);
    // Of normals nearer to the horizon the half vector has no digit.
    constexpr double upright = 1e-30;
    for (std::size_t k = 0; k < m.size(); ++k)
      out[k] = m[k].z > upright ? values[k] * 4 * std::fabs(dot(omega_o_, m[k])) : 0;
  };
}

Estimate SamplingPart::integral(const LightDensity& f, double tolerance) const {
  if (lobe_.facets == nullptr) return over_hemisphere(f, tolerance);
  // All facets face the vertical; those that are drawn as they are seen face the viewer.
  const bool seen = draws_visible(lobe_.strategy);
  const SlopeFrame frame = component()->seen_from(seen ? omega_o_ : Direction{0, 0, 1});
  return integrate_facing(frame, {over_normals(f), {}, false, false}, tolerance);
}

Estimate SamplingPart::lit_integral(const LightDensity& f, double tolerance) const {
  if (lobe_.facets == nullptr) return over_hemisphere(f, tolerance);
  const SlopeFrame frame = component()->seen_from(omega_o_);
  return integrate_lit(frame, {over_normals(f), 1, {}, false, false}, tolerance).channel(0);
}

std::size_t SamplingPart::cell_count() const { return (edges_.size() - 1) * sectors; }

std::size_t SamplingPart::cell_of(const Direction& omega_i) const {
  double azimuth = 0;
  std::size_t ring = 0;
  const auto index_in = [](const std::vector<double>& edges, double value) {
    const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, value);
    return static_cast<std::size_t>(above - edges.begin() - 1);
  };
  if (lobe_.facets == nullptr) {
    const auto [t, s] = axes_about(mean_normal_);
    azimuth = std::atan2(dot(omega_i, s), dot(omega_i, t));
    const double z = dot(omega_i, mean_normal_);
    ring = index_in(edges_, (1 - z) * (1 + z));
  } else {
    Direction m = half_vector(omega_o_, omega_i);
    if (m.z < 0) m = -1.0 * m;
    const auto [norm, angle] = slope_in_frame(component()->frame, m);
    azimuth = angle;
    ring = index_in(norms_, norm);
  }
  const double turn = azimuth / (2 * std::numbers::pi);
  const double positive = turn < 0 ? turn + 1 : turn;
  return ring * sectors + std::min(sectors - 1, static_cast<std::size_t>(positive * sectors));
}

SamplingPart::Place SamplingPart::place(double u, double norm, double azimuth) const {
  if (lobe_.facets == nullptr) {
    const Direction omega_i = sample_cosine(mean_normal_, u, azimuth);
    return {omega_i, std::numbers::pi / std::fmax(dot(omega_i, mean_normal_), 1e-300)};
  }
  const double psi = 2 * std::numbers::pi * azimuth;
  const auto [x, y] = component()->frame.slope(norm * std::cos(psi), norm * std::sin(psi));
  const Direction m = normalized({-x, -y, 1});
  const double ground = component()->density(m) / component()->weight * m.z;
  return {normalized(reflected(omega_o_, m)), ground > 0 ? 4 * std::fabs(dot(omega_o_, m)) / ground : 0};
}

std::vector<double> SamplingPart::midpoint_sums(const LightDensity& f, std::size_t midpoints) const {
  std::vector<double> sums(cell_count(), 0);
  std::vector<Direction> lights;
  std::vector<double> areas, values;
  const std::size_t azimuths = sectors * midpoints;
  for (std::size_t ring = 0; ring + 1 < edges_.size(); ++ring) {
    lights.clear();
    areas.clear();
    const double from = edges_[ring], width = edges_[ring + 1] - from;
    const bool outermost = lobe_.facets != nullptr && ring + 2 == edges_.size();
    for (std::size_t j = 0; j < midpoints; ++j) {
      const double t = (static_cast<double>(j) + 0.5) / static_cast<double>(midpoints);
      // The outermost ring has no end; its midpoints gather towards 1 so that what grows there is seen.
      const double u = std::fmin(outermost ? 1 - width * std::pow(t, 6) : from + width * t, 1 - 0x1p-53);
      const double weight = width * (outermost ? 6 * std::pow(t, 5) : 1) / static_cast<double>(midpoints * azimuths);
      const double norm = slopes_.empty() ? 0 : slopes_[0].within(u);
      for (std::size_t k = 0; k < azimuths; ++k) {
        const auto [omega_i, area] = place(u, norm, (static_cast<double>(k) + 0.5) / static_cast<double>(azimuths));
        lights.push_back(omega_i);
        areas.push_back(area * weight);
      }
    }
    f(lights, values);
    for (std::size_t k = 0; k < lights.size(); ++k)
      sums[ring * sectors + k % azimuths / midpoints] += areas[k] > 0 ? values[k] * areas[k] : 0;
  }
  return sums;
}

std::vector<Estimate> SamplingPart::integrals_over_cells(const LightDensity& f) const {
  const std::vector<double> half = midpoint_sums(f, most_midpoints / 2), full = midpoint_sums(f, most_midpoints);
  std::vector<Estimate> all;
  for (std::size_t k = 0; k < full.size(); ++k) all.push_back({full[k], std::fabs(full[k] - half[k]), 0});
  return all;
}

std::vector<SamplingPart> parts_of(const Sampler& sampler, const Direction& omega_o) {
  std::vector<SamplingPart> parts;
  for (std::size_t lobe = 0; lobe < sampler.lobes().size(); ++lobe) {
    const auto& facets = sampler.lobes()[lobe].facets;
    const std::size_t count = facets == nullptr ? 1 : facets->components().size();
    for (std::size_t k = 0; k < count; ++k) parts.emplace_back(sampler, lobe, k, omega_o);
  }
  return parts;
}

} // namespace brdfplot
