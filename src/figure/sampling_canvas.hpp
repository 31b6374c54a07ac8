/// \file
/// Where samples of a curve are drawn, and how far a polyline through them is off.
#pragma once

#include "figure/sampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace brdfplot::plot {

struct Sample {
  double t; ///< x on the axis's scale
  double y;
  bool is_kink = false;
};

/// Where a sample is drawn, in units of the plot's size.
class Canvas {
public:
  Canvas(const CurveRequest& request, const std::vector<Sample>& samples) : request_(request) {
    low_ = request.y.from;
    high_ = request.y.to;
    double data_low = infinity, data_high = -infinity;
    for (const Sample& sample : samples) {
      const double v = scaled(sample.y);
      if (!std::isfinite(v)) continue;
      data_low = std::min(data_low, v);
      data_high = std::max(data_high, v);
    }
    low_ = std::isnan(low_) ? data_low : scaled(low_);
    high_ = std::isnan(high_) ? data_high : scaled(high_);
    // Below that it is a constant with rounding or an integral's tolerance on it, which nobody wants drawn larger.
    const double least = 1e-5 * std::max(std::fabs(low_), std::fabs(high_));
    if (!(high_ - low_ > least)) high_ = low_ + (least > 0 ? least : 1);
    t_low_ = samples.front().t;
    t_span_ = samples.back().t - t_low_;
  }

  std::array<double, 2> at(const Sample& sample) const {
    if (request_.polar) {
      const double r = sample.y / high_;
      return {r * std::sin(sample.t), r * std::cos(sample.t)};
    }
    // What is far outside the axis is not seen: it is pulled to its border, so that nobody refines it.
    const double v = std::clamp((scaled(sample.y) - low_) / (high_ - low_), -0.05, 1.05);
    return {(sample.t - t_low_) / t_span_, v};
  }

  /// How far the sample in the middle lies off the chord of the two others, beyond what is noise. Infinity where one
  /// of them cannot be drawn.
  double error(const Sample& a, const Sample& middle, const Sample& b) const {
    const auto p = at(a), q = at(b), m = at(middle);
    const double off =
        request_.polar ? distance(m, p, q) : std::fabs(m[1] - p[1] - (q[1] - p[1]) * (m[0] - p[0]) / (q[0] - p[0]));
    if (std::isnan(off)) return infinity;
    return std::max(0.0, off - 2 * noise(middle));
  }

  double noise(const Sample& sample) const {
    if (request_.noise == 0) return 0;
    if (request_.polar) return request_.noise / high_;
    return request_.noise / (high_ - low_) / (request_.y.scale == Scale::logarithmic ? std::fabs(sample.y) : 1);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Distance of p from the segment ab.
  static double distance(const std::array<double, 2>& p, const std::array<double, 2>& a,
                         const std::array<double, 2>& b) {
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double length2 = dx * dx + dy * dy;
    const double along = length2 > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2, 0.0, 1.0) : 0;
    return std::hypot(p[0] - a[0] - along * dx, p[1] - a[1] - along * dy);
  }
  double scaled(double y) const {
    return request_.y.scale == Scale::logarithmic ? (y > 0 ? std::log(y) : -infinity) : y;
  }
  const CurveRequest& request_;
  double low_, high_, t_low_, t_span_;
};

} // namespace brdfplot::plot
