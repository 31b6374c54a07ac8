#include "figure/profile/paths.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace brdfplot::plot {

namespace {

struct Hit {
  std::size_t facet = 0;
  Meeting at;
};

/// The nearest facet that a ray meets on its upper side, other than the one on which it begins.
std::optional<Hit> nearest(const std::vector<Segment>& facets, std::size_t from, const Meeting& at, double theta) {
  const double dx = std::sin(theta), dh = std::cos(theta);
  std::optional<Hit> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < facets.size(); ++k) {
    if (k == from) continue;
    const Segment& s = facets[k];
    const double ex = s.x1 - s.x0, eh = s.h1 - s.h0;
    const double det = dh * ex - dx * eh; // below 0 where the ray comes from above the facet
    if (!(det < 0)) continue;
    const double along = ((s.h0 - at.h) * ex - (s.x0 - at.x) * eh) / det;
    const double part = (dx * (s.h0 - at.h) - dh * (s.x0 - at.x)) / det;
    if (!(along > 0) || along >= least || part < 0 || part > 1) continue;
    least = along;
    best = Hit{k, {at.x + along * dx, at.h + along * dh}};
  }
  return best;
}

} // namespace

MirrorPath mirror_path(const std::vector<Segment>& facets, std::size_t k, double fraction, double theta, int most) {
  MirrorPath out;
  const Segment start = facets[k].part(fraction, 1);
  Hit hit{k, {start.x0, start.h0}};
  for (int bounce = 1;; ++bounce) {
    const Segment& facet = facets[hit.facet];
    const double normal = std::atan2(facet.h0 - facet.h1, facet.x1 - facet.x0);
    out.points.push_back(hit.at);
    out.theta = 2 * normal - theta;
    const auto next = nearest(facets, hit.facet, hit.at, out.theta);
    if (!next) return out;
    if (bounce == most) {
      out.ended = true;
      return out;
    }
    hit = *next;
    theta = out.theta + std::acos(-1.0); // where it comes from
  }
}

} // namespace brdfplot::plot
