#include "ray_rule.hpp"

#include <algorithm>
#include <numbers>

namespace test {

using namespace brdfplot;

namespace {

using std::numbers::pi;

constexpr std::size_t node_count = 10;

/// Lobatto's rule: with nodes at both ends of a panel no jump can hide between an end and the first node.
struct Rule {
  std::array<double, node_count> x{}, w{}; ///< on [0, 1]

  Rule() {
    constexpr int n = node_count, degree = n - 1;
    for (int k = 0; k < n; ++k) {
      double z = -std::cos(pi * k / degree), p = 1;
      for (int step = 0; step < 100; ++step) { // the roots of (1 - z^2) P', by Newton
        double before = 1;
        p = z;
        for (int j = 1; j < degree; ++j) {
          const double next = ((2 * j + 1) * z * p - j * before) / (j + 1);
          before = p;
          p = next;
        }
        z -= (z * p - before) / (n * p);
      }
      x[static_cast<std::size_t>(k)] = 0.5 * (1 + z);
      w[static_cast<std::size_t>(k)] = 1 / (degree * n * p * p);
    }
  }
};

const Rule& rule() {
  static const Rule made;
  return made;
}

/// The sum of a function over panels. Each is compared with its halves; where they do not agree the halves are the
/// panels of the next round, all of which are evaluated at once.
class Panels {
public:
  /// Writes f at the points into the second argument.
  using Function = std::function<void(const std::vector<double>& at, std::vector<double>& f)>;

  /// Once `spent` evaluations are more than what a case is worth, panels are taken as they are, with their doubt.
  Panels(const Function& f, double tolerance, const std::size_t& spent) : f_(f), tolerance_(tolerance), spent_(spent) {}

  /// Over the panels between neighbours of `edges`.
  void add(const std::vector<double>& edges) {
    std::vector<Panel> panels;
    for (std::size_t k = 0; k + 1 < edges.size(); ++k)
      if (edges[k] < edges[k + 1]) panels.push_back({edges[k], edges[k + 1], 0});
    sum(panels);
    for (int round = 0; round < most_rounds && !panels.empty(); ++round) {
      std::vector<Panel> halves;
      for (const Panel& panel : panels) {
        const double middle = 0.5 * (panel.a + panel.b);
        halves.push_back({panel.a, middle, 0});
        halves.push_back({middle, panel.b, 0});
      }
      sum(halves);
      std::vector<Panel> next;
      for (std::size_t k = 0; k < panels.size(); ++k) {
        const Panel &left = halves[2 * k], &right = halves[2 * k + 1];
        const double both = left.sum + right.sum, difference = std::fabs(both - panels[k].sum);
        if (difference <= std::max(tolerance_, 1e-13 * std::fabs(both)) || round + 1 == most_rounds ||
            panels.size() > most_panels || spent_ > most_evaluations) {
          value += both;
          doubt += difference;
        } else {
          next.push_back(left);
          next.push_back(right);
        }
      }
      panels = std::move(next);
    }
  }

  double value = 0, doubt = 0;

private:
  static constexpr int most_rounds = 36;
  static constexpr std::size_t most_panels = 1000; ///< of one round: more of them halve the rounding of f
  static constexpr std::size_t most_evaluations = 30'000'000;

  struct Panel {
    double a, b, sum;
  };

  void sum(std::vector<Panel>& panels) const {
    std::vector<double> at, f;
    at.reserve(panels.size() * node_count);
    for (const Panel& panel : panels)
      for (const double x : rule().x) at.push_back(panel.a + (panel.b - panel.a) * x);
    f.resize(at.size());
    f_(at, f);
    for (std::size_t p = 0; p < panels.size(); ++p) {
      double sum = 0;
      for (std::size_t k = 0; k < node_count; ++k) sum += rule().w[k] * f[p * node_count + k];
      panels[p].sum = sum * (panels[p].b - panels[p].a);
    }
  }

  const Function& f_;
  double tolerance_;
  const std::size_t& spent_;
};

/// The panels between `edges`, each in so many equal parts.
std::vector<double> divided(const std::vector<double>& edges, int parts) {
  std::vector<double> out;
  for (std::size_t k = 0; k + 1 < edges.size(); ++k)
    for (int part = 0; part < parts; ++part) out.push_back(edges[k] + (edges[k + 1] - edges[k]) * part / parts);
  out.push_back(edges.back());
  return out;
}

class Rays {
public:
  Rays(const SlopeMap& map, const std::function<bool(const Direction&)>& inside, const FacetFunction& f,
       double tolerance, int parts)
      : map_(map), root_(std::sqrt(1 - map.correlation * map.correlation)), inside_(inside), f_(f),
        tolerance_(tolerance), parts_(parts) {}

  /// The integral along the ray at psi, over r dr.
  double operator()(double psi) {
    cos_psi_ = std::cos(psi);
    sin_psi_ = std::sin(psi);
    const double end = end_of_ray();
    const Panels::Function along = [this](const auto& r, auto& out) { values(r, out); };
    Panels sum(along, tolerance_, evaluations);
    std::vector<double> edges = {0};
    // Near the viewer's horizon V-cavities begin to mask at slopes as small as cos theta.
    for (double r = 0x1p-24; r < 0x1p-4 && r < 0.5 * end; r *= 32) edges.push_back(r);
    for (double r = 0x1p-4; r < 0.5 * end; r *= r < 8 ? 2 : 8) edges.push_back(r);
    double gap = end - edges.back();
    for (int k = 0; k < 6 && gap > 0; ++k, gap *= 0.25) edges.push_back(end - 0.25 * gap);
    edges.push_back(end);
    sum.add(divided(edges, parts_));
    worst_doubt = std::max(worst_doubt, sum.doubt);
    return sum.value;
  }

  double worst_doubt = 0;
  std::size_t evaluations = 0;

private:
  Direction facet(double r) const {
    const double u = r * cos_psi_, v = r * sin_psi_;
    const double x = map_.mean_x + map_.alpha_x * u;
    const double y = map_.mean_y + map_.alpha_y * (map_.correlation * u + root_ * v);
    const double z = 1 / std::sqrt(1 + x * x + y * y);
    return {-x * z, -y * z, z};
  }

  double end_of_ray() const {
    double low = 0, high = 1;
    while (high < 1e30 && inside_(facet(high))) {
      low = high;
      high *= 2;
    }
    if (high >= 1e30) return high;
    for (int step = 0; step < 200 && high - low > 1e-16 * high; ++step) {
      const double middle = low > 0 && high > 4 * low ? std::sqrt(low * high) : 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (inside_(facet(middle)) ? low : high) = middle;
    }
    return low;
  }

  void values(const std::vector<double>& r, std::vector<double>& out) {
    facets_.clear();
    for (const double at : r) facets_.push_back(facet(at));
    values_.resize(r.size());
    f_(facets_, values_);
    evaluations += r.size();
    const double area = map_.alpha_x * map_.alpha_y * root_;
    for (std::size_t k = 0; k < r.size(); ++k) {
      const double z = facets_[k].z;
      out[k] = values_[k] == 0 ? 0 : values_[k] * (z * z * z) * area * r[k];
    }
  }

  const SlopeMap& map_;
  double root_;
  const std::function<bool(const Direction&)>& inside_;
  const FacetFunction& f_;
  double tolerance_;
  int parts_;
  double cos_psi_ = 1, sin_psi_ = 0;
  std::vector<Direction> facets_;
  std::vector<double> values_;
};

constexpr double widest = 0.35; ///< panel over psi

/// Edges over a turn that crowd at `places`.
std::vector<double> crowded(std::vector<double> places, int divisions) {
  for (double& place : places) place = std::remainder(place, 2 * pi);
  std::ranges::sort(places);
  std::vector<double> kept;
  for (const double place : places)
    if (kept.empty() || place - kept.back() > 1e-9) kept.push_back(place);
  kept.push_back(kept.front() + 2 * pi);
  std::vector<double> edges;
  for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
    const double a = kept[k], b = kept[k + 1];
    edges.push_back(a);
    for (double step = 3e-3; step < 0.4 * (b - a); step *= 6) {
      edges.push_back(a + step);
      edges.push_back(b - step);
    }
    const int parts = static_cast<int>(divisions * (b - a) / widest) + 2;
    for (int part = 1; part < parts; ++part) edges.push_back(a + (b - a) * part / parts);
  }
  edges.push_back(kept.back());
  std::ranges::sort(edges);
  return edges;
}

} // namespace

RayIntegral integrate_rays(const SlopeMap& map, const Direction& omega_o,
                           const std::function<bool(const Direction& facet)>& inside, const FacetFunction& f,
                           double tolerance, int parts) {
  Rays rays(map, inside, f, 3e-3 * tolerance, parts);
  const Panels::Function turn = [&](const auto& psi, auto& out) {
    for (std::size_t k = 0; k < psi.size(); ++k) out[k] = rays(psi[k]);
  };
  const double plane = std::atan2(omega_o.y, omega_o.x);
  const double root = std::sqrt(1 - map.correlation * map.correlation);
  // The azimuth of omega_o as the facets have it before and after L.
  const double x = omega_o.x / map.alpha_x, y = (omega_o.y / map.alpha_y - map.correlation * x) / root;
  const double before = std::atan2(y, x);
  const double after =
      std::atan2(root * map.alpha_y * omega_o.y, map.alpha_x * omega_o.x + map.correlation * map.alpha_y * omega_o.y);
  std::vector<double> places = {0, 0.5 * pi, pi, -0.5 * pi};
  for (const double azimuth : {plane, before, after})
    for (const double turned : {0.0, 0.5 * pi, pi, -0.5 * pi}) places.push_back(azimuth + turned);
  const auto edges = crowded(places, parts);
  Panels sum(turn, 1e-2 * tolerance, rays.evaluations);
  sum.add(edges);
  return {sum.value, sum.doubt + 2 * pi * rays.worst_doubt, rays.evaluations};
}

} // namespace test
