#include "choice/advise/images/errors.hpp"

#include <algorithm>

namespace brdfplot::choice {

double luminance(const Rgb& rgb) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

namespace {

struct Part {
  double error, share;
  std::size_t place;
};

/// The mean error over the worst parts that make up `share`.
double mean_of_worst(const std::vector<Part>& descending, double share) {
  double sum = 0, rest = share;
  for (const Part& part : descending) {
    const double taken = std::min(part.share, rest);
    sum += taken * part.error;
    rest -= taken;
    if (!(rest > 0)) break;
  }
  return sum / share;
}

/// The error that a share of the area exceeds.
double exceeded_by(const std::vector<Part>& descending, double share) {
  double sum = 0;
  for (const Part& part : descending)
    if ((sum += part.share) > share) return part.error;
  return descending.empty() ? 0 : descending.back().error;
}

} // namespace

PictureErrors compare(const Picture& reference, const Picture& other, const Places& places, Metric metric,
                      double exposure) {
  const std::size_t n = places.at.size();
  std::vector<Part> parts;
  double lit = 0, light = 0, other_light = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Rgb a = colour_at(reference, n, k), b = colour_at(other, n, k);
    if (!(std::max({a[0], a[1], a[2]}) > 0)) continue;
    parts.push_back({difference(metric, a, b, exposure), places.share[k], k});
    lit += places.share[k];
    light += places.share[k] * luminance(a);
    other_light += places.share[k] * luminance(b);
  }
  if (parts.empty()) return {};
  std::ranges::stable_sort(parts, [](const Part& a, const Part& b) { return a.error > b.error; });
  return {exceeded_by(parts, 0.05 * lit), mean_of_worst(parts, 0.01 * lit), other_light / light - 1,
          places.at[parts[0].place]};
}

} // namespace brdfplot::choice
