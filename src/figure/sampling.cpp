#include "figure/sampling.hpp"

#include "figure/sampling_canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>

namespace brdfplot::plot {

namespace {

class Sampler {
public:
  Sampler(const CurveFunction& y, const CurveRequest& request) : y_(y), request_(request) {
    logarithmic_ = request.x.scale == Scale::logarithmic;
    low_ = to_axis(request.x.from);
    high_ = to_axis(request.x.to);
  }

  std::vector<Sample> run() {
    std::vector<Sample> samples = evaluate(first());
    if (!request_.adaptive) return samples;
    left_ = most_evaluations;
    refine(Canvas(request_, samples), samples);
    const Canvas canvas(request_, samples);
    if (!request_.polar && request_.noise == 0) add_kinks(canvas, samples);
    return simplified(canvas, samples);
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
    // Not std::ranges::unique: clang 14 does not compile this library's subrange.
    const auto same = [&](double a, double b) { return b - a < 1e-9 * (high_ - low_); };
    t.erase(std::unique(t.begin(), t.end(), same), t.end());
    if (t.back() != high_) t.back() = high_;
    return t;
  }

private:
  struct Interval {
    Sample a, b;
    /// The error of the interval of which this is a half. Halving divides the error of a smooth curve by 4; where it
    /// suddenly vanishes, the curve may cross its chord at the midpoint, and another halving tells.
    double before;
  };

  double to_axis(double x) const { return logarithmic_ ? std::log(x) : x; }

  std::vector<Sample> evaluate(const std::vector<double>& t) const {
    if (t.empty()) return {};
    std::vector<double> x;
    std::ranges::transform(t, std::back_inserter(x), [&](double place) { return from_axis(place); });
    const std::vector<double> y = y_(x);
    std::vector<Sample> samples;
    for (std::size_t k = 0; k < t.size(); ++k) samples.push_back({t[k], y[k]});
    return samples;
  }

  static void sort(std::vector<Sample>& samples) { std::ranges::sort(samples, {}, &Sample::t); }

  void refine(const Canvas& canvas, std::vector<Sample>& samples) {
    std::vector<Interval> round;
    const auto bend = [&](std::size_t k) {
      return k > 0 && k + 1 < samples.size() ? canvas.error(samples[k - 1], samples[k], samples[k + 1]) : 0;
    };
    for (std::size_t k = 0; k + 1 < samples.size(); ++k)
      round.push_back({samples[k], samples[k + 1], std::max(bend(k), bend(k + 1))});
    while (!round.empty()) {
      thin(round);
      std::vector<double> t;
      for (const Interval& interval : round) t.push_back(0.5 * (interval.a.t + interval.b.t));
      const std::vector<Sample> middles = evaluate(t);
      std::vector<Interval> next;
      for (std::size_t k = 0; k < round.size(); ++k) {
        const auto& [a, b, before] = round[k];
        const double error = canvas.error(a, middles[k], b);
        samples.push_back(middles[k]);
        if (!(error > tolerance_ || before > 16 * tolerance_)) continue;
        next.push_back({a, middles[k], error});
        next.push_back({middles[k], b, error});
      }
      round = std::move(next);
    }
    sort(samples);
  }

  /// Leaves of a round what can be halved with the evaluations that are left, and takes them.
  void thin(std::vector<Interval>& round) {
    std::erase_if(round, [&](const Interval& interval) {
      return interval.b.t - interval.a.t <= 1e-7 * (high_ - low_) ||
             (!std::isfinite(interval.a.y) && !std::isfinite(interval.b.y));
    });
    const auto affordable = static_cast<std::size_t>(left_);
    if (round.size() > affordable) {
      std::ranges::stable_sort(round, std::greater(), &Interval::before);
      round.resize(affordable);
    }
    left_ -= static_cast<int>(round.size());
  }

  /// Looks for a kink between each two samples: there the curve bends, and on either side it hardly does.
  void add_kinks(const Canvas& canvas, std::vector<Sample>& samples) {
    std::vector<std::array<double, 2>> p;
    for (const Sample& sample : samples) p.push_back(canvas.at(sample));
    const auto slope = [&](std::size_t k) { return (p[k + 1][1] - p[k][1]) / (p[k + 1][0] - p[k][0]); };
    const auto bend = [&](std::size_t k) { return std::fabs((slope(k) - slope(k - 1)) / (p[k + 1][0] - p[k - 1][0])); };
    const std::size_t count = samples.size();
    std::vector<Kink> kinks;
    for (std::size_t k = 2; k + 3 < count; ++k) {
      if (p[k + 1][0] - p[k][0] < 1e-6 || !(std::fabs(slope(k + 1) - slope(k - 1)) > 0.02)) continue;
      if (!(bend(k) + bend(k + 1) > 8 * (bend(k - 1) + bend(k + 2)))) continue;
      kinks.push_back({{samples[k - 1], samples[k], samples[k + 1], samples[k + 2]}});
    }
    for (int step = 0; step < kink_steps; ++step) narrow(canvas, kinks);
    for (const Sample& kink : met(canvas, kinks)) samples.push_back(kink);
    sort(samples);
  }

  /// Between the two samples in the middle there may be a kink: where the line through the two on the left meets the
  /// line through the two on the right.
  struct Kink {
    std::array<Sample, 4> s;
    double first_turn = 0; ///< the angle of the lines at first

    struct Meeting {
      double t, value;
    };
    /// Nothing where the lines lose their angle, as those of a smooth curve do, or meet elsewhere.
    std::optional<Meeting> meeting(const Canvas& canvas) {
      std::array<double, 4> v{};
      std::ranges::transform(s, v.begin(), [&](const Sample& sample) { return canvas.at(sample)[1]; });
      const double rise = (v[1] - v[0]) / (s[1].t - s[0].t), fall = (v[3] - v[2]) / (s[3].t - s[2].t);
      if (first_turn == 0) first_turn = rise - fall;
      if (!(std::fabs(rise - fall) > 0.5 * std::fabs(first_turn))) return std::nullopt;
      const double gap = s[2].t - s[1].t;
      const double t = s[1].t + (v[2] - v[1] - fall * gap) / (rise - fall);
      if (!(t > s[1].t && t < s[2].t)) return std::nullopt;
      return Meeting{t, v[1] + rise * (t - s[1].t)};
    }
  };

  /// Draws the lines of all kinks again through nearer samples, and drops what is none.
  void narrow(const Canvas& canvas, std::vector<Kink>& kinks) {
    std::vector<Kink> kept;
    std::vector<double> t;
    for (Kink& kink : kinks) {
      const auto meeting = kink.meeting(canvas);
      if (!meeting || left_ < 4) continue;
      left_ -= 4;
      const double gap = kink.s[2].t - kink.s[1].t;
      for (const double away : {-0.25, -0.125, 0.125, 0.25}) t.push_back(meeting->t + away * gap);
      kept.push_back(kink);
    }
    const std::vector<Sample> samples = evaluate(t);
    for (std::size_t k = 0; k < kept.size(); ++k)
      std::copy_n(samples.begin() + static_cast<std::ptrdiff_t>(4 * k), 4, kept[k].s.begin());
    kinks = std::move(kept);
  }

  /// The curve where the lines of each kink meet, if it is there.
  std::vector<Sample> met(const Canvas& canvas, std::vector<Kink>& kinks) {
    std::vector<double> t, value;
    for (Kink& kink : kinks) {
      const auto meeting = kink.meeting(canvas);
      if (!meeting || left_ < 1) continue;
      --left_;
      t.push_back(meeting->t);
      value.push_back(meeting->value);
    }
    std::vector<Sample> out;
    const std::vector<Sample> samples = evaluate(t);
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (!(std::fabs(canvas.at(samples[k])[1] - value[k]) < 1e-8)) continue;
      out.push_back(samples[k]);
      out.back().is_kink = true;
    }
    return out;
  }

  /// Douglas and Peucker 1973, with an explicit stack.
  std::vector<Sample> simplified(const Canvas& canvas, const std::vector<Sample>& samples) const {
    std::vector<bool> keep(samples.size(), false);
    // The ends of gaps stay, and nothing of what is between them; the rest is thinned piece by piece.
    std::vector<std::pair<std::size_t, std::size_t>> stack;
    for (std::size_t k = 0, start = 0; k < samples.size(); ++k) {
      const bool last = k + 1 == samples.size();
      keep[k] = k == 0 || last || samples[k].is_kink || is_gap(samples[k]) != is_gap(samples[k + 1]) ||
                is_gap(samples[k]) != is_gap(samples[k - 1]);
      if (!keep[k]) continue;
      if (!is_gap(samples[k])) stack.emplace_back(start, k);
      start = k;
    }
    while (!stack.empty()) {
      const auto [a, b] = stack.back();
      stack.pop_back();
      double worst = 0.6 * tolerance_; // halving has left a quarter of the rest
      std::size_t at = a;
      for (std::size_t k = a + 1; k < b; ++k) {
        const double error = canvas.error(samples[a], samples[k], samples[b]);
        if (error > worst) {
          worst = error;
          at = k;
        }
      }
      if (at == a) continue;
      keep[at] = true;
      stack.emplace_back(a, at);
      stack.emplace_back(at, b);
    }
    std::vector<Sample> out;
    for (std::size_t k = 0; k < samples.size(); ++k)
      if (keep[k]) out.push_back(samples[k]);
    return out;
  }

  bool is_gap(const Sample& sample) const { return request_.polar ? !std::isfinite(sample.y) : std::isnan(sample.y); }

  static constexpr double tolerance_ = 5e-4;
  static constexpr int kink_steps = 7;
  const CurveFunction& y_;
  const CurveRequest& request_;
  bool logarithmic_;
  double low_, high_;
  int left_ = 0; ///< evaluations
};

} // namespace

std::vector<double> first_points(const CurveRequest& request) {
  const CurveFunction none;
  const Sampler sampler(none, request);
  std::vector<double> first = sampler.first();
  for (double& point : first) point = sampler.from_axis(point);
  return first;
}

Curve sample(const CurveFunction& y, const CurveRequest& request) {
  Sampler sampler(y, request);
  Curve curve;
  for (const Sample& point : sampler.run()) {
    curve.x.push_back(sampler.from_axis(point.t));
    curve.y.push_back(point.y);
  }
  return curve;
}

} // namespace brdfplot::plot
