#include "microfacet/distributions/radial_structure.hpp"

#include "math/chebyshev.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace brdfplot {

namespace {

constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

/// [low, high] with f at its ends and in the middle.
struct Bracket {
  double low, high, at_low, at_middle, at_high;

  double middle() const { return 0.5 * (low + high); }
  double bend() const { return std::fabs(at_middle - 0.5 * (at_low + at_high)); } ///< the second difference
  /// What rounding leaves of that, of f and of its argument.
  double noise() const {
    const double slope = std::fabs(at_high - at_low) / (high - low);
    return rounding * (std::max({at_low, at_middle, at_high}) + slope * middle());
  }
};

/// The part of half the width that bends most: a half, or the middle of the whole.
Bracket most_bent_part(const std::function<double(double)>& f, const Bracket& whole) {
  const double middle = whole.middle(), left = 0.5 * (whole.low + middle), right = 0.5 * (middle + whole.high);
  const double at_left = f(left), at_right = f(right);
  const std::array<Bracket, 3> parts = {{{whole.low, middle, whole.at_low, at_left, whole.at_middle},
                                         {left, right, at_left, whole.at_middle, at_right},
                                         {middle, whole.high, whole.at_middle, at_right, whole.at_high}}};
  return *std::ranges::max_element(parts, {}, &Bracket::bend);
}

/// Where in the bracket f jumps or has a corner. There the second difference halves with the bracket or stays; where f
/// is smooth it falls to a quarter each time. Those below `negligible` are not looked at.
std::optional<double> sharp_place(const std::function<double(double)>& f, Bracket bracket, double negligible) {
  constexpr int near = 10, nearer = 20, most = 60;
  double bend = 0; // of the near one
  for (int k = 0; k < most; ++k) {
    if (k == near) bend = bracket.bend();
    if (k == nearer && bracket.bend() < bend * 0x1p-15) return {};
    if (!(bracket.bend() > bracket.noise() + negligible)) {
      if (k < nearer) return {};
      break;
    }
    if (!(bracket.low < bracket.middle() && bracket.middle() < bracket.high)) break;
    bracket = most_bent_part(f, bracket);
  }
  return bracket.middle();
}

constexpr std::size_t node_count = 21;

/// The integrand over x = 6 / (6 + t2) of the mass, f |dt2/dx|. Infinity is at x = 0, where numbers are dense.
constexpr double spread = 6;
double t2_at(double x) { return spread * (1 - x) / x; }
double place_of(double t2) { return spread / (spread + t2); }
double weighted(double density, double x) { return density * spread / (x * x); }

/// The polynomial through the Chebyshev points of [from, to].
struct Polynomial {
  double from, to;
  std::array<double, node_count> coefficients{};

  double operator()(double place) const {
    const double x = (2 * place - from - to) / (to - from);
    return chebyshev_sum(node_count, x, [&](std::size_t k) { return coefficients[k]; });
  }
};

class Scales {
public:
  explicit Scales(const RadialSamples& samples) : samples_(samples) {
    for (std::size_t k = samples.t2s.size(); k-- > 0;) {
      places_.push_back(place_of(samples.t2s[k]));
      values_.push_back(weighted(samples.values[k], places_.back()));
      negligible_ = std::max(negligible_, 1e-11 * std::min(places_.back(), 1 - places_.back()) * values_.back());
    }
  }

  /// Halves [from, to] as an adaptive rule would, until it has converged and nothing is hidden; appends the places of
  /// the cuts that lead to what would have been, and on until it is seen well (`revealed`).
  bool cut(double from, double to, bool revealed, std::vector<double>& all) const {
    const double beside = 1e-9 * (to - from); // what is at a cut is on either side of it
    const auto first = std::ranges::upper_bound(places_, from + beside);
    const auto last = std::ranges::lower_bound(places_, to - beside);
    constexpr std::ptrdiff_t fewest = 4;
    if (last - first < fewest) return false;
    const Polynomial p = through_nodes(from, to);
    double left = 0, largest = 0; // of the coefficients
    for (std::size_t k = 0; k < node_count; ++k) {
      largest = std::max(largest, std::fabs(p.coefficients[k]));
      if (k + 4 >= node_count) left = std::max(left, std::fabs(p.coefficients[k]));
    }
    const double not_seen = left * (to - from);
    const bool hidden = std::any_of(first, last, [&](const double& x) {
      const double off = std::fabs(p(x) - values_[static_cast<std::size_t>(&x - places_.data())]);
      const double width = std::min(x - from, to - x); // of what is off there, at an end that is like a root
      return off * width > 10 * not_seen + negligible_;
    });
    if (!hidden && not_seen <= negligible_) return false;
    revealed = hidden || (revealed && left > 1e-3 * largest);
    const double middle = 0.5 * (from + to);
    std::vector<double> cuts;
    const bool before = cut(from, middle, revealed, cuts);
    cuts.push_back(middle);
    if (!cut(middle, to, revealed, cuts) && !before && !revealed) return false;
    all.insert(all.end(), cuts.begin(), cuts.end());
    return true;
  }

private:
  Polynomial through_nodes(double from, double to) const {
    Polynomial p{from, to};
    for (std::size_t k = 0; k < node_count; ++k) {
      const double x = 0.5 * (from + to) + 0.5 * (to - from) * chebyshev_node(k, node_count);
      p.coefficients[k] = weighted(samples_.density(t2_at(x)), x);
    }
    to_chebyshev_coefficients(p.coefficients.data(), node_count);
    return p;
  }

  const RadialSamples& samples_;
  std::vector<double> places_, values_; ///< of the samples, ascending
  double negligible_ = 0;               ///< mass
};

} // namespace

std::vector<double> jumps_and_corners(const RadialSamples& samples) {
  const auto& x = samples.t2s;
  const auto& y = samples.values;
  std::vector<double> found;
  std::vector<double> bends(x.size(), 0); // of the samples with their neighbours, per unit of ln t2
  for (std::size_t k = 1; k + 1 < x.size(); ++k)
    bends[k] = std::fabs((y[k + 1] - y[k]) / (x[k + 1] - x[k]) - (y[k] - y[k - 1]) / (x[k] - x[k - 1])) * x[k];
  // Of what is left in a tail nothing is seen; formulas lose their digits there.
  const auto seen = [&](std::size_t k) { return samples.mass_at(k) * std::sqrt(1 + x[k]); };
  double negligible = 0;
  for (std::size_t k = 0; k < x.size(); ++k) negligible = std::max(negligible, 1e-14 * seen(k));
  const double rounded = rounding * *std::ranges::max_element(y); // as 1 - tanh leaves it
  constexpr std::size_t beside = 3;
  for (std::size_t k = beside; k + beside < x.size(); ++k) {
    if (!(seen(k) > negligible || seen(k - 1) > negligible || seen(k + 1) > negligible)) continue;
    if (!(bends[k] > 2 * std::min(bends[k - beside], bends[k + beside]))) continue;
    const double low = x[k - 1], high = x[k + 1], middle = 0.5 * (low + high);
    const auto place = sharp_place(samples.density, {low, high, y[k - 1], samples.density(middle), y[k + 1]}, rounded);
    if (place) found.push_back(*place);
  }
  std::ranges::sort(found);
  const auto same = [](double one, double other) { return other - one < 1e-7 * other; };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
  return found;
}

std::vector<double> cuts_between_scales(const RadialSamples& samples, const std::vector<double>& known) {
  const Scales scales(samples);
  // Beyond the last sample formulas may overflow.
  std::vector<double> places = {place_of(samples.t2s.back()), 1};
  for (const double t2 : known) places.push_back(place_of(t2));
  std::ranges::sort(places);
  std::vector<double> cuts, all;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) scales.cut(places[k], places[k + 1], false, cuts);
  for (const double x : cuts) all.push_back(t2_at(x));
  std::ranges::sort(all);
  return all;
}

} // namespace brdfplot
