#include "analysis/fit/minimax/maximin.hpp"

#include "base/threads/interrupt.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdfplot {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The largest step in (0, 1] that keeps x + step dx positive.
double step_to_boundary(const VectorXd& x, const VectorXd& dx) {
  double step = 1;
  for (Index i = 0; i < x.size(); ++i)
    if (dx(i) < 0) step = std::min(step, -x(i) / dx(i));
  return step;
}

/// Maximize delta where s = G (v, delta) - h >= 0: the rows A v - delta, 1 + v and 1 - v, in this order. z are their
/// multipliers, G^T z = (0, -1).
class InteriorPoint {
public:
  explicit InteriorPoint(const Rows& rows)
      : m_(static_cast<Index>(rows.count())), n_(static_cast<Index>(rows.columns)), a_(rows.values.data(), m_, n_),
        x_(VectorXd::Zero(n_ + 1)), s_(VectorXd::Ones(m_ + 2 * n_)),
        z_(VectorXd::Constant(m_ + 2 * n_, 1 / static_cast<double>(m_))) {
    x_(n_) = -1;
  }

  Maximin solve() {
    Maximin result;
    for (int iteration = 0; iteration < 60; ++iteration) {
      throw_if_interrupted();
      advance();
      result.value = (a_ * x_.head(n_)).minCoeff();
      // By duality no v reaches more than |A^T w|_1, whatever the w >= 0 of sum 1.
      result.bound = (a_.transpose() * z_.head(m_)).cwiseAbs().sum() / z_.head(m_).sum();
      if (result.bound < 1e-11 || result.value > 0.9 * result.bound || !(mean_product() > 1e-18)) break;
    }
    result.v.assign(x_.data(), x_.data() + n_);
    return result;
  }

private:
  double mean_product() const { return s_.dot(z_) / static_cast<double>(s_.size()); }

  /// G x.
  VectorXd apply(const VectorXd& x) const {
    VectorXd out(m_ + 2 * n_);
    out.head(m_) = (a_ * x.head(n_)).array() - x(n_);
    out.segment(m_, n_) = x.head(n_);
    out.tail(n_) = -x.head(n_);
    return out;
  }

  /// G^T z.
  VectorXd apply_transposed(const VectorXd& z) const {
    VectorXd out(n_ + 1);
    out.head(n_) = a_.transpose() * z.head(m_) + z.segment(m_, n_) - z.tail(n_);
    out(n_) = -z.head(m_).sum();
    return out;
  }

  /// G^T diag(d) G.
  Eigen::MatrixXd normal_matrix(const VectorXd& d) const {
    const RowMajor weighted = d.head(m_).cwiseSqrt().asDiagonal() * a_;
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n_ + 1, n_ + 1);
    out.topLeftCorner(n_, n_).selfadjointView<Eigen::Lower>().rankUpdate(weighted.transpose());
    out.diagonal().head(n_) += d.segment(m_, n_) + d.tail(n_);
    out.row(n_).head(n_) = -(a_.transpose() * d.head(m_)).transpose();
    out(n_, n_) = d.head(m_).sum();
    return out;
  }

  /// A predictor step, which tells how far the products s z can fall, and a corrected one.
  void advance() {
    VectorXd gradient = apply_transposed(z_);
    gradient(n_) += 1;
    const VectorXd d = z_.cwiseQuotient(s_);
    const Eigen::LDLT<Eigen::MatrixXd, Eigen::Lower> factors(normal_matrix(d));
    const auto newton = [&](const VectorXd& products) {
      const VectorXd dx = factors.solve(gradient + apply_transposed(products.cwiseQuotient(s_)));
      const VectorXd ds = apply(dx);
      return std::array<VectorXd, 3>{dx, ds, products.cwiseQuotient(s_) - d.cwiseProduct(ds)};
    };
    const double mean = mean_product();
    const VectorXd products = -s_.cwiseProduct(z_);
    const auto [dx, ds, dz] = newton(products);
    const double primal = step_to_boundary(s_, ds);
    const double dual = step_to_boundary(z_, dz);
    const double left = (s_ + primal * ds).dot(z_ + dual * dz) / static_cast<double>(s_.size()) / mean;
    const double target = left * left * left * mean;
    const auto [cx, cs, cz] = newton((products - ds.cwiseProduct(dz)).array() + target);
    const double primal_step = std::min(1.0, 0.95 * step_to_boundary(s_, cs));
    x_ += primal_step * cx;
    s_ += primal_step * cs;
    z_ += std::min(1.0, 0.95 * step_to_boundary(z_, cz)) * cz;
  }

  Index m_;
  Index n_;
  Eigen::Map<const RowMajor> a_;
  VectorXd x_; ///< v and delta
  VectorXd s_;
  VectorXd z_;
};

} // namespace

Maximin maximin(const Rows& a) { return InteriorPoint(a).solve(); }

} // namespace brdfplot
