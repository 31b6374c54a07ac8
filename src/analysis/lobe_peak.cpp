#include "analysis/lobe_peak.hpp"

#include "brdf/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace brdfplot {

Direction azimuth(const Direction& o) {
  const double h = std::hypot(o.x, o.y);
  return h > 0 ? Direction{o.x / h, o.y / h, 0} : Direction{1, 0, 0};
}

namespace {

/// rho or rho cos theta_i over theta_i in the plane of incidence.
class Lobe {
public:
  Lobe(const Material& material, Quantity quantity, const Direction& o, int channel)
      : material_(material), quantity_(quantity), o_(o), along_(azimuth(o)),
        channel_(static_cast<std::size_t>(channel)) {}

  double operator()(double theta) { return (*this)(std::vector<double>{theta}).front(); }

  std::vector<double> operator()(const std::vector<double>& theta) {
    const std::size_t n = theta.size();
    evaluations += n;
    std::vector<double> x, y, z;
    for (const double one : theta) {
      x.push_back(std::sin(one) * along_.x);
      y.push_back(std::sin(one) * along_.y);
      z.push_back(std::cos(one));
    }
    const std::vector<double> o_x(n, o_.x), o_y(n, o_.y), o_z(n, o_.z);
    std::vector<double> all(static_cast<std::size_t>(material_.channels()) * n);
    evaluate(material_, quantity_, {n, {o_x.data(), o_y.data(), o_z.data()}, {x.data(), y.data(), z.data()}, {}},
             all.data());
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(channel_ * n);
    return {first, first + static_cast<std::ptrdiff_t>(n)};
  }

  /// Derivative by five points h apart; its error is of order h^4.
  double slope(double theta, double h) {
    const std::vector<double> y = (*this)({theta + h, theta - h, theta + 2 * h, theta - 2 * h});
    return (8 * (y[0] - y[1]) - (y[2] - y[3])) / (12 * h);
  }

  std::size_t evaluations = 0;

private:
  const Material& material_;
  Quantity quantity_;
  Direction o_, along_;
  std::size_t channel_;
};

/// Narrows [low, high] around the largest value by golden section.
double golden_section(Lobe& lobe, double low, double high) {
  constexpr double golden = 0.6180339887498949;
  while (high - low > 1e-9) {
    const double p = high - golden * (high - low);
    const double q = low + golden * (high - low);
    const std::vector<double> height = lobe({p, q});
    const bool beyond = height[0] < height[1];
    (beyond ? low : high) = beyond ? p : q;
  }
  return 0.5 * (low + high);
}

/// Where the derivative changes sign near `theta`, or `theta` when it does not.
double stationary_point(Lobe& lobe, double theta, double h) {
  double low = theta - h, high = theta + h;
  if (!(lobe.slope(low, h) > 0 && lobe.slope(high, h) < 0)) return theta;
  while (high - low > 1e-13) {
    const double middle = 0.5 * (low + high);
    (lobe.slope(middle, h) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace

Estimate peak_theta_i(const Material& material, Quantity quantity, const Direction& o, double width, int channel) {
  Lobe lobe(material, quantity, o, channel);
  const double mirror = -std::atan2(std::hypot(o.x, o.y), o.z);
  std::vector<double> scan;
  constexpr double quarter = 0.5 * std::numbers::pi;
  for (int k = -200; k <= 200; ++k) {
    scan.push_back(quarter * k / 200);
    const double near = mirror + std::copysign(std::pow(std::abs(k) / 200.0, 4), k);
    if (std::fabs(near) < quarter) scan.push_back(near);
  }
  std::ranges::sort(scan);
  const std::vector<double> height = lobe(scan);
  const auto best = scan.begin() + (std::ranges::max_element(height) - height.begin());
  const double rough =
      golden_section(lobe, best == scan.begin() ? *best : *(best - 1), best + 1 == scan.end() ? *best : *(best + 1));
  const double h = 2e-3 * std::min(1.0, width);
  const double smooth = stationary_point(lobe, rough, h);
  const bool kink = lobe(smooth) < lobe(rough) * (1 - 1e-14);
  return {kink ? rough : smooth, 1e-8, lobe.evaluations};
}

} // namespace brdfplot
