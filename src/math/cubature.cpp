#include "math/cubature.hpp"

#include "math/interrupt.hpp"

#include "math/gauss_kronrod.hpp"

#include <algorithm>
#include <vector>

namespace brdfplot {

namespace {

constexpr std::size_t nx = 31;
constexpr std::size_t ny = 15;

struct Cell {
  Rectangle where;
  double value = 0;
  double error = 0;
  bool across_x = false; ///< which variable has the larger error
  bool operator<(const Cell& other) const { return error < other.error; }
};

/// The sums of a product rule: in each variable, what its two rules say of the integral over the other one. They share
/// the integral by Kronrod's rules, and the spread.
struct ProductSums {
  RuleSums in_x, in_y;
};

ProductSums weigh(const std::vector<double>& f) {
  const auto& rx = GaussKronrod<nx>::rule();
  const auto& ry = GaussKronrod<ny>::rule();
  ProductSums sums;
  for (std::size_t j = 0; j < ny; ++j) {
    double kronrod = 0, gauss = 0, magnitude = 0;
    for (std::size_t i = 0; i < nx; ++i) {
      const double value = f[j * nx + i];
      kronrod += rx.kronrod[i] * value;
      gauss += rx.gauss[i] * value;
      magnitude += rx.kronrod[i] * std::fabs(value);
    }
    sums.in_x.kronrod += ry.kronrod[j] * kronrod;
    sums.in_x.gauss += ry.kronrod[j] * gauss;
    sums.in_y.gauss += ry.gauss[j] * kronrod;
    sums.in_x.magnitude += ry.kronrod[j] * magnitude;
  }
  const double mean = 0.25 * sums.in_x.kronrod;
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i)
      sums.in_x.spread += ry.kronrod[j] * rx.kronrod[i] * std::fabs(f[j * nx + i] - mean);
  sums.in_y.kronrod = sums.in_x.kronrod;
  sums.in_y.magnitude = sums.in_x.magnitude;
  sums.in_y.spread = sums.in_x.spread;
  return sums;
}

class Cubature {
public:
  explicit Cubature(const PlaneFunction& f) : f_(f), x_(nx * ny), y_(nx * ny), values_(nx * ny) {}

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
    const ProductSums sums = weigh(values_);
    const double in_x = sums.in_x.error();
    const double in_y = sums.in_y.error();
    const double area = std::fabs(half_x * half_y);
    return {r, area * sums.in_x.kronrod, area * (in_x + in_y), in_x >= in_y};
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
    const auto error = [](const Pair& pair) { return pair[0].error + pair[1].error; };
    const Pair halves = cut(whole, 0.5);
    if (error(halves) > 1e-4 * std::fabs(halves[0].value + halves[1].value - whole.value)) return halves;
    const Pair others = cut(whole, 0.45);
    return error(others) > error(halves) ? others : halves;
  }

  std::size_t evaluations = 0;

private:
  const PlaneFunction& f_;
  std::vector<double> x_, y_, values_;
};

bool too_small(const Rectangle& r) {
  return r.x1 - r.x0 < 1e-14 * std::max(std::fabs(r.x0), std::fabs(r.x1)) ||
         r.y1 - r.y0 < 1e-14 * std::max(std::fabs(r.y0), std::fabs(r.y1));
}

} // namespace

Estimate integrate_plane(const PlaneFunction& f, std::span<const Rectangle> rectangles, const Tolerance& tolerance,
                         std::size_t max_evaluations) {
  throw_if_interrupted();
  Cubature cubature(f);
  std::vector<Cell> heap; // the largest error on top
  const auto add = [&](const Cell& cell) {
    heap.push_back(cell);
    std::push_heap(heap.begin(), heap.end());
  };
  Estimate estimate;
  const auto sum = [&] {
    estimate.value = estimate.error = 0;
    for (const Cell& cell : heap) {
      estimate.value += cell.value;
      estimate.error += cell.error;
    }
    return estimate.error <= std::max(tolerance.absolute, tolerance.relative * std::fabs(estimate.value));
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
