#include "choice/compare/pairs.hpp"

#include "base/threads/parallel.hpp"
#include "sampling/points.hpp"
#include "sampling/sampler.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

namespace brdfplot::choice {

namespace {

constexpr double pi = std::numbers::pi;
constexpr unsigned viewer_angles = 16;
constexpr std::size_t replicates = 8; ///< independent sets of points
constexpr double least_share = 1e-3;  ///< of A's largest f, for relative differences
constexpr int most_moves = 200;

struct Viewer {
  Direction omega_o;
  double weight; ///< of cos theta_o d omega_o
};

std::vector<Viewer> viewers(bool isotropic) {
  using Rule = boost::math::quadrature::gauss<double, viewer_angles>;
  const std::size_t azimuths = isotropic ? 1 : 8;
  std::vector<Viewer> out;
  for (std::size_t k = 0; k < Rule::abscissa().size(); ++k)
    for (const double side : {-1.0, 1.0}) {
      const double mu = 0.5 * (1 + side * Rule::abscissa()[k]), weight = 0.5 * Rule::weights()[k] * mu;
      for (std::size_t j = 0; j < azimuths; ++j) {
        const double phi = 2 * pi * (static_cast<double>(j) + 0.5) / static_cast<double>(azimuths);
        const double azimuth = isotropic ? 0 : phi;
        out.push_back({from_angles(std::acos(mu), azimuth), 2 * pi * weight / static_cast<double>(azimuths)});
      }
    }
  return out;
}

/// Sums over directions of the light.
struct Sums {
  double square = 0, reference_square = 0, absolute = 0, reference = 0;

  void add(const Sums& other, double weight) {
    square += weight * other.square;
    reference_square += weight * other.reference_square;
    absolute += weight * other.absolute;
    reference += weight * other.reference;
  }
};

/// What one viewer gives.
struct ViewerResult {
  std::array<Sums, replicates> sums;
  DifferentPair largest, relative;
  double largest_difference = 0, largest_relative = 0;
};

double relative_difference(double a, double b) { return std::abs(a - b) / std::max(std::abs(a), std::abs(b)); }

/// Draws and evaluates the directions of the light of one viewer.
class ViewerComparison {
public:
  ViewerComparison(const MaterialPair& pair, const Sampler& of_a, const Sampler& of_b, const Direction& omega_o)
      : pair_(pair), of_a_(of_a), of_b_(of_b), omega_o_(omega_o) {}

  ViewerResult run(std::size_t count, std::uint64_t stream) {
    ViewerResult result;
    for (std::size_t r = 0; r < replicates; ++r) replicate(count / replicates, stream, r, result);
    climb(result.largest, [](double a, double b) { return std::abs(a - b); });
    result.largest_difference = std::abs(result.largest.a - result.largest.b);
    const double floor = least_share * largest_a_;
    find_relative(floor, result);
    climb(result.relative,
          [floor](double a, double b) { return std::max(a, b) < floor ? 0 : relative_difference(a, b); });
    result.largest_relative = result.relative.a == result.relative.b // NOLINT(clang-diagnostic-float-equal)
                                  ? 0
                                  : relative_difference(result.relative.a, result.relative.b);
    return result;
  }

private:
  void replicate(std::size_t count, std::uint64_t stream, std::size_t r, ViewerResult& result) {
    const std::size_t half = std::max<std::size_t>(count / 2, 1);
    DirectionArrays from_a, from_b, all;
    of_a_.sample(omega_o_, points(PointKind::sobol, 2 * r + 1, stream, 0, half), from_a);
    of_b_.sample(omega_o_, points(PointKind::sobol, 2 * r + 2, stream, 0, half), from_b);
    const std::size_t n = 2 * half;
    all.resize(n);
    DirectionArrays o;
    o.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const DirectionArrays& from = k < half ? from_a : from_b;
      const std::size_t at = k < half ? k : k - half;
      all.set(k, {from.x[at], from.y[at], from.z[at]});
      o.set(k, omega_o_);
    }
    std::vector<double> density_a(n), density_b(n);
    of_a_.densities(n, o.view(), all.view(), density_a.data());
    of_b_.densities(n, o.view(), all.view(), density_b.data());
    const Batch batch{n, o.view(), all.view(), {}};
    const std::vector<double> a = pair_.values(pair_.a, batch), b = pair_.values(pair_.b, batch);
    Sums& sums = result.sums[r];
    for (std::size_t k = 0; k < n; ++k) {
      const double density = 0.5 * (density_a[k] + density_b[k]);
      if (!(density > 0)) continue;
      const double weight = 1 / (static_cast<double>(n) * density);
      for (std::size_t c = 0; c < pair_.channels; ++c) {
        const double f = a[c * n + k], g = b[c * n + k], d = std::abs(f - g);
        sums.add({d * d, f * f, d, f}, weight);
        const Direction omega_i{all.x[k], all.y[k], all.z[k]};
        largest_a_ = std::max(largest_a_, f);
        if (d > std::abs(result.largest.a - result.largest.b))
          result.largest = {omega_o_, omega_i, static_cast<int>(c), f, g};
        seen_.push_back({omega_o_, omega_i, static_cast<int>(c), f, g});
      }
    }
  }

  void find_relative(double floor, ViewerResult& result) const {
    double best = 0;
    for (const DifferentPair& one : seen_) {
      if (std::max(one.a, one.b) < floor || !(relative_difference(one.a, one.b) > best)) continue;
      best = relative_difference(one.a, one.b);
      result.relative = one;
    }
  }

  /// Pattern search in the plane that touches the sphere of directions, its step halved where nothing is better.
  template <class F>
  void climb(DifferentPair& pair, const F& measure) const {
    double best = measure(pair.a, pair.b);
    if (!(best > 0)) return;
    int moves = 0;
    for (double step = 0.05; step > 1e-6 && moves < most_moves;) {
      bool moved = false;
      for (const auto& [u, v] : {std::pair(1.0, 0.0), {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
        const DifferentPair next = at(pair, moved_by(pair.omega_i, step * u, step * v));
        const double value = measure(next.a, next.b);
        if (!(value > best)) continue;
        best = value;
        pair = next;
        moved = true;
        ++moves;
      }
      if (!moved) step /= 2;
    }
  }

  static Direction moved_by(const Direction& from, double u, double v) {
    const Direction side = std::abs(from.z) < 0.9 ? Direction{0, 0, 1} : Direction{1, 0, 0};
    const Direction first = normalized(Direction{from.y * side.z - from.z * side.y, from.z * side.x - from.x * side.z,
                                                 from.x * side.y - from.y * side.x});
    const Direction second{from.y * first.z - from.z * first.y, from.z * first.x - from.x * first.z,
                           from.x * first.y - from.y * first.x};
    return normalized(from + u * first + v * second);
  }

  DifferentPair at(const DifferentPair& like, const Direction& omega_i) const {
    const Batch batch{1, columns(omega_o_), columns(omega_i), {}};
    const auto c = static_cast<std::size_t>(like.channel);
    return {omega_o_, omega_i, like.channel, pair_.values(pair_.a, batch)[c], pair_.values(pair_.b, batch)[c]};
  }
  static Columns columns(const Direction& d) { return {&d.x, &d.y, &d.z}; }

  const MaterialPair& pair_;
  const Sampler& of_a_;
  const Sampler& of_b_;
  Direction omega_o_;
  double largest_a_ = 0;
  std::vector<DifferentPair> seen_;
};

/// The mean of a ratio over the sets of points, and its standard error.
template <class F>
std::pair<double, double> mean_and_error(const std::array<Sums, replicates>& sums, const F& ratio) {
  Sums all;
  double mean = 0, square = 0;
  for (const Sums& one : sums) {
    all.add(one, 1);
    mean += ratio(one);
    square += ratio(one) * ratio(one);
  }
  constexpr auto n = static_cast<double>(replicates);
  mean /= n;
  const double variance = std::max(square / n - mean * mean, 0.0) * n / (n - 1);
  return {ratio(all), std::sqrt(variance / n)};
}

} // namespace

MaterialPair::MaterialPair(const MaterialDescription& first, const MaterialDescription& second)
    : a(build(first)), b(build(second)),
      channels(
          static_cast<std::size_t>(std::max(channels_of(a, Quantity::brdf_cos), channels_of(b, Quantity::brdf_cos)))) {}

bool MaterialPair::is_isotropic() const {
  const auto isotropic = [](const WeightedTerm& term) { return term.is_isotropic(); };
  return std::ranges::all_of(a.terms, isotropic) && std::ranges::all_of(b.terms, isotropic);
}

std::vector<double> MaterialPair::values(const Material& material, const Batch& batch) const {
  std::vector<double> out(3 * batch.n);
  evaluate(material, Quantity::brdf_cos, batch, out.data());
  if (channels_of(material, Quantity::brdf_cos) == 1)
    for (std::size_t c = 1; c < 3; ++c)
      std::copy_n(out.begin(), batch.n, out.begin() + static_cast<std::ptrdiff_t>(c * batch.n));
  out.resize(channels * batch.n);
  return out;
}

void set_differences(const MaterialPair& pair, const CompareOptions& options, MaterialDifference& out) {
  const std::vector<Viewer> all = viewers(pair.is_isotropic());
  const Sampler of_a(pair.a, "default"), of_b(pair.b, "default");
  std::vector<ViewerResult> results(all.size());
  parallel_for(all.size(), options.threads, [&](std::size_t k) {
    results[k] = ViewerComparison(pair, of_a, of_b, all[k].omega_o).run(options.points, k);
  });
  std::array<Sums, replicates> sums{};
  double largest = -1;
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (std::size_t r = 0; r < replicates; ++r) sums[r].add(results[k].sums[r], all[k].weight);
    if (results[k].largest_difference > largest) {
      largest = results[k].largest_difference;
      out.largest = results[k].largest;
    }
    if (results[k].largest_relative > out.relative) {
      out.relative = results[k].largest_relative;
      out.largest_relative = results[k].relative;
    }
  }
  std::tie(out.rms, out.rms_error) = mean_and_error(
      sums, [](const Sums& s) { return s.reference_square > 0 ? std::sqrt(s.square / s.reference_square) : 0; });
  std::tie(out.light, out.light_error) =
      mean_and_error(sums, [](const Sums& s) { return s.reference > 0 ? s.absolute / s.reference : 0; });
}

} // namespace brdfplot::choice
