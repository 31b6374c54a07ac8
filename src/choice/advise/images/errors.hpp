/// \file
/// How far a picture of a sphere is from another.
#pragma once

#include "choice/advise/images/metric.hpp"
#include "choice/advise/images/places.hpp"

namespace brdfplot::choice {

/// Radiance towards the viewer: channel c of place k at [c * places + k], three channels.
using Picture = std::vector<double>;

struct PictureErrors {
  double p95 = 0;        ///< the 95th percentile over the lit area
  double worst = 0;      ///< the mean over the worst 1 % of it
  double energy = 0;     ///< relative difference of the light that reaches the viewer (luminance)
  sphere::Place where{}; ///< the worst place

  /// What is held against the tolerance: the worst 1 % may be off by twice as much as the 95th percentile.
  double decisive() const { return p95 > 0.5 * worst ? p95 : 0.5 * worst; }
};

/// Lit is what the reference says. Percentiles are those of the steps of cumulated area.
PictureErrors compare(const Picture& reference, const Picture& other, const Places& places, Metric metric,
                      double exposure);

/// 0.2126 r + 0.7152 g + 0.0722 b (ITU-R BT.709).
double luminance(const Rgb& rgb);

inline Rgb colour_at(const Picture& picture, std::size_t places, std::size_t k) {
  return {picture[k], picture[places + k], picture[2 * places + k]};
}

} // namespace brdfplot::choice
