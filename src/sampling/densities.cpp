/// \file
/// The density of a sampler over batches of pairs.

#include "sampling/sampler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

/// Numbers stay in the first-level cache from kernel to kernel.
constexpr std::size_t pairs_at_once = 256;
using Row = std::array<double, pairs_at_once>;

/// Half vectors of pairs and the lengths of o + i; 0 where the two are opposite.
struct HalfVectors {
  Row x, y, z, length;

  kernels::Vectors<double> view() const { return {x.data(), y.data(), z.data()}; }
};

/// `turned`: a mirror with a normal that turns away from the viewer is seen from behind, and its half vector is -m.
void set_half_vectors(const Columns& o, const Columns& i, std::size_t n, bool turned, HalfVectors& to) {
  for (std::size_t k = 0; k < n; ++k) {
    const double x = o.x[k] + i.x[k], y = o.y[k] + i.y[k], z = o.z[k] + i.z[k];
    const double norm2 = x * x + y * y + z * z; // of unit vectors: 0 or no less than 1e-33
    const double length = std::sqrt(norm2), scale = norm2 > 0 ? 1 / length : 0;
    const double sided = turned && z < 0 ? -scale : scale;
    to.x[k] = sided * x, to.y[k] = sided * y, to.z[k] = sided * z;
    to.length[k] = length;
  }
}

/// D(m) / (4 sigma(o)), or D(m) m.g / (4 o.m), where |o + i| = 2 |o.m|.
void mirrored_densities(const Facets& facets, bool visible, std::size_t n, const Columns& o, const Columns& i,
                        double* out) {
  HalfVectors m;
  set_half_vectors(o, i, n, !visible, m);
  std::visit([&](const auto& d) { d.densities(m.view(), out, n); }, facets.distribution());
  if (visible) {
    Row area;
    facets.visible_areas({o.x, o.y, o.z}, area.data(), n);
    for (std::size_t k = 0; k < n; ++k) out[k] = out[k] > 0 ? out[k] / (4 * area[k]) : out[k];
  } else {
    for (std::size_t k = 0; k < n; ++k) out[k] = out[k] > 0 ? out[k] * (m.z[k] / (2 * m.length[k])) : out[k];
  }
}

Columns from(const Columns& columns, std::size_t first) {
  return {columns.x + first, columns.y + first, columns.z + first};
}

} // namespace

void Sampler::lobe_densities(const Lobe& lobe, std::size_t n, const Columns& omega_o, const Columns& omega_i,
                             double* out) const {
  if (lobe.direct != nullptr) {
    for (std::size_t k = 0; k < n; ++k) out[k] = lobe.direct->density(omega_o[k], omega_i[k]);
    return;
  }
  if (lobe.facets == nullptr) {
    for (std::size_t k = 0; k < n; ++k) out[k] = std::fmax(dot(omega_i[k], mean_normal_), 0.0) * std::numbers::inv_pi;
    return;
  }
  for (std::size_t first = 0; first < n; first += pairs_at_once)
    mirrored_densities(*lobe.facets, draws_visible(lobe.strategy), std::min(pairs_at_once, n - first),
                       from(omega_o, first), from(omega_i, first), out + first);
}

void Sampler::densities(std::size_t n, const Columns& omega_o, const Columns& omega_i, double* out) const {
  const std::vector<double> shares = shares_of_rows(n, omega_o);
  std::fill_n(out, n, 0.0);
  std::vector<double> of_lobe(n);
  for (std::size_t l = 0; l < lobes_.size(); ++l) {
    lobe_densities(lobes_[l], n, omega_o, omega_i, of_lobe.data());
    const double* const share = shares.data() + l * n;
    for (std::size_t k = 0; k < n; ++k) out[k] += share[k] > 0 ? share[k] * of_lobe[k] : 0;
  }
}

} // namespace brdfplot
