/// \file
/// Directions for a batch of points: those that fall to a component with a kernel together, the others one by one.

#include "sampling/sampler.hpp"

#include <algorithm>

namespace brdfplot {

namespace {

/// Numbers stay in the first-level cache from where they are sorted to where they are used.
constexpr std::size_t batch_size = 256;

/// The points of a batch that fall to one component of one lobe.
struct Group {
  std::size_t lobe = 0, component = 0, n = 0;
  std::array<std::size_t, batch_size> places;
  std::array<double, batch_size> u1, u2;

  void add(std::size_t place, const SamplePoint& point) {
    places[n] = place;
    u1[n] = point[0], u2[n] = point[1];
    ++n;
  }
};

} // namespace

class SampleBatches {
public:
  SampleBatches(const Sampler& sampler, const Direction& omega_o, DirectionArrays& out)
      : viewer_(sampler, omega_o), out_(out) {
    for (std::size_t l = 0; l < viewer_.facets_.size(); ++l) {
      first_group_.push_back(groups_.size());
      const std::size_t components = viewer_.facets_[l] ? viewer_.facets_[l]->components() : 0;
      for (std::size_t c = 0; c < components; ++c) {
        groups_.emplace_back();
        groups_.back().lobe = l, groups_.back().component = c;
      }
    }
  }

  /// Whether all points fall to one kernel, which then has the density too.
  bool one_kernel() const {
    return viewer_.shares_.size() == 1 && groups_.size() == 1 && viewer_.facets_[0]->has_kernel(0);
  }

  /// `pdf`: null, or of one_kernel() where the densities go.
  void run(const std::vector<SamplePoint>& points, double* pdf) {
    if (pdf != nullptr) return run_kernel(points, pdf);
    for (std::size_t first = 0; first < points.size(); first += batch_size) {
      const std::size_t n = std::min(batch_size, points.size() - first);
      for (std::size_t k = 0; k < n; ++k) sort(points[first + k], first + k);
      for (Group& group : groups_) flush(group);
    }
  }

private:
  void run_kernel(const std::vector<SamplePoint>& points, double* pdf) {
    std::array<double, batch_size> u1, u2;
    for (std::size_t first = 0; first < points.size(); first += batch_size) {
      const std::size_t n = std::min(batch_size, points.size() - first);
      for (std::size_t k = 0; k < n; ++k) u1[k] = points[first + k][0], u2[k] = points[first + k][1];
      viewer_.facets_[0]->mirror(0, u1.data(), u2.data(), {&out_.x[first], &out_.y[first], &out_.z[first], pdf + first},
                                 n);
    }
  }

  /// Into its group, or drawn at once.
  void sort(const SamplePoint& point, std::size_t place) {
    if (viewer_.shares_.empty()) return out_.set(place, viewer_.sample(point));
    SamplePoint rest = point;
    const std::size_t lobe = chosen(viewer_.shares_, rest[2]);
    if (!viewer_.facets_[lobe]) return out_.set(place, viewer_.sample(point));
    const std::size_t component = viewer_.facets_[lobe]->component(rest[2]);
    if (!viewer_.facets_[lobe]->has_kernel(component)) return out_.set(place, viewer_.sample(point));
    groups_[first_group_[lobe] + component].add(place, rest);
  }

  void flush(Group& group) {
    const Facets::Viewer* facets = group.n > 0 ? &*viewer_.facets_[group.lobe] : nullptr;
    if (facets == nullptr) return;
    std::array<double, batch_size> x, y, z, density;
    facets->mirror(group.component, group.u1.data(), group.u2.data(), {x.data(), y.data(), z.data(), density.data()},
                   group.n);
    for (std::size_t k = 0; k < group.n; ++k) out_.set(group.places[k], {x[k], y[k], z[k]});
    group.n = 0;
  }

  Sampler::Viewer viewer_;
  DirectionArrays& out_;
  std::vector<Group> groups_;
  std::vector<std::size_t> first_group_; ///< of each lobe
};

void Sampler::sample(const Direction& omega_o, const std::vector<SamplePoint>& points, DirectionArrays& omega_i) const {
  std::vector<double> pdf;
  omega_i.resize(points.size());
  SampleBatches batches(*this, omega_o, omega_i);
  if (batches.one_kernel()) pdf.resize(points.size());
  batches.run(points, batches.one_kernel() ? pdf.data() : nullptr);
}

void Sampler::sample(const Direction& omega_o, const std::vector<SamplePoint>& points, DirectionArrays& omega_i,
                     std::vector<double>& pdf) const {
  omega_i.resize(points.size());
  pdf.resize(points.size());
  SampleBatches batches(*this, omega_o, omega_i);
  const bool with_density = batches.one_kernel();
  batches.run(points, with_density ? pdf.data() : nullptr);
  if (with_density) return;
  ViewerRows rows(omega_o);
  const Batch batch = rows.with_lights(points.size(), [&](std::size_t k) { return omega_i.view()[k]; });
  densities(batch.n, batch.o, batch.i, pdf.data());
}

} // namespace brdfplot
