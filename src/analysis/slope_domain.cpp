#include "analysis/slope_domain.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <numbers>
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
  symmetric_ = map.alpha_x == map.alpha_y && map.correlation == 0 && map.centred();
}

Direction SlopeFrame::normal(double u1, double u2) const {
  const double x = mean_[0] + m_[0] * u1 + m_[1] * u2;
  const double y = mean_[1] + m_[2] * u1 + m_[3] * u2;
  const double z = 1 / std::hypot(1.0, x, y);
  return {-x * z, -y * z, z};
}

double SlopeFrame::reach(double cos_psi, double sin_psi, bool lit_only) const {
  const double horizon = cos_psi > 0 ? a() / cos_psi : infinity;
  if (!lit_only) return horizon;
  const double b = b_[0] * cos_psi + b_[1] * sin_psi;
  const double x = m_[0] * cos_psi + m_[1] * sin_psi;
  const double y = m_[2] * cos_psi + m_[3] * sin_psi;
  const double k2 = -2 * s() * cos_psi * b - c() * (x * x + y * y);
  return std::min(horizon, first_root(k2, -2 * s() * big_b_ * cos_psi, c() * big_b_));
}

namespace {

/// The integral along one ray, over v = atan r.
class Ray {
public:
  Ray(const SlopeFrame& frame, const NormalIntegrand& f, bool lit_only) : frame_(frame), f_(f), lit_only_(lit_only) {}

  Estimate operator()(double psi, double tolerance) {
    const double cos_psi = std::cos(psi);
    const double sin_psi = std::sin(psi);
    const double end = std::atan(frame_.reach(cos_psi, sin_psi, lit_only_));
    // The V-cavity's other normal starts to face the viewer at u_1 = -a.
    const double kink = cos_psi < 0 ? std::atan(-frame_.a() / cos_psi) : end;
    const std::array<double, 3> cuts = {0, std::min(kink, end), end};
    const auto integrand = [&](const double* v, double* y, std::size_t n) {
      normals_.resize(n);
      values_.resize(n);
      for (std::size_t k = 0; k < n; ++k) {
        const double r = std::tan(v[k]);
        normals_[k] = frame_.normal(r * cos_psi, r * sin_psi);
      }
      f_(normals_, values_);
      for (std::size_t k = 0; k < n; ++k) {
        const double cos_v = std::cos(v[k]);
        const double area = std::sin(v[k]) / (cos_v * cos_v * cos_v); // r dr / dv
        y[k] = values_[k] == 0 ? 0 : values_[k] * frame_.jacobian(normals_[k]) * area;
      }
    };
    return integrate(integrand, cuts, {.absolute = tolerance, .relative = 1e-13});
  }

private:
  const SlopeFrame& frame_;
  const NormalIntegrand& f_;
  bool lit_only_;
  std::vector<Direction> normals_;
  std::vector<double> values_;
};

} // namespace

Estimate integrate_normals(const SlopeFrame& frame, const NormalIntegrand& f, bool lit_only, double tolerance) {
  using std::numbers::pi;
  Ray ray(frame, f, lit_only);
  std::size_t evaluations = 0;
  double worst_ray = 0;
  const auto outer = [&](const double* psi, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      const Estimate estimate = ray(psi[k], 0.05 * tolerance);
      y[k] = estimate.value;
      worst_ray = std::max(worst_ray, estimate.error);
      evaluations += estimate.evaluations;
    }
  };
  const std::array<double, 5> whole = {-pi, -pi / 2, 0, pi / 2, pi};
  const auto cuts = std::span(whole).subspan(frame.symmetric() ? 2 : 0);
  const double copies = frame.symmetric() ? 2 : 1;
  Estimate estimate = integrate(outer, cuts, {.absolute = 0.5 * tolerance / copies}, 4000);
  estimate.value *= copies;
  estimate.error = copies * estimate.error + 2 * pi * worst_ray;
  estimate.evaluations = evaluations;
  return estimate;
}

} // namespace brdfplot
