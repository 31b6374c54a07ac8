#include "integrate/slope_domain.hpp"

#include "math/cubature.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace brdfplot {

namespace {

/// Smallest positive root of k2 x^2 + k1 x + k0 with k0 > 0, without cancellation; infinity when there is none.
double first_root(double k2, double k1, double k0) {
  const double discriminant = k1 * k1 - 4 * k2 * k0;
  if (discriminant < 0) return infinity;
  const double q = -0.5 * (k1 + std::copysign(std::sqrt(discriminant), k1));
  double best = infinity;
  if (q != 0 && k0 / q > 0) best = k0 / q;
  if (k2 != 0 && q / k2 > 0) best = std::min(best, q / k2);
  return best;
}

} // namespace

SlopeFrame::SlopeFrame(const SlopeMap& map, const Direction& omega_o)
    : projection_(map.project(omega_o)), determinant_(map.determinant()), mean_{map.mean_x, map.mean_y} {
  // Q^-1 is factored by hand where its Cholesky factor is known exactly: (1 - r^2) must not cancel.
  Eigen::Matrix2d factor;
  factor << map.alpha_x, 0, map.correlation * map.alpha_y, map.decorrelation() * map.alpha_y;
  Eigen::Vector2d along = factor.transpose() * Eigen::Vector2d(omega_o.x, omega_o.y);
  if (along.norm() > 0)
    along.normalize();
  else
    along = Eigen::Vector2d::UnitX();
  Eigen::Matrix2d turn;
  turn << along.x(), -along.y(), along.y(), along.x();
  const Eigen::Matrix2d m = factor * turn;
  const Eigen::Vector2d mean(map.mean_x, map.mean_y);
  const Eigen::Vector2d b = m.transpose() * mean;
  b_ = {b.x(), b.y()};
  m_ = {m(0, 0), m(0, 1), m(1, 0), m(1, 1)};
  big_b_ = 1 + mean.squaredNorm();
  plane_ = std::atan2(m(0, 0) * omega_o.y - m(1, 0) * omega_o.x, m(1, 1) * omega_o.x - m(0, 1) * omega_o.y);
  symmetric_ = map.alpha_x == map.alpha_y && map.correlation == 0 && map.centred();
}

Direction SlopeFrame::normal(double u1, double u2) const {
  const double x = mean_[0] + m_[0] * u1 + m_[1] * u2;
  const double y = mean_[1] + m_[2] * u1 + m_[3] * u2;
  // Slopes beyond 1e150 would overflow when squared; their normals are horizontal.
  const double n2 = 1 + x * x + y * y;
  const double z = n2 < infinity ? 1 / std::sqrt(n2) : 1 / std::hypot(1.0, x, y);
  return {-x * z, -y * z, z};
}

void SlopeFrame::normals_along(const double* u1, double* x, double* y, double* z, std::size_t n) const {
  // Without a branch and with nothing that might be written meanwhile, so that the compiler takes several at a time.
  const auto [mean_x, mean_y] = mean_;
  const double along_x = m_[0];
  const double along_y = m_[2];
  for (std::size_t k = 0; k < n; ++k) {
    const double slope_x = mean_x + along_x * u1[k];
    const double slope_y = mean_y + along_y * u1[k];
    const double n2 = 1 + slope_x * slope_x + slope_y * slope_y;
    z[k] = 1 / std::sqrt(n2);
    x[k] = -slope_x * z[k];
    y[k] = -slope_y * z[k];
  }
  for (std::size_t k = 0; k < n; ++k)
    if (z[k] == 0) { // a slope whose square overflows
      const Direction m = normal(u1[k], 0);
      x[k] = m.x;
      y[k] = m.y;
      z[k] = m.z;
    }
}

double SlopeFrame::reach(double cos_psi, double sin_psi) const {
  const double horizon = cos_psi > 0 ? a() / cos_psi : infinity;
  const double b = b_[0] * cos_psi + b_[1] * sin_psi;
  const double x = m_[0] * cos_psi + m_[1] * sin_psi;
  const double y = m_[2] * cos_psi + m_[3] * sin_psi;
  const double k2 = -2 * s() * cos_psi * b - c() * (x * x + y * y);
  return std::min(horizon, first_root(k2, -2 * s() * big_b_ * cos_psi, c() * big_b_));
}

namespace {

/// Points of a chart: slopes and d^2 u per unit of the chart.
struct ChartPoint {
  double u1, u2, area;
};

/// An integrand over normals as one over charts.
template <class Chart>
Estimate integrate_charts(const SlopeFrame& frame, const NormalIntegrand& f, const Chart& chart,
                          const std::vector<Rectangle>& rectangles, double tolerance) {
  std::vector<Direction> normals;
  std::vector<double> values, areas;
  const auto integrand = [&](std::size_t index, const double* x, const double* y, double* out, std::size_t n) {
    normals.resize(n);
    values.resize(n);
    areas.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const ChartPoint point = chart(index, x[k], y[k]);
      normals[k] = frame.normal(point.u1, point.u2);
      areas[k] = point.area;
    }
    f(normals, values);
    for (std::size_t k = 0; k < n; ++k)
      // The cube of z_m underflows from slopes of 1e100 on.
      out[k] = normals[k].z > 1e-95 && values[k] != 0 ? values[k] * frame.jacobian(normals[k]) * areas[k] : 0;
  };
  // Kinks may cut the plane into hundreds of rectangles; each must be left some to be divided with.
  const std::size_t most = std::max<std::size_t>(1000000, 2000 * rectangles.size());
  return integrate_plane(integrand, rectangles, {.absolute = tolerance, .relative = 1e-14}, most);
}

/// The charts of integrate_facing().
class FacingCharts {
public:
  FacingCharts(const SlopeFrame& frame, const FacingIntegrand& f)
      : a_(frame.a()), scale_(2 * std::hypot(1.0, a_)), kink_(f.kink), copies_(f.symmetric ? 2 : 1) {}

  std::vector<Rectangle> rectangles() const {
    std::vector<Rectangle> all;
    const double rim = a_ == infinity ? 0 : spread / (spread + a_ * a_ + a_ * std::hypot(std::sqrt(spread), a_));
    for (std::size_t mirrored = 0; mirrored < (copies_ == 2 ? 1U : 2U); ++mirrored) {
      const std::size_t base = mirrored * chart_count;
      all.push_back({rim, 1, 0, std::numbers::pi, base + inside});
      if (a_ == infinity) continue;
      all.push_back({0, 1, 0, 1, base + outside});
      if (kink_) all.push_back({0, 1, 0, 1, base + behind});
    }
    return all;
  }

  ChartPoint operator()(std::size_t chart, double x, double y) const {
    const double side = chart < chart_count ? 1 : -1;
    if (chart % chart_count == inside) {
      const double q = x * (2 - x);
      const double r = (1 - x) * std::sqrt(spread / q);
      return {r * std::cos(y), side * r * std::sin(y), copies_ * spread * (1 - x) / (q * q)};
    }
    const double t = scale_ * (1 - x) / x;
    const double horizon = std::atan(t / a_);
    double from = horizon;
    double to = std::numbers::pi;
    if (kink_) (chart % chart_count == outside ? to : from) = std::numbers::pi - horizon;
    const double psi = from + (to - from) * y;
    const double r = std::hypot(a_, t);
    return {r * std::cos(psi), side * r * std::sin(psi), copies_ * (to - from) * t * scale_ / (x * x)};
  }

private:
  enum : std::size_t { inside, outside, behind, chart_count };
  /// r = (1 - x) sqrt(spread / q), q = x (2 - x) = 1 - (1 - x)^2: smooth in r at the centre, and for distributions of
  /// unit roughness, Gaussian to long-tailed, nearly a polynomial. Infinity is at x = 0, where numbers are dense.
  static constexpr double spread = 6;
  double a_, scale_;
  bool kink_;
  double copies_;
};

/// The charts of integrate_lit(): one part of the rays of a sector. A sector is a range of angles in which all rays
/// cross the same switches in the same order and in like places; within one, the ends of the parts are smooth in psi.
class LitCharts {
public:
  LitCharts(const SlopeFrame& frame, const LitIntegrand& f) : frame_(frame), f_(f), copies_(f.symmetric ? 2 : 1) {}

  std::vector<Rectangle> rectangles() {
    using std::numbers::pi;
    std::vector<double> cuts = {0, pi / 2, pi};
    if (!f_.symmetric) {
      cuts.insert(cuts.end(), {-pi, -pi / 2});
      if (f_.kink_in_plane_of_incidence && frame_.centred()) {
        const double plane = frame_.plane_of_incidence();
        cuts.insert(cuts.end(), {plane, plane > 0 ? plane - pi : plane + pi});
      }
    }
    std::ranges::sort(cuts);
    std::vector<Rectangle> all;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) add_sectors(cuts[k], cuts[k + 1], all);
    return all;
  }

  ChartPoint operator()(std::size_t chart, double x, double psi) {
    const std::size_t part = chart % most_parts;
    const Ends& typical = sectors_[chart / most_parts];
    const Ends& ends = ends_in_sector(typical, psi);
    const End& begin = ends[part];
    const End& end = ends[part + 1];
    const bool last = part + 2 == ends.size();
    // Towards the horizon shadowing changes within an angle of the order of the roughness: points crowd there.
    const Place place = placed(x, is_root(begin), last || is_root(end));
    const double length = end.z - begin.z;
    const double z = begin.z + length * place.at;
    const double dz = length * place.slope;
    const double r = spread * z / (1 - z);
    return {r * std::cos(psi), r * std::sin(psi), copies_ * r * dz * spread / ((1 - z) * (1 - z))};
  }

private:
  /// r = spread z / (1 - z).
  static constexpr double spread = 2;
  static constexpr double shortest = 0x1p-14; ///< r below which all rays are alike: they see 1e-9 of the mass
  static constexpr double same_place = 1e-6;  ///< of a ray's end: sign changes closer than that have no order
  static constexpr std::size_t most_rays = 20000;
  static constexpr std::size_t most_parts = 1024; ///< of a ray; charts are numbered sector * most_parts + part

  /// Where two parts of a ray meet, or its end: in z, and which switch changes its sign there.
  struct End {
    double z;
    std::size_t crossed;
  };
  using Ends = std::vector<End>; ///< of the parts of a ray, ascending from 0

  bool is_root(const End& end) const { return end.crossed < f_.switches.size() && f_.switches[end.crossed].root; }

  /// A map of [0, 1] to itself and its derivative, which is 0 at the ends where points are to crowd: what is like a
  /// root there becomes smooth.
  struct Place {
    double at, slope;
  };
  static Place placed(double x, bool crowd_at_0, bool crowd_at_1) {
    if (crowd_at_0 && crowd_at_1) return {x * x * (3 - 2 * x), 6 * x * (1 - x)};
    if (crowd_at_0) return {x * x, 2 * x};
    if (crowd_at_1) return {1 - (1 - x) * (1 - x), 2 * (1 - x)};
    return {x, 1};
  }

  /// What makes a sector: which switches are crossed, and how far out, by steps. The latter because an end that
  /// moves through the bulk of the distribution or its tail does so within a few degrees, or a small part of one, on a
  /// smooth or an anisotropic surface or at grazing angles, and a rule whose nodes miss these sees nothing.
  std::vector<std::size_t> crossed(double psi) {
    std::vector<std::size_t> all;
    for (const End& end : ray(psi)) {
      all.push_back(end.crossed);
      const double r = spread * end.z / (1 - end.z);
      std::size_t distance = end.z == 1 ? 1 : 0; // endless rays begin with a kink
      for (double limit = shortest; limit <= 1024; limit *= limit < 4 ? 4 : 16)
        distance += static_cast<std::size_t>(r > limit);
      all.push_back(distance);
    }
    return all;
  }

  /// Cuts [from, to] into sectors, found by bisection between probes that differ.
  void add_sectors(double from, double to, std::vector<Rectangle>& all) {
    std::vector<double> probes = {from + 1e-10 * (to - from)}; // crossings may appear right at an edge
    constexpr int count = 48;
    for (int k = 0; k < count; ++k) probes.push_back(from + (to - from) * (k + 0.5) / count);
    probes.push_back(to - 1e-10 * (to - from));
    double begin = from;
    double low = probes.front();
    auto below = crossed(low);
    const auto add = [&](double end, double last) {
      const std::size_t parts = below.size() / 2 - 1;
      for (std::size_t part = 0; part < parts; ++part)
        all.push_back({0, 1, begin, end, sectors_.size() * most_parts + part});
      const Ends middle = ray(0.5 * (begin + end)), beside = ray(last);
      sectors_.push_back(is_like(middle, beside) ? middle : beside);
      begin = end;
    };
    for (const double probe : probes) {
      while (crossed(probe) != below) {
        double high = probe;
        while (high - low > 1e-13) {
          const double middle = 0.5 * (low + high);
          (crossed(middle) == below ? low : high) = middle;
        }
        add(high, low);
        low = high;
        below = crossed(high);
      }
      low = probe;
    }
    add(to, low);
  }

  static bool is_like(const Ends& one, const Ends& other) {
    return std::ranges::equal(one, other, {}, &End::crossed, &End::crossed);
  }

  /// The ends of a ray, as many as a sector has parts. Beside a sector's edge, which is known to rounding only, and
  /// where a narrow sector was overlooked, rays cross other switches: then those ends count that are the sector's, and
  /// what is missing is put where typical rays have it, so that each part is nearly the same from ray to ray. (Were
  /// parts counted from the centre, one would take from the next where a crossing comes in between; these are
  /// integrated by rules of their own, of which one might see it and the other not.)
  const Ends& ends_in_sector(const Ends& typical, double psi) {
    const Ends& own = ray(psi);
    if (is_like(own, typical)) return own;
    matched_ = {own.front()};
    const double scale = own.back().z / typical.back().z;
    for (std::size_t k = 1; k + 1 < typical.size(); ++k) {
      const double expected = std::clamp(scale * typical[k].z, matched_.back().z, own.back().z);
      End nearest{expected, typical[k].crossed};
      double distance = infinity;
      for (const End& end : own) {
        if (end.crossed != typical[k].crossed || end.z < matched_.back().z - same_place * own.back().z) continue;
        if (std::fabs(end.z - expected) < distance) nearest = end;
        distance = std::min(distance, std::fabs(end.z - expected));
      }
      matched_.push_back(nearest);
    }
    matched_.push_back(own.back());
    return matched_;
  }

  /// The ends of the parts of a ray. Remembered: the parts of a sector, and rectangles that are divided across the
  /// rays, ask for the same ones.
  const Ends& ray(double psi) {
    if (const auto known = rays_.find(psi); known != rays_.end()) return known->second;
    if (rays_.size() >= most_rays) rays_.clear();
    const double reach = frame_.reach(std::cos(psi), std::sin(psi));
    const double end = reach == infinity ? 1 : reach / (spread + reach);
    Ends ends = {{0, f_.switches.size()}, {end, f_.switches.size()}};
    for (std::size_t k = 0; k < f_.switches.size(); ++k) add_sign_changes(k, psi, end, ends);
    put_in_order(ends);
    return rays_.emplace(psi, std::move(ends)).first->second;
  }

  /// Ascending; those that are one place but for rounding, as the sign changes of two switches with the same zeros are,
  /// by their switch, so that rays are alike.
  static void put_in_order(Ends& ends) {
    std::ranges::sort(ends, {}, &End::z);
    const double close = same_place * ends.back().z;
    for (auto from = ends.begin() + 1; from + 1 < ends.end();) {
      auto to = from + 1;
      while (to + 1 < ends.end() && to->z - (to - 1)->z <= close) ++to;
      std::ranges::sort(from, to, {}, &End::crossed);
      from = to;
    }
  }

  void evaluate_switch(const NormalIntegrand& of, double psi, const std::vector<double>& z) {
    normals_.clear();
    for (const double at : z) {
      const double r = spread * at / (1 - at);
      normals_.push_back(frame_.normal(r * std::cos(psi), r * std::sin(psi)));
    }
    values_.resize(z.size());
    of(normals_, values_);
  }

  void add_sign_changes(std::size_t which, double psi, double end, Ends& ends) {
    const NormalIntegrand& of = f_.switches[which].value;
    constexpr int probes = 24;
    std::vector<double> z = {1e-9 * end, 1e-6 * end, 1e-4 * end}; // crossings may leave by the centre
    for (int k = 1; k < probes; ++k) z.push_back(end * (1 - std::cos(std::numbers::pi * k / probes)) / 2);
    z.push_back(end * (1 - 1e-5)); // and by the horizon
    evaluate_switch(of, psi, z);
    std::vector<double> values = values_;
    for (std::size_t k = z.size() - 2; k > 0; --k) {
      const std::array<double, 3> at = {z[k - 1], z[k], z[k + 1]};
      const std::array<double, 3> value = {values[k - 1], values[k], values[k + 1]};
      if (const auto beyond = dip(of, psi, at, value)) {
        const auto behind = static_cast<std::ptrdiff_t>(beyond->first > z[k] ? k + 1 : k);
        z.insert(z.begin() + behind, beyond->first);
        values.insert(values.begin() + behind, beyond->second);
      }
    }
    std::size_t last = 0; // the last one that is not zero
    for (std::size_t k = 1; k < z.size(); ++k) {
      if (values[k] == 0) continue;
      if (values[last] * values[k] < 0)
        ends.push_back({sign_change(of, psi, {z[last], z[k]}, {values[last], values[k]}), which});
      last = k;
    }
  }

  /// Two sign changes may hide between probes. Where the middle one of three values is nearest to zero, a point
  /// between them of the other sign, and its value, if parabolas lead to one.
  std::optional<std::pair<double, double>> dip(const NormalIntegrand& of, double psi, std::array<double, 3> z,
                                               std::array<double, 3> value) {
    const double side = value[1] > 0 ? 1 : -1;
    for (double& v : value) v *= side;
    if (!(value[1] > 0 && value[0] > value[1] && value[2] > value[1])) return {};
    for (int step = 0; step < 10; ++step) {
      const double left = (z[1] - z[0]) * (value[2] - value[1]), right = (z[2] - z[1]) * (value[0] - value[1]);
      const double vertex = z[1] + 0.5 * ((z[2] - z[1]) * right - (z[1] - z[0]) * left) / (left + right);
      if (!(vertex > z[0] && vertex < z[2]) || std::fabs(vertex - z[1]) < 1e-9 * z[1]) return {};
      evaluate_switch(of, psi, {vertex});
      const double here = side * values_[0];
      if (here < 0) return std::pair(vertex, side * here);
      const bool lower = here < value[1];
      const std::size_t replaced = (vertex < z[1]) == lower ? 2 : 0;
      z[replaced] = lower ? z[1] : vertex;
      value[replaced] = lower ? value[1] : here;
      if (lower) {
        z[1] = vertex;
        value[1] = here;
      }
    }
    return {};
  }

  /// Regula falsi, Illinois variant.
  double sign_change(const NormalIntegrand& of, double psi, std::array<double, 2> z, std::array<double, 2> value) {
    for (int step = 0; step < 60 && std::fabs(z[1] - z[0]) > 1e-15 * z[1]; ++step) {
      const double at = (z[0] * value[1] - z[1] * value[0]) / (value[1] - value[0]);
      if (!(at > std::min(z[0], z[1]) && at < std::max(z[0], z[1]))) break;
      evaluate_switch(of, psi, {at});
      if (values_[0] == 0) return at;
      if (values_[0] * value[1] < 0) {
        z[0] = z[1];
        value[0] = value[1];
      } else {
        value[0] *= 0.5;
      }
      z[1] = at;
      value[1] = values_[0];
    }
    return z[1];
  }

  const SlopeFrame& frame_;
  const LitIntegrand& f_;
  double copies_;
  std::unordered_map<double, Ends> rays_; ///< by psi
  std::vector<Ends> sectors_;             ///< the ends of a typical ray of each
  Ends matched_;
  std::vector<Direction> normals_;
  std::vector<double> values_;
};

} // namespace

Estimate integrate_facing(const SlopeFrame& frame, const FacingIntegrand& f, double tolerance) {
  const FacingCharts charts(frame, f);
  Estimate estimate = integrate_charts(frame, f.value, charts, charts.rectangles(), tolerance);
  // Slopes that fall slowly go on beyond those that integrate_charts() sees; away from the viewer most of all.
  const auto away = [&](double r) {
    const std::vector<Direction> normal = {frame.normal(-r, 0)};
    std::vector<double> value(1);
    f.value(normal, value);
    return value[0] * frame.jacobian(normal[0]) * r;
  };
  constexpr double largest_slope = 1e65;
  estimate.error += 2 * std::numbers::pi * power_tail(away, largest_slope);
  return estimate;
}

Estimate integrate_lit(const SlopeFrame& frame, const LitIntegrand& f, double tolerance) {
  LitCharts charts(frame, f);
  const auto rectangles = charts.rectangles();
  return integrate_charts(
      frame, f.value, [&](std::size_t chart, double x, double y) { return charts(chart, x, y); }, rectangles,
      tolerance);
}

} // namespace brdfplot
