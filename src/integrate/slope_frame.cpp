#include "integrate/slope_frame.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
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

/// The part of [from, to] in which k2 x^2 + k1 x + k0 > 0, of which there is one at most.
SlopeFrame::Reach first_part(double k2, double k1, double k0, const SlopeFrame::Reach& of) {
  const double discriminant = k1 * k1 - 4 * k2 * k0;
  std::vector<double> cuts = {of.from};
  if (discriminant > 0) {
    const double q = -0.5 * (k1 + std::copysign(std::sqrt(discriminant), k1));
    for (const double root : {q / k2, k0 / q})
      if (root > of.from && root < of.to) cuts.push_back(root);
  }
  std::ranges::sort(cuts);
  cuts.push_back(of.to);
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double middle = cuts[k + 1] < infinity ? 0.5 * (cuts[k] + cuts[k + 1]) : 2 * cuts[k] + 1;
    if ((k2 * middle + k1) * middle + k0 > 0) return {cuts[k], cuts[k + 1]};
  }
  return {0, 0};
}

} // namespace

SlopeFrame::SlopeFrame(const SlopeMap& map, const Direction& omega_o, const Vec2& mesosurface,
                       std::vector<double> radii)
    : projection_(map.project(omega_o)), determinant_(map.determinant()), mean_{map.mean_x, map.mean_y},
      c_mesosurface_(omega_o.z - omega_o.x * mesosurface[0] - omega_o.y * mesosurface[1]), radii_(std::move(radii)) {
  // Q^-1 is factored by hand where its Cholesky factor is known exactly: (1 - r^2) must not cancel.
  Eigen::Matrix2d factor;
  factor << map.alpha_x, 0, map.correlation * map.alpha_y, map.decorrelation() * map.alpha_y;
  Eigen::Vector2d along = factor.transpose() * Eigen::Vector2d(omega_o.x, omega_o.y);
  // Exactly larger where squares would lose their digits or underflow: a viewer all but at the normal.
  if (along.cwiseAbs().maxCoeff() < 0x1p-400) along *= 0x1p600;
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
  const Eigen::Vector2d of_all(mesosurface[0], mesosurface[1]);
  const Eigen::Vector2d b_of_all = m.transpose() * of_all;
  b_mesosurface_ = {b_of_all.x(), b_of_all.y()};
  big_b_ = 1 + mean.squaredNorm();
  big_b_mesosurface_ = 1 + mean.dot(of_all);
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

void SlopeFrame::normals(const double* u1, const double* u2, Direction* m, std::size_t n) const {
  // As normal(), several at a time: arrays that nothing else writes, and no branch.
  constexpr std::size_t capacity = 64;
  std::array<double, capacity> x, y, z;
  const auto [mean_x, mean_y] = mean_;
  const auto [xx, xy, yx, yy] = m_;
  for (std::size_t first = 0; first < n; first += capacity) {
    const std::size_t count = std::min(capacity, n - first);
    for (std::size_t k = 0; k < count; ++k) {
      const double slope_x = mean_x + xx * u1[first + k] + xy * u2[first + k];
      const double slope_y = mean_y + yx * u1[first + k] + yy * u2[first + k];
      const double n2 = 1 + slope_x * slope_x + slope_y * slope_y;
      z[k] = 1 / std::sqrt(n2);
      x[k] = -slope_x * z[k];
      y[k] = -slope_y * z[k];
    }
    for (std::size_t k = 0; k < count; ++k)
      m[first + k] = z[k] > 0 ? Direction{x[k], y[k], z[k]} : normal(u1[first + k], u2[first + k]);
  }
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

SlopeFrame::Reach SlopeFrame::facing(double cos_psi, double) const {
  if (c() > 0) return {0, cos_psi > 0 ? a() / cos_psi : infinity};
  if (cos_psi < 0) return {a() / cos_psi, infinity};
  return {0, 0};
}

SlopeFrame::Reach SlopeFrame::lit(double cos_psi, double sin_psi) const {
  const double b = b_[0] * cos_psi + b_[1] * sin_psi;
  const double b_all = b_mesosurface_[0] * cos_psi + b_mesosurface_[1] * sin_psi;
  const double x = m_[0] * cos_psi + m_[1] * sin_psi;
  const double y = m_[2] * cos_psi + m_[3] * sin_psi;
  const double k2 = -2 * s() * cos_psi * b_all - c_mesosurface_ * (x * x + y * y);
  const double k1 = 2 * (c() * b_all - c_mesosurface_ * b) - 2 * s() * big_b_mesosurface_ * cos_psi;
  const double k0 = 2 * c() * big_b_mesosurface_ - c_mesosurface_ * big_b_;
  const Reach seen = facing(cos_psi, sin_psi);
  if (c() > 0 && k0 > 0) return {0, std::min(seen.to, first_root(k2, k1, k0))};
  if (!(seen.from < seen.to)) return {0, 0};
  return first_part(k2, k1, k0, seen);
}

} // namespace brdfplot
