#include "math/cubature.hpp"

#include "base/threads/interrupt.hpp"

#include "math/gauss_kronrod.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace brdfplot {

namespace {

constexpr std::size_t nx = 31;
constexpr std::size_t ny = 15;

using Channels = std::array<double, 3>;

double largest(const Channels& of) { return std::max({of[0], of[1], of[2]}); }

/// Whether holds(c) for each channel c.
template <class Predicate>
bool all_channels(std::size_t channels, const Predicate& holds) {
  for (std::size_t c = 0; c < channels; ++c)
    if (!holds(c)) return false;
  return true;
}

struct Cell {
  Rectangle where;
  Channels value{};
  Channels error{};
  bool across_x = false; ///< which variable has the larger error
  bool operator<(const Cell& other) const { return largest(error) < largest(other.error); }
};

/// The integral of one of the rules over its lines, added with the weights of the other rule, and their errors. Each
/// line is judged by itself: those on which coefficients fall slowly are often few, and in sums over all lines they
/// would pass for a small part of what falls fast.
template <std::size_t N>
class Lines {
public:
  /// One line: its values, `stride` apart.
  void add(const double* values, std::size_t stride, double weight) {
    for (std::size_t k = 0; k < N; ++k) line_[k] = values[k * stride];
    const RuleSums sums = apply_rule<N>(line_);
    value_ += weight * sums.kronrod;
    error_ += weight * error_of<N>(sums);
  }
  double value() const { return value_; }
  double error() const { return error_; }

private:
  std::array<double, N> line_{};
  double value_ = 0, error_ = 0;
};

class Cubature {
public:
  Cubature(const PlaneFunction& f, std::size_t channels)
      : f_(f), channels_(channels), x_(nx * ny), y_(nx * ny), values_(channels * nx * ny) {}

  Cell apply(const Rectangle& r) {
    const auto& rx = GaussKronrod<nx>::rule();
    const auto& ry = GaussKronrod<ny>::rule();
    const double half_x = 0.5 * (r.x1 - r.x0), half_y = 0.5 * (r.y1 - r.y0);
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i) {
        x_[j * nx + i] = 0.5 * (r.x0 + r.x1) + half_x * rx.x[i];
        y_[j * nx + i] = 0.5 * (r.y0 + r.y1) + half_y * ry.x[j];
      }
    f_(r.chart, x_.data(), y_.data(), values_.data(), nx * ny);
    evaluations += nx * ny;
    Cell cell{r};
    double worst_x = 0, worst_y = 0;
    const double area = std::fabs(half_x * half_y);
    for (std::size_t c = 0; c < channels_; ++c) {
      const double* values = &values_[c * nx * ny];
      Lines<nx> rows;
      Lines<ny> columns;
      for (std::size_t j = 0; j < ny; ++j) rows.add(values + j * nx, 1, ry.kronrod[j]);
      for (std::size_t i = 0; i < nx; ++i) columns.add(values + i, nx, rx.kronrod[i]);
      cell.value[c] = area * rows.value();
      cell.error[c] = area * (rows.error() + columns.error());
      worst_x = std::max(worst_x, rows.error());
      worst_y = std::max(worst_y, columns.error());
    }
    cell.across_x = worst_x >= worst_y;
    return cell;
  }

  using Pair = std::array<Cell, 2>;

  Pair cut(const Cell& whole, double at) {
    Rectangle first = whole.where, second = whole.where;
    if (whole.across_x)
      first.x1 = second.x0 = first.x0 + at * (first.x1 - first.x0);
    else
      first.y1 = second.y0 = first.y0 + at * (first.y1 - first.y0);
    return {apply(first), apply(second)};
  }

  Pair divide(const Cell& whole) {
    const Pair halves = cut(whole, 0.5);
    const auto believed = [&](std::size_t c) {
      return error(halves, c) >= 1e-4 * std::fabs(halves[0].value[c] + halves[1].value[c] - whole.value[c]);
    };
    if (all_channels(channels_, believed)) return halves;
    const Pair others = cut(whole, 0.45);
    return worst_error(others) > worst_error(halves) ? others : halves;
  }

  std::size_t evaluations = 0;

private:
  static double error(const Pair& pair, std::size_t c) { return pair[0].error[c] + pair[1].error[c]; }
  static double worst_error(const Pair& pair) { return std::max({error(pair, 0), error(pair, 1), error(pair, 2)}); }

  const PlaneFunction& f_;
  std::size_t channels_;
  std::vector<double> x_, y_, values_;
};

bool too_small(const Rectangle& r) {
  return r.x1 - r.x0 < 1e-14 * std::max(std::fabs(r.x0), std::fabs(r.x1)) ||
         r.y1 - r.y0 < 1e-14 * std::max(std::fabs(r.y0), std::fabs(r.y1));
}

} // namespace

Estimate integrate_plane(const PlaneFunction& f, std::span<const Rectangle> rectangles, const Tolerance& tolerance,
                         std::size_t max_evaluations) {
  return integrate_plane(f, 1, rectangles, tolerance, max_evaluations).channel(0);
}

ColourEstimate integrate_plane(const PlaneFunction& f, std::size_t channels, std::span<const Rectangle> rectangles,
                               const Tolerance& tolerance, std::size_t max_evaluations) {
  throw_if_interrupted();
  Cubature cubature(f, channels);
  std::vector<Cell> heap; // the largest error on top
  const auto add = [&](const Cell& cell) {
    heap.push_back(cell);
    std::push_heap(heap.begin(), heap.end());
  };
  ColourEstimate estimate;
  const auto sum = [&] {
    estimate = {};
    for (const Cell& cell : heap) estimate.add({cell.value, cell.error});
    const auto met = [&](std::size_t c) {
      return estimate.error[c] <= std::max(tolerance.absolute, tolerance.relative * std::fabs(estimate.value[c]));
    };
    return all_channels(channels, met);
  };
  for (const Rectangle& r : rectangles)
    if (r.x0 < r.x1 && r.y0 < r.y1) add(cubature.apply(r));
  while (!sum() && cubature.evaluations < max_evaluations) {
    std::pop_heap(heap.begin(), heap.end());
    const Cell worst = heap.back();
    if (too_small(worst.where)) break;
    heap.pop_back();
    for (const Cell& part : cubature.divide(worst)) add(part);
  }
  estimate.evaluations = cubature.evaluations;
  return estimate;
}

} // namespace brdfplot
