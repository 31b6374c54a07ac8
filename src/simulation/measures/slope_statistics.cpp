#include "simulation/measures/slope_statistics.hpp"

#include "base/threads/interruptible.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace brdfplot::simulation {

namespace {

constexpr std::size_t rings = 16;
constexpr std::size_t sectors = 8;
constexpr std::size_t bins = rings * sectors;
static_assert(bins - 1 == SlopeStatistics::degrees_of_freedom);

template <class Body>
void for_facets(const Tile& tile, const Body& body) {
  for (int iy = tile.y0; iy < tile.y1; ++iy) {
    throw_if_interrupted();
    for (int ix = tile.x0; ix < tile.x1; ++ix)
      for (const bool far : {false, true}) body(tile.field->to_world(tile.field->facet_slope(ix, iy, far)));
  }
}

double facets_of(const Tile& tile) { return 2.0 * (tile.x1 - tile.x0) * (tile.y1 - tile.y0); }

/// sqrt(1 - r^2) and alike need |r| < 1, which a ruled surface does not give.
double clamped_correlation(double r) { return std::clamp(r, -1 + 1e-12, 1 - 1e-12); }

struct Moments {
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

/// Means over a tile.
Moments moments_of(const Tile& tile) {
  Moments m;
  for_facets(tile, [&](const Slope& s) {
    m.x += s.x;
    m.y += s.y;
    m.xx += s.x * s.x;
    m.xy += s.x * s.y;
    m.yy += s.y * s.y;
  });
  const double n = facets_of(tile);
  return {m.x / n, m.y / n, m.xx / n, m.xy / n, m.yy / n};
}

SlopeMap from_moments(std::span<const Tile> tiles) {
  std::vector<Moments> of_tile(tiles.size());
  tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t k) { of_tile[k] = moments_of(tiles[k]); });
  Moments m;
  for (std::size_t k = 0; k < tiles.size(); ++k) {
    const double w = tiles[k].weight / static_cast<double>(tiles.size());
    m.x += w * of_tile[k].x;
    m.y += w * of_tile[k].y;
    m.xx += w * of_tile[k].xx;
    m.xy += w * of_tile[k].xy;
    m.yy += w * of_tile[k].yy;
  }
  const double xx = m.xx - m.x * m.x, yy = m.yy - m.y * m.y, xy = m.xy - m.x * m.y;
  return {std::sqrt(2 * xx), std::sqrt(2 * yy), xx > 0 && yy > 0 ? clamped_correlation(xy / std::sqrt(xx * yy)) : 0,
          m.x, m.y};
}

/// alpha along an azimuth where slopes have no variance, which are those of GGX: sqrt(3) times the median of
/// |slope - mean|.
double median_alpha(std::span<const Tile> tiles, const SlopeMap& mean, double cos_phi, double sin_phi) {
  std::vector<double> sizes;
  for (const Tile& tile : tiles)
    for_facets(tile, [&](const Slope& s) {
      sizes.push_back(std::fabs(cos_phi * (s.x - mean.mean_x) + sin_phi * (s.y - mean.mean_y)));
    });
  return interruptible([sizes = std::move(sizes)]() mutable {
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::ranges::nth_element(sizes, middle);
    return std::numbers::sqrt3 * *middle;
  });
}

SlopeMap from_medians(std::span<const Tile> tiles) {
  SlopeMap out = from_moments(tiles);
  out.alpha_x = median_alpha(tiles, out, 1, 0);
  out.alpha_y = median_alpha(tiles, out, 0, 1);
  const double diagonal = median_alpha(tiles, out, std::sqrt(0.5), std::sqrt(0.5));
  const double product = diagonal * diagonal - (out.alpha_x * out.alpha_x + out.alpha_y * out.alpha_y) / 2;
  out.correlation = clamped_correlation(product / (out.alpha_x * out.alpha_y));
  return out;
}

/// Shares of the bins in a tile.
std::vector<double> histogram_of(const Tile& tile, const UnitSlopes& shape, const SlopeMap& slopes) {
  std::vector<double> share(bins, 0.0);
  const double one = 1 / facets_of(tile);
  for_facets(tile, [&](const Slope& slope) {
    const Slope unit = unit_slope(slopes, slope);
    const double radius = shape.share_within(std::hypot(unit.x, unit.y)) * static_cast<double>(rings);
    const double turn = (std::atan2(unit.y, unit.x) / (2 * std::numbers::pi) + 0.5) * static_cast<double>(sectors);
    const std::size_t ring = std::min(static_cast<std::size_t>(radius), rings - 1);
    share[ring * sectors + std::min(static_cast<std::size_t>(turn), sectors - 1)] += one;
  });
  return share;
}

} // namespace

SlopeStatistics measure_slopes(const Surface& surface, std::span<const Tile> tiles) {
  const UnitSlopes& shape = std::visit([](const auto& s) -> const UnitSlopes& { return s.unit_slopes(); }, surface);
  const auto asked = std::visit([](const auto& s) { return s.asked(); }, surface);
  SlopeStatistics out;
  out.slopes = shape.has_variance ? from_moments(tiles) : from_medians(tiles);
  const SlopeMap reference = asked.value_or(out.slopes);
  if (!(reference.alpha_x > 0 && reference.alpha_y > 0)) return out; // ruled: its slopes have no density
  std::vector<std::vector<double>> of_tile(tiles.size());
  tbb::parallel_for(std::size_t{0}, tiles.size(),
                    [&](std::size_t k) { of_tile[k] = histogram_of(tiles[k], shape, reference); });
  const auto n = static_cast<double>(tiles.size());
  constexpr double p = 1.0 / bins;
  double variance = 0, miss2 = 0;
  out.distance = out.expected_distance = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    double mean = 0, squares = 0;
    for (std::size_t k = 0; k < tiles.size(); ++k) mean += tiles[k].weight * of_tile[k][bin] / n;
    for (std::size_t k = 0; k < tiles.size(); ++k) squares += std::pow(tiles[k].weight * (of_tile[k][bin] - mean), 2);
    const double of_mean = squares / (n - 1) / n;
    variance += of_mean;
    miss2 += (mean - p) * (mean - p);
    out.distance += std::fabs(mean - p) / 2;
    out.expected_distance += std::sqrt(of_mean / (2 * std::numbers::pi));
  }
  out.independent = static_cast<double>(bins) * p * (1 - p) / variance;
  out.chi2 = out.independent * miss2 / p;
  return out;
}

} // namespace brdfplot::simulation
