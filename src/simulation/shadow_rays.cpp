#include "simulation/shadow_rays.hpp"

#include "base/threads/interrupt.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

// The loop over the lanes is compiled for several instruction sets, of which the machine's is chosen when the program
// starts. Sanitizers are not ready by then.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)
#define BRDFPLOT_FOR_EACH_PROCESSOR __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define BRDFPLOT_FOR_EACH_PROCESSOR
#endif

namespace brdfplot::simulation {

namespace {

constexpr std::size_t lanes = 16;
/// Larger blocks are no faster, and take longer to make.
constexpr int most_levels = 8;
constexpr float longest = 0x1p20F;

/// What all rays share.
struct Common {
  const float* heights;
  const float* highest;
  const int* begin;
  int nx, ny, top;
  float dx, dy, dz, inverse_x, inverse_y, inverse_sum;
  bool right, up; ///< towards larger x, y
};

/// Rays on their way. Coordinates are relative to the cell where a ray began, which keeps them small; (cell_x, cell_y)
/// is that of the ray at length t, (field_x, field_y) the same in the field.
struct Rays {
  alignas(64) float x[lanes], y[lanes], z[lanes], t[lanes], end[lanes];
  alignas(64) int cell_x[lanes], cell_y[lanes], field_x[lanes], field_y[lanes], level[lanes];
  alignas(64) int hit[lanes], done[lanes];
};

inline int wrapped(int k, int n) { return k + (k < 0 ? n : 0) - (k >= n ? n : 0); }
inline int larger(int a, int b) { return a > b ? a : b; }
inline int smaller(int a, int b) { return a < b ? a : b; }

/// Takes every ray one step: over a block that it clears, through a cell, or down a level.
BRDFPLOT_FOR_EACH_PROCESSOR
void step(const Common& common, Rays& rays) {
  const Common c = common;
  const float* __restrict const heights = c.heights;
  const float* __restrict const highest = c.highest;
  const int* __restrict const begin = c.begin;
  Rays* __restrict const r = &rays;
  // All bits or none: GCC vectorizes no choice by a bool that the lanes share.
  const int right = c.right ? -1 : 0, up = c.up ? -1 : 0;
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
  for (std::size_t k = 0; k < lanes; ++k) {
    const int level = r->level[k], ix = r->field_x[k], iy = r->field_y[k], cell_x = r->cell_x[k], cell_y = r->cell_y[k];
    const float x = r->x[k], y = r->y[k], z = r->z[k], t = r->t[k];

    // The block, its exit, and whether the ray clears it.
    const int size = 1 << level;
    const int left = cell_x - (ix & (size - 1)), bottom = cell_y - (iy & (size - 1));
    const int side_x = left + (size & right), side_y = bottom + (size & up);
    const float to_x = (static_cast<float>(side_x) - x) * c.inverse_x;
    const float to_y = (static_cast<float>(side_y) - y) * c.inverse_y;
    const bool by_x = to_x < to_y;
    const float exit = by_x ? to_x : to_y;
    const float exit_x = x + exit * c.dx, exit_y = y + exit * c.dy;
    const bool clears = z + t * c.dz > highest[begin[level] + (iy >> level) * (c.nx >> level) + (ix >> level)];
    const bool in_cell = !clears && level == 0;

    // The surface of the cell below the exit and below the diagonal.
    const int next_x = ix + 1 == c.nx ? 0 : ix + 1, next_y = iy + 1 == c.ny ? 0 : iy + 1;
    const float h00 = heights[iy * c.nx + ix], h10 = heights[iy * c.nx + next_x];
    const float h01 = heights[next_y * c.nx + ix], h11 = heights[next_y * c.nx + next_x];
    const float u = exit_x - static_cast<float>(cell_x), v = exit_y - static_cast<float>(cell_y);
    const float near_facet = h00 + u * (h10 - h00) + v * (h01 - h00);
    const float far_facet = h11 + (1 - u) * (h01 - h11) + (1 - v) * (h10 - h11);
    const float middle = (static_cast<float>(1 + cell_x + cell_y) - x - y) * c.inverse_sum;
    const float u_middle = x + middle * c.dx - static_cast<float>(cell_x);
    const bool under_exit = z + exit * c.dz < (u + v <= 1 ? near_facet : far_facet);
    const bool under_middle = (middle > t) & (middle < exit) & (z + middle * c.dz < h01 + u_middle * (h10 - h01));
    const bool hit = in_cell & (under_exit | under_middle);
    const bool on = clears | in_cell;

    // The next cell; never back, which rounding could ask for at a corner.
    const auto last = static_cast<float>(size - 1);
    const int in_x = left + static_cast<int>(std::min(std::max(exit_x - static_cast<float>(left), 0.0F), last));
    const int in_y = bottom + static_cast<int>(std::min(std::max(exit_y - static_cast<float>(bottom), 0.0F), last));
    const int right_x = larger(in_x, cell_x), left_x = smaller(in_x, cell_x);
    const int upper_y = larger(in_y, cell_y), lower_y = smaller(in_y, cell_y);
    const int along_x = (right_x & right) | (left_x & ~right), along_y = (upper_y & up) | (lower_y & ~up);
    const int beyond_x = side_x - 1 - right, beyond_y = side_y - 1 - up;
    const int to_cell_x = by_x ? beyond_x : along_x, to_cell_y = by_x ? along_y : beyond_y;
    const int to_field_x = wrapped(ix + (to_cell_x - cell_x), c.nx);
    const int to_field_y = wrapped(iy + (to_cell_y - cell_y), c.ny);
    // Within one parent its test would fail again, or nearly always.
    const int parent = level + 1;
    const bool enters = ((to_field_x ^ ix) | (to_field_y ^ iy)) >> parent != 0;
    const int coarser = enters ? smaller(parent, c.top) : level;
    r->field_x[k] = on ? to_field_x : ix;
    r->field_y[k] = on ? to_field_y : iy;
    r->cell_x[k] = on ? to_cell_x : cell_x;
    r->cell_y[k] = on ? to_cell_y : cell_y;
    r->t[k] = on ? exit : t;
    r->level[k] = on ? coarser : level - 1;
    r->hit[k] = hit;
    r->done[k] = hit | (on & (exit >= r->end[k]));
  }
}

/// A finite one, so that a ray along an axis comes to no 0 times infinity.
float inverse(double x) { return x == 0 ? 0x1p60F : static_cast<float>(1 / x); }

} // namespace

ShadowRays::ShadowRays(const HeightField& field) : field_(&field), begin_{0} {
  int nx = field.nx(), ny = field.ny();
  highest_.reserve(field.heights().size() * 3 / 2);
  for (int y = 0; y < ny; ++y) {
    throw_if_interrupted();
    for (int x = 0; x < nx; ++x) {
      const int next_x = (x + 1) % nx, next_y = (y + 1) % ny;
      highest_.push_back(std::max(
          {field.height(x, y), field.height(next_x, y), field.height(x, next_y), field.height(next_x, next_y)}));
    }
  }
  // As long as the blocks tile the period.
  for (int level = 0; level < most_levels && nx % 2 == 0 && ny % 2 == 0; ++level) {
    const auto below = static_cast<std::size_t>(begin_.back());
    begin_.push_back(static_cast<int>(highest_.size()));
    for (int y = 0; y < ny; y += 2)
      for (int x = 0; x < nx; x += 2) {
        const float* corner =
            &highest_[below + static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(x)];
        highest_.push_back(std::max({corner[0], corner[1], corner[nx], corner[nx + 1]}));
      }
    nx /= 2;
    ny /= 2;
  }
}

void ShadowRays::trace(std::span<const SurfacePoint> points, const Direction& direction, float lift,
                       unsigned char* visible) const {
  const auto dx = static_cast<float>(direction.x), dy = static_cast<float>(direction.y);
  const auto dz = static_cast<float>(direction.z);
  const Common common{field_->heights().data(),
                      highest_.data(),
                      begin_.data(),
                      field_->nx(),
                      field_->ny(),
                      static_cast<int>(begin_.size()) - 1,
                      dx,
                      dy,
                      dz,
                      inverse(direction.x),
                      inverse(direction.y),
                      inverse(direction.x + direction.y),
                      dx >= 0,
                      dy >= 0};
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  Rays rays{};
  std::array<std::size_t, lanes> point{};
  std::size_t next = 0, left = points.size();
  const auto start = [&](std::size_t k) {
    point[k] = next < points.size() ? next++ : none;
    if (point[k] == none) return; // goes on as it was
    const SurfacePoint& from = points[point[k]];
    const int ix = std::min(static_cast<int>(from.x), common.nx - 1);
    const int iy = std::min(static_cast<int>(from.y), common.ny - 1);
    rays.x[k] = from.x - static_cast<float>(ix);
    rays.y[k] = from.y - static_cast<float>(iy);
    rays.z[k] = from.z + lift;
    rays.t[k] = 0;
    rays.end[k] = std::min((field_->highest() - rays.z[k]) / dz, longest);
    rays.cell_x[k] = rays.cell_y[k] = rays.level[k] = 0;
    rays.field_x[k] = ix;
    rays.field_y[k] = iy;
  };
  for (std::size_t k = 0; k < lanes; ++k) start(k);
  while (left > 0) {
    step(common, rays);
    for (std::size_t k = 0; k < lanes; ++k) {
      if (rays.done[k] == 0 || point[k] == none) continue;
      visible[point[k]] = rays.hit[k] == 0 ? 1 : 0;
      --left;
      start(k);
    }
  }
}

} // namespace brdfplot::simulation
