#include "brdf/diffuse.hpp"

#include "brdf/blocks/surface_quantities.hpp"
#include "brdf/integrals/components.hpp"
#include "brdf/integrals/kinks.hpp"
#include "integrate/facing_normals.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numbers>

namespace brdfplot {

namespace {

/// evaluate() of normals that share the other directions.
class AtNormals {
public:
  explicit AtNormals(const Microsurface& surface) : surface_(surface) {}

  /// Into `out`, one value a normal; `o` and `i` where the quantity needs them.
  void operator()(Quantity quantity, const Direction* o, const Direction* i, const std::vector<Direction>& normals,
                  std::vector<double>& out) {
    const std::size_t n = normals.size();
    fill(m_, n, [&](std::size_t k) { return normals[k]; });
    if (o != nullptr) fill(o_, n, [&](std::size_t) { return *o; });
    if (i != nullptr) fill(i_, n, [&](std::size_t) { return *i; });
    out.resize(n);
    evaluate(surface_, quantity,
             {n, o != nullptr ? view(o_) : Columns{}, i != nullptr ? view(i_) : Columns{}, view(m_)}, out.data());
  }

private:
  using Arrays = std::array<std::vector<double>, 3>;

  template <class DirectionOf>
  static void fill(Arrays& arrays, std::size_t n, const DirectionOf& direction_of) {
    for (auto& array : arrays) array.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const Direction d = direction_of(k);
      arrays[0][k] = d.x;
      arrays[1][k] = d.y;
      arrays[2][k] = d.z;
    }
  }
  static Columns view(const Arrays& arrays) { return {arrays[0].data(), arrays[1].data(), arrays[2].data()}; }

  const Microsurface& surface_;
  Arrays o_, i_, m_;
};

Direction mean_normal(const SlopeMap& map) { return normalized({-map.mean_x, -map.mean_y, 1}); }

using Weight = std::function<void(const std::vector<Direction>& normals, std::vector<double>& weights)>;

/// Those of G1 and G2 as functions of the normal.
NormalKinks kinks_of_normals(const Microsurface& surface) {
  return {.lines = !surface.has_lambda(), .anywhere = !surface.has_lambda() && is_formula(surface.masking)};
}

/// int D(m) g(m) dm over the normals that face the directions, component by component. `kinks`: of g.
Estimate integrate_density(const Microsurface& surface, std::span<const Direction> directions, NormalKinks kinks,
                           const Weight& g, const Tolerance& tolerance) {
  const auto parts = components(surface.distribution);
  const Tolerance of_part{tolerance.absolute / static_cast<double>(parts.size()), tolerance.relative};
  Estimate sum;
  std::vector<double> density;
  for (const Component& component : parts) {
    const auto integrand = [&](const std::vector<Direction>& m, std::vector<double>& out) {
      g(m, out);
      component.densities(m, density);
      for (std::size_t k = 0; k < m.size(); ++k)
        if (out[k] != 0) out[k] *= density[k];
    };
    kinks.radii = component.radii;
    const Estimate one =
        integrate_over_facing(component.frame, component.mesosurface, directions, kinks, integrand, of_part);
    sum.value += one.value;
    sum.error += one.error;
    sum.evaluations += one.evaluations;
  }
  return sum;
}

/// Writes int <i,m> di / pi of each facet, by directions in steps of <i,m> and of azimuth about m: a Gauss rule that is
/// exact for it.
void write_light_on_facets(const std::vector<Direction>& normals, std::vector<double>& out) {
  static const std::vector<Direction> rule = [] { // about the pole
    const double gauss = 0.5 / std::sqrt(3.0);
    std::vector<Direction> nodes;
    for (const double z : {0.5 - gauss, 0.5 + gauss})
      for (int k = 0; k < 4; ++k) {
        const double r = std::sqrt(1 - z * z), psi = 0.5 * std::numbers::pi * k;
        nodes.push_back({r * std::cos(psi), r * std::sin(psi), z});
      }
    return nodes;
  }();
  // In loops over few facets without a branch, so that the compiler takes several at a time.
  constexpr std::size_t capacity = 64;
  std::array<double, capacity> mx, my, mz, tx, ty, tz, bx, by, bz, sum;
  out.resize(normals.size());
  for (std::size_t first = 0; first < normals.size(); first += capacity) {
    const std::size_t n = std::min(capacity, normals.size() - first);
    for (std::size_t k = 0; k < n; ++k) {
      const Direction& m = normals[first + k];
      mx[k] = m.x;
      my[k] = m.y;
      mz[k] = m.z;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double x = std::fabs(mx[k]) < 0.5 ? 1 : 0, y = 1 - x; // an axis that is far from m
      const double along = x * mx[k] + y * my[k];
      const double across_x = x - along * mx[k], across_y = y - along * my[k], across_z = -along * mz[k];
      const double scale = 1 / std::sqrt(across_x * across_x + across_y * across_y + across_z * across_z); // below 1.25
      tx[k] = scale * across_x;
      ty[k] = scale * across_y;
      tz[k] = scale * across_z;
      bx[k] = my[k] * tz[k] - mz[k] * ty[k];
      by[k] = mz[k] * tx[k] - mx[k] * tz[k];
      bz[k] = mx[k] * ty[k] - my[k] * tx[k];
      sum[k] = 0;
    }
    for (const Direction& node : rule)
      for (std::size_t k = 0; k < n; ++k) {
        const double x = node.z * mx[k] + node.x * tx[k] + node.y * bx[k];
        const double y = node.z * my[k] + node.x * ty[k] + node.y * by[k];
        const double z = node.z * mz[k] + node.x * tz[k] + node.y * bz[k];
        const double facing = x * mx[k] + y * my[k] + z * mz[k];
        sum[k] += std::max(0.0, facing) * (0.5 * 0.5 * std::numbers::pi);
      }
    for (std::size_t k = 0; k < n; ++k) out[first + k] = sum[k] * std::numbers::inv_pi;
  }
}

} // namespace

Estimate diffuse_brdf(const Microsurface& surface, const Direction& omega_o, const Direction& omega_i,
                      const Tolerance& tolerance) {
  const SlopeMap& map = surface.slopes();
  const double c_o = map.project(omega_o).c;
  const double c_i = map.project(omega_i).c;
  if (!(c_o > 0 && c_i > 0)) return {};
  AtNormals at(surface);
  std::vector<double> g2;
  // With a Lambda, G2 is one number for all normals that face both; the mean normal does.
  const bool constant = surface.has_lambda();
  if (constant) at(Quantity::g2, &omega_o, &omega_i, {mean_normal(map)}, g2);
  const double scale = (constant ? g2[0] / c_o / c_i : 1 / c_o / c_i) * std::numbers::inv_pi;
  const auto integrand = [&](const std::vector<Direction>& m, std::vector<double>& out) {
    out.resize(m.size());
    if (!constant) at(Quantity::g2, &omega_o, &omega_i, m, g2);
    for (std::size_t k = 0; k < m.size(); ++k) {
      const double facing = std::max(0.0, dot(omega_o, m[k])) * std::max(0.0, dot(omega_i, m[k]));
      out[k] = facing * scale * (constant ? 1 : g2[k]);
    }
  };
  const std::array<Direction, 2> both = {omega_o, omega_i};
  return integrate_density(surface, both, kinks_of_normals(surface), integrand, tolerance);
}

Estimate diffuse_weak_furnace(const Microsurface& surface, const Direction& omega_o, double tolerance) {
  const double c_o = surface.slopes().project(omega_o).c;
  AtNormals at(surface);
  std::vector<double> g1;
  // With a Lambda, G1 is one number for all normals that face the viewer; the mean normal does.
  const bool constant = surface.has_lambda();
  if (constant) at(Quantity::g1, &omega_o, nullptr, {mean_normal(surface.slopes())}, g1);
  const auto integrand = [&](const std::vector<Direction>& m, std::vector<double>& out) {
    write_light_on_facets(m, out);
    if (!constant) at(Quantity::g1, &omega_o, nullptr, m, g1);
    for (std::size_t k = 0; k < m.size(); ++k)
      out[k] = g1[constant ? 0 : k] * std::max(0.0, dot(omega_o, m[k])) / c_o * out[k];
  };
  Estimate estimate =
      integrate_density(surface, std::span(&omega_o, 1), kinks_of_normals(surface), integrand, {.absolute = tolerance});
  // At grazing o.m is a difference of terms that are rounded.
  estimate.error += 4 * std::numeric_limits<double>::epsilon() * std::fabs(estimate.value) / c_o;
  return estimate;
}

Estimate ground_area(const Microsurface& surface, double tolerance) { return sum_of_normals(surface, 2, tolerance); }

Estimate sum_of_normals(const Microsurface& surface, std::size_t axis, double tolerance) {
  const auto component = [axis](const std::vector<Direction>& m, std::vector<double>& out) {
    out.resize(m.size());
    for (std::size_t k = 0; k < m.size(); ++k) out[k] = axis == 0 ? m[k].x : axis == 1 ? m[k].y : m[k].z;
  };
  return integrate_density(surface, {}, {}, component, {.absolute = tolerance});
}

} // namespace brdfplot
