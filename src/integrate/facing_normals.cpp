#include "integrate/facing_normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

using std::numbers::pi;
using Integrand = std::function<void(const std::vector<Direction>&, std::vector<double>&)>;

/// A line level = v.u of the plane of slopes.
struct Line {
  Vec2 v;
  double level;
};

/// L of m~ = mean + L u, and the lines of the directions: their horizons, and where there are kinks.
class Frame {
public:
  Frame(const SlopeMap& map, const Vec2& mesosurface, std::span<const Direction> directions, const NormalKinks& kinks)
      : map_(map), radii_(kinks.radii), parts_(kinks.anywhere ? 8 : 1) {
    std::vector<double> cosines; // of the mesosurface
    for (const Direction& omega : directions) {
      const double c = map.project(omega).c;
      horizons_.push_back({map.on_unit_surface(omega), c});
      cosines.push_back(omega.z - omega.x * mesosurface[0] - omega.y * mesosurface[1]);
      if (kinks.lines) kinks_.push_back({horizons_.back().v, c - 2 * cosines.back()});
    }
    if (!kinks.lines || directions.size() != 2) return;
    const Line &o = horizons_[0], &i = horizons_[1];
    kinks_.push_back({{cosines[0] * i.v[0] - cosines[1] * o.v[0], cosines[0] * i.v[1] - cosines[1] * o.v[1]},
                      cosines[0] * i.level - cosines[1] * o.level});
  }

  /// The normals of r (cos psi, sin psi), r up to the largest number.
  void normals(double cos_psi, double sin_psi, const std::vector<double>& r, std::vector<Direction>& m) const {
    constexpr std::size_t capacity = 64;
    std::array<double, capacity> x, y, z;
    m.resize(r.size());
    for (std::size_t first = 0; first < r.size(); first += capacity) {
      const std::size_t n = std::min(capacity, r.size() - first);
      for (std::size_t k = 0; k < n; ++k) {
        const Vec2 slope = map_.slope(r[first + k] * cos_psi, r[first + k] * sin_psi);
        x[k] = slope[0];
        y[k] = slope[1];
      }
      // Without a branch, so that the compiler takes several at a time; squares do not overflow.
      for (std::size_t k = 0; k < n; ++k) {
        const double largest = std::max(1.0, std::max(std::fabs(x[k]), std::fabs(y[k])));
        const double a = 1 / largest, b = x[k] / largest, c = y[k] / largest;
        z[k] = 1 / (largest * std::sqrt(a * a + b * b + c * c));
      }
      for (std::size_t k = 0; k < n; ++k) m[first + k] = {-x[k] * z[k], -y[k] * z[k], z[k]};
    }
  }

  /// d omega_m / d^2 u.
  double jacobian(const Direction& omega_m) const { return map_.determinant() * omega_m.z * omega_m.z * omega_m.z; }

  /// Where the ray of azimuth psi is cut: where the first facet turns away, kinks, and r = 0, or where the last one
  /// turns towards the directions, as w = acot r, ascending. None where no facet faces them.
  std::vector<double> cuts_of_ray(double cos_psi, double sin_psi) const {
    double begin = 0.5 * pi, end = 0;
    for (const Line& line : horizons_) {
      const double along = line.v[0] * cos_psi + line.v[1] * sin_psi;
      if (line.level > 0 && along > 0) end = std::max(end, std::atan(along / line.level));
      if (!(line.level > 0)) begin = std::min(begin, along < 0 ? std::atan2(-along, -line.level) : 0);
    }
    if (!(end < begin)) return {};
    std::vector<double> cuts = {end, begin};
    for (const Line& line : kinks_) {
      const double along = line.v[0] * cos_psi + line.v[1] * sin_psi;
      const double w = std::atan2(std::fabs(along), std::fabs(line.level));
      if (along * line.level > 0 && w > end && w < begin) cuts.push_back(w);
    }
    for (const double r : radii_) {
      const double w = std::atan2(1, r);
      if (w > end && w < begin) cuts.push_back(w);
    }
    for (int k = 1; k < parts_; ++k) cuts.push_back(end + (begin - end) * k / parts_);
    std::ranges::sort(cuts);
    return cuts;
  }

  /// Where psi is cut, ascending over one turn.
  std::vector<double> cuts_of_turn() const {
    std::vector<Line> lines = horizons_;
    lines.insert(lines.end(), kinks_.begin(), kinks_.end());
    std::vector<double> cuts = {-pi, 0};
    const auto cut_across = [&](double x, double y) {
      if (x == 0 && y == 0) return;
      const double psi = std::atan2(y, x);
      for (const double turned : {psi + 0.5 * pi, psi - 0.5 * pi}) cuts.push_back(std::remainder(turned, 2 * pi));
    };
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const Line& one = lines[k];
      cut_across(one.v[0], one.v[1]);
      for (const double r : {0.25, 1.0, 4.0}) cut_at_distance(one, r, cuts);
      for (const double r : radii_) cut_where_crossed(one, r, cuts);
      for (std::size_t other = 0; other < k; ++other) {
        const Line& two = lines[other];
        cut_across(one.v[0] * two.level - two.v[0] * one.level, one.v[1] * two.level - two.v[1] * one.level);
      }
    }
    std::ranges::sort(cuts);
    cuts.push_back(pi);
    // Cuts of one place differ by rounding.
    const auto same = [](double left, double right) { return right - left < 1e-12; };
    cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
    cuts.back() = pi;
    return cuts;
  }

private:
  /// Where a line enters and leaves the circle of radius r.
  static void cut_where_crossed(const Line& line, double r, std::vector<double>& cuts) {
    const double norm = std::hypot(line.v[0], line.v[1]), level = std::fabs(line.level);
    if (!(level < norm * r)) return;
    const double side = line.level < 0 ? -1 : 1;
    const double psi = std::atan2(side * line.v[1], side * line.v[0]), turn = std::acos(level / (norm * r));
    for (const double turned : {-turn, turn}) cuts.push_back(std::remainder(psi + turned, 2 * pi));
  }

  /// A line close to the centre, as a horizon at grazing, sweeps over the mass within a small angle, which no rule sees
  /// unless it is cut where the line is at a distance r.
  static void cut_at_distance(const Line& line, double r, std::vector<double>& cuts) {
    if (std::hypot(line.v[0], line.v[1]) >= 8 * std::fabs(line.level)) cut_where_crossed(line, r, cuts);
  }

  const SlopeMap& map_;
  const std::vector<double>& radii_;
  int parts_; ///< of a ray, at least: where it just crosses a kink twice no node may lie between
  std::vector<Line> horizons_, kinks_;
};

/// The integral along one ray, over w = acot r: infinity is at 0, where numbers are dense.
class Ray {
public:
  Ray(const Frame& frame, const Integrand& f, Jumps jumps) : frame_(frame), f_(f), jumps_(jumps) {}

  Estimate operator()(double psi, const Tolerance& tolerance) {
    const double cos_psi = std::cos(psi);
    const double sin_psi = std::sin(psi);
    const auto over_w = [&](const double* w, double* y, std::size_t n) {
      slopes_.resize(n);
      for (std::size_t k = 0; k < n; ++k) slopes_[k] = 1 / std::tan(w[k]);
      evaluate(cos_psi, sin_psi, y);
      for (std::size_t k = 0; k < n; ++k) {
        const double sin_w = std::sin(w[k]);
        if (y[k] != 0) y[k] /= sin_w * sin_w; // dr / dw
      }
    };
    const auto cuts = frame_.cuts_of_ray(cos_psi, sin_psi);
    if (cuts.empty()) return {};
    if (cuts.front() > 0) return integrate(over_w, cuts, tolerance, most_evaluations, jumps_);
    constexpr double largest_slope = 1e65; // before the cube of z_m ends
    const double tail = power_tail(
        [&](double r) {
          double value = 0;
          slopes_ = {r};
          evaluate(cos_psi, sin_psi, &value);
          return value;
        },
        largest_slope);
    if (std::isinf(tail)) return {tail, tail, 1};
    Estimate estimate = integrate(over_w, cuts, tolerance, most_evaluations, jumps_);
    estimate.error += tail;
    return estimate;
  }

private:
  static constexpr std::size_t most_evaluations = 100000;

  /// The integrand over r at `slopes_`.
  void evaluate(double cos_psi, double sin_psi, double* y) {
    const std::size_t n = slopes_.size();
    values_.resize(n);
    frame_.normals(cos_psi, sin_psi, slopes_, normals_);
    f_(normals_, values_);
    for (std::size_t k = 0; k < n; ++k)
      y[k] = values_[k] == 0 ? 0 : values_[k] * frame_.jacobian(normals_[k]) * slopes_[k];
  }

  const Frame& frame_;
  const Integrand& f_;
  Jumps jumps_;
  std::vector<double> slopes_;
  std::vector<Direction> normals_;
  std::vector<double> values_;
};

} // namespace

Estimate integrate_over_facing(const SlopeMap& map, const Vec2& mesosurface, std::span<const Direction> directions,
                               const NormalKinks& kinks, const Integrand& f, const Tolerance& tolerance) {
  const Jumps jumps = kinks.anywhere ? Jumps::possible : Jumps::none;
  const Frame frame(map, mesosurface, directions, kinks);
  Ray ray(frame, f, jumps);
  std::size_t evaluations = 0;
  double worst_ray = 0;
  const Tolerance of_ray{0.05 * tolerance.absolute, std::max(1e-13, 0.05 * tolerance.relative)};
  const auto outer = [&](const double* psi, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      y[k] = 0;
      if (std::isinf(worst_ray)) continue; // one ray without an end is enough
      const Estimate estimate = ray(psi[k], of_ray);
      y[k] = estimate.value;
      worst_ray = std::max(worst_ray, estimate.error);
      evaluations += estimate.evaluations;
    }
  };
  const std::vector<double> cuts = frame.cuts_of_turn();
  const std::size_t most = std::max<std::size_t>(4000, 100 * cuts.size());
  Estimate estimate = integrate(outer, cuts, {0.5 * tolerance.absolute, 0.5 * tolerance.relative}, most, jumps);
  if (std::isinf(worst_ray)) return {worst_ray, worst_ray, evaluations};
  estimate.error += 2 * pi * worst_ray;
  estimate.evaluations = evaluations;
  return estimate;
}

} // namespace brdfplot
