#include "plot/sampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brdfplot::plot {

namespace {

struct Sample {
  double t; ///< x on the axis's scale
  double y;
};

/// Where a sample is drawn, in units of the plot's size.
class Canvas {
public:
  Canvas(const CurveRequest& request, const std::vector<Sample>& samples) : request_(request) {
    low_ = request.y.from;
    high_ = request.y.to;
    double data_low = infinity_, data_high = -infinity_;
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

private:
  static constexpr double infinity_ = std::numeric_limits<double>::infinity();
  double scaled(double y) const {
    return request_.y.scale == Scale::logarithmic ? (y > 0 ? std::log(y) : -infinity_) : y;
  }
  const CurveRequest& request_;
  double low_, high_, t_low_, t_span_;
};

/// Distance of p from the segment ab.
double distance(const std::array<double, 2>& p, const std::array<double, 2>& a, const std::array<double, 2>& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double length2 = dx * dx + dy * dy;
  const double along = length2 > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - along * dx, p[1] - a[1] - along * dy);
}

class Sampler {
public:
  Sampler(const std::function<double(double)>& y, const CurveRequest& request) : y_(y), request_(request) {
    logarithmic_ = request.x.scale == Scale::logarithmic;
    low_ = to_axis(request.x.from);
    high_ = to_axis(request.x.to);
  }

  std::vector<Sample> run() {
    std::vector<Sample> samples;
    for (const double t : first()) samples.push_back(evaluate(t));
    if (!request_.adaptive) return samples;
    const Canvas canvas(request_, samples);
    std::vector<Sample> refined = {samples.front()};
    for (std::size_t k = 0; k + 1 < samples.size(); ++k) refine(canvas, samples[k], samples[k + 1], 0, refined);
    const Canvas final_canvas(request_, refined);
    return simplified(final_canvas, refined);
  }

  double from_axis(double t) const {
    if (t == low_) return request_.x.from;
    if (t == high_) return request_.x.to;
    return logarithmic_ ? std::exp(t) : t;
  }

  std::vector<double> first() const {
    std::vector<double> t;
    for (int k = 0; k < request_.initial; ++k) t.push_back(low_ + (high_ - low_) * k / (request_.initial - 1));
    t.back() = high_;
    for (const double seed : request_.seeds) {
      const double centre = to_axis(seed);
      if (!(centre >= low_ && centre <= high_)) continue;
      t.push_back(centre);
      for (double away = 0.25 * (high_ - low_); away > 1e-6 * (high_ - low_); away *= 0.5)
        for (const double side : {centre - away, centre + away})
          if (side > low_ && side < high_) t.push_back(side);
    }
    std::ranges::sort(t);
    const auto repeated = std::ranges::unique(t, [&](double a, double b) { return b - a < 1e-9 * (high_ - low_); });
    t.erase(repeated.begin(), repeated.end());
    if (t.back() != high_) t.back() = high_;
    return t;
  }

private:
  double to_axis(double x) const { return logarithmic_ ? std::log(x) : x; }
  Sample evaluate(double t) const { return {t, y_(from_axis(t))}; }

  void refine(const Canvas& canvas, const Sample& a, const Sample& b, int depth, std::vector<Sample>& out) const {
    const double t = 0.5 * (a.t + b.t);
    if (depth < 24 && b.t - a.t > 1e-7 * (high_ - low_) && (std::isfinite(a.y) || std::isfinite(b.y))) {
      const Sample middle = evaluate(t);
      const auto p = canvas.at(a), q = canvas.at(b), m = canvas.at(middle);
      if (!(distance(m, p, q) <= tolerance_)) {
        refine(canvas, a, middle, depth + 1, out);
        refine(canvas, middle, b, depth + 1, out);
        return;
      }
    }
    out.push_back(b);
  }

  /// Douglas and Peucker 1973, with an explicit stack.
  static std::vector<Sample> simplified(const Canvas& canvas, const std::vector<Sample>& samples) {
    std::vector<bool> keep(samples.size(), false);
    keep.front() = keep.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> stack = {{0, samples.size() - 1}};
    while (!stack.empty()) {
      const auto [a, b] = stack.back();
      stack.pop_back();
      double worst = 0;
      std::size_t at = a;
      for (std::size_t k = a + 1; k < b; ++k) {
        const double d = distance(canvas.at(samples[k]), canvas.at(samples[a]), canvas.at(samples[b]));
        if (std::isnan(d) || d > worst) {
          worst = std::isnan(d) ? 1 : d;
          at = k;
        }
      }
      if (at == a || worst <= 0.5 * tolerance_) continue;
      keep[at] = true;
      stack.emplace_back(a, at);
      stack.emplace_back(at, b);
    }
    std::vector<Sample> out;
    for (std::size_t k = 0; k < samples.size(); ++k)
      if (keep[k]) out.push_back(samples[k]);
    return out;
  }

  static constexpr double tolerance_ = 5e-4;
  const std::function<double(double)>& y_;
  const CurveRequest& request_;
  bool logarithmic_;
  double low_, high_;
};

} // namespace

std::vector<double> first_points(const CurveRequest& request) {
  const std::function<double(double)> none;
  const Sampler sampler(none, request);
  std::vector<double> points = sampler.first();
  for (double& point : points) point = sampler.from_axis(point);
  return points;
}

Curve sample(const std::function<double(double)>& y, const CurveRequest& request) {
  Sampler sampler(y, request);
  Curve curve;
  for (const Sample& point : sampler.run()) {
    curve.x.push_back(sampler.from_axis(point.t));
    curve.y.push_back(point.y);
  }
  return curve;
}

} // namespace brdfplot::plot
