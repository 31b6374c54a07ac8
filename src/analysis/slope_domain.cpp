#include "analysis/slope_domain.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <numbers>
#include <vector>

namespace brdfplot {

namespace {

/// Real roots of k2 x^2 + k1 x + k0, ascending, without cancellation; empty when there is none.
std::vector<double> roots(double k2, double k1, double k0) {
  if (k2 == 0) return k1 == 0 ? std::vector<double>{} : std::vector<double>{-k0 / k1};
  const double discriminant = k1 * k1 - 4 * k2 * k0;
  if (discriminant < 0) return {};
  const double q = -0.5 * (k1 + std::copysign(std::sqrt(discriminant), k1));
  if (q == 0) return {0, 0};
  std::vector<double> both = {q / k2, k0 / q};
  std::ranges::sort(both);
  return both;
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
  norm1_ = m.col(0).squaredNorm();
  norm2_ = m.col(1).squaredNorm();
  dot12_ = m.col(0).dot(m.col(1));
}

Direction SlopeFrame::normal(double u1, double u2) const {
  const double x = mean_[0] + m_[0] * u1 + m_[1] * u2;
  const double y = mean_[1] + m_[2] * u1 + m_[3] * u2;
  const double z = 1 / std::hypot(1.0, x, y);
  return {-x * z, -y * z, z};
}

SlopeFrame::Range SlopeFrame::lit(double u1) const {
  const double k2 = -c() * norm2_;
  const double k1 = -2 * u1 * (s() * b_[1] + c() * dot12_);
  const double k0 = c() * big_b_ - 2 * s() * u1 * (big_b_ + b_[0] * u1) - c() * norm1_ * u1 * u1;
  const auto both = roots(k2, k1, k0);
  return both.size() == 2 ? Range{both[0], both[1]} : Range{0, 0};
}

SlopeFrame::Range SlopeFrame::lit() const {
  // The discriminant of the quadratic in u_2, itself a quadratic in u_1, is positive at u_1 = 0 always.
  const double half_k1 = -(s() * b_[1] + c() * dot12_);
  const double k2 = half_k1 * half_k1 - c() * norm2_ * (2 * s() * b_[0] + c() * norm1_);
  const double k1 = -2 * c() * norm2_ * s() * big_b_;
  const double k0 = c() * norm2_ * c() * big_b_;
  Range range{-infinity, infinity};
  for (const double root : roots(k2, k1, k0)) {
    if (root < 0) range.low = std::max(range.low, root);
    if (root > 0) range.high = std::min(range.high, root);
  }
  range.high = std::min(range.high, a());
  return range;
}

Estimate integrate_normals(const SlopeFrame& frame, const NormalIntegrand& f, bool lit_only, double tolerance) {
  const auto range = lit_only ? frame.lit() : SlopeFrame::Range{-infinity, frame.a()};
  std::size_t evaluations = 0;
  double inner_error = 0;
  std::vector<Direction> normals;
  std::vector<double> values;
  // u_1 = tan v, u_2 = sqrt(1 + u_1^2) tan w: the whole plane is a square, and tails that fall like a power (GGX) are
  // smooth up to its border.
  const auto inner = [&](double v) {
    const double u1 = std::tan(v);
    const double scale = std::hypot(1.0, u1);
    const auto limits = lit_only ? frame.lit(u1) : SlopeFrame::Range{-infinity, infinity};
    const std::array<double, 3> cuts = {std::atan(limits.low / scale), 0, std::atan(limits.high / scale)};
    const std::array<double, 2> whole = {cuts[0], cuts[2]};
    const bool split = cuts[0] < 0 && 0 < cuts[2];
    const auto integrand = [&](const double* w, double* y, std::size_t n) {
      normals.resize(n);
      values.resize(n);
      for (std::size_t k = 0; k < n; ++k) normals[k] = frame.normal(u1, scale * std::tan(w[k]));
      f(normals, values);
      for (std::size_t k = 0; k < n; ++k) {
        const double cos_w = std::cos(w[k]);
        y[k] = values[k] == 0 ? 0 : values[k] * frame.jacobian(normals[k]) * scale / (cos_w * cos_w);
      }
    };
    const Tolerance goal{.absolute = 0.02 * tolerance / (scale * scale), .relative = 1e-13};
    const Estimate estimate = split ? integrate(integrand, cuts, goal) : integrate(integrand, whole, goal);
    evaluations += estimate.evaluations;
    inner_error = std::max(inner_error, estimate.error * scale * scale);
    return estimate.value * scale * scale; // d u_1 = (1 + u_1^2) d v
  };
  const double low = std::atan(range.low);
  const double high = std::atan(range.high);
  std::vector<double> cuts = {low};
  for (const double kink : {std::atan(-frame.a()), 0.0})
    if (low < kink && kink < high) cuts.push_back(kink);
  cuts.push_back(high);
  const auto outer = [&](const double* v, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) y[k] = inner(v[k]);
  };
  Estimate estimate = integrate(outer, cuts, {.absolute = 0.5 * tolerance}, 4000);
  estimate.error += (high - low) * inner_error;
  estimate.evaluations = evaluations;
  return estimate;
}

} // namespace brdfplot
