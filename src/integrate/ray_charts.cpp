#include "integrate/ray_charts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace brdfplot {

namespace {

constexpr double shortest = 0x1p-14; ///< r below which all rays are alike: they see 1e-9 of the mass

/// A map of [0, 1] to itself and its derivative, which is 0 at the ends where points are to crowd: what is like a
/// root there becomes smooth.
struct Place {
  double at, slope;
};
Place placed(double x, bool crowd_at_0, bool crowd_at_1) {
  if (crowd_at_0 && crowd_at_1) return {x * x * (3 - 2 * x), 6 * x * (1 - x)};
  if (crowd_at_0) return {x * x, 2 * x};
  if (crowd_at_1) return {1 - (1 - x) * (1 - x), 2 * (1 - x)};
  return {x, 1};
}

bool is_like(const CutRays::Ends& one, const CutRays::Ends& other) {
  return std::ranges::equal(one, other, {}, &CutRays::End::crossed, &CutRays::End::crossed);
}

} // namespace

std::vector<Rectangle> RayCharts::rectangles() {
  using std::numbers::pi;
  std::vector<double> cuts = {0, pi / 2, pi};
  if (!symmetric_) {
    cuts.insert(cuts.end(), {-pi, -pi / 2});
    if (kink_in_plane_ && frame_.centred()) {
      const double plane = frame_.plane_of_incidence();
      cuts.insert(cuts.end(), {plane, plane > 0 ? plane - pi : plane + pi});
    }
  }
  std::ranges::sort(cuts);
  sectors_.clear();
  std::vector<Rectangle> all;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) add_sectors(cuts[k], cuts[k + 1], all);
  overlooked_.clear();
  return all;
}

void RayCharts::operator()(std::size_t chart, std::span<const double> x, std::span<const double> psi,
                           ChartPoints& points) {
  const std::size_t part = chart % most_parts;
  const Sector& sector = sectors_[chart / most_parts];
  const double copies = symmetric_ ? 2 : 1;
  for (std::size_t first = 0; first < x.size();) { // ray by ray
    const double azimuth = psi[first];
    const Ends& ends = ends_in_sector(sector, azimuth);
    const End& begin = ends[part];
    const End& end = ends[part + 1];
    const bool last = part + 2 == ends.size();
    // Towards the horizon shadowing changes within an angle of the order of the roughness: points crowd there.
    const bool from_horizon = part == 0 && begin.z > 0;
    const bool crowd_at_begin = from_horizon || rays_.is_root(begin), crowd_at_end = last || rays_.is_root(end);
    const double length = end.z - begin.z;
    const double cos_psi = std::cos(azimuth), sin_psi = std::sin(azimuth);
    std::size_t k = first;
    for (; k < x.size() && psi[k] == azimuth; ++k) {
      const Place place = placed(x[k], crowd_at_begin, crowd_at_end);
      const double z = begin.z + length * place.at;
      const double dz = length * place.slope;
      const double r = CutRays::spread * z / (1 - z);
      points.u1[k] = r * cos_psi;
      points.u2[k] = r * sin_psi;
      points.area[k] = copies * r * dz * CutRays::spread / ((1 - z) * (1 - z));
    }
    first = k;
  }
}

/// What makes a sector: which switches are crossed, and how far out, by steps. The latter because an end that
/// moves through the bulk of the distribution or its tail does so within a few degrees, or a small part of one, on a
/// smooth or an anisotropic surface or at grazing angles, and a rule whose nodes miss these sees nothing.
std::vector<std::size_t> RayCharts::crossed(double psi) {
  std::vector<std::size_t> all;
  for (const End& end : rays_.at(psi)) {
    all.push_back(end.crossed);
    const double r = CutRays::spread * end.z / (1 - end.z);
    std::size_t distance = end.z == 1 ? 1 : 0; // endless rays begin with a kink
    for (double limit = shortest; limit <= 1024; limit *= limit < 4 ? 4 : 16)
      distance += static_cast<std::size_t>(r > limit);
    all.push_back(distance);
  }
  return all;
}

/// Cuts [from, to] into sectors, found by bisection between probes that differ.
void RayCharts::add_sectors(double from, double to, std::vector<Rectangle>& all) {
  std::vector<double> probes = {from + 1e-10 * (to - from)}; // crossings may appear right at an edge
  constexpr int count = 48;
  for (int k = 0; k < count; ++k) probes.push_back(from + (to - from) * (k + 0.5) / count);
  probes.push_back(to - 1e-10 * (to - from));
  const auto known = [&](double psi) { return psi > probes.front() && psi < to - 1e-10 * (to - from); };
  std::ranges::copy_if(overlooked_, std::back_inserter(probes), known);
  std::ranges::sort(probes);
  double begin = from;
  double low = probes.front();
  auto below = crossed(low);
  const auto add = [&](double end, double last) {
    const std::size_t parts = below.size() / 2 - 1;
    for (std::size_t part = 0; part < parts; ++part)
      all.push_back({0, 1, begin, end, sectors_.size() * most_parts + part});
    const Ends middle = rays_.at(0.5 * (begin + end)), beside = rays_.at(last);
    sectors_.push_back({begin, end, is_like(middle, beside) ? middle : beside});
    begin = end;
  };
  for (const double probe : probes) {
    while (crossed(probe) != below) {
      double high = probe;
      while (high - low > 1e-13) {
        const double middle = 0.5 * (low + high);
        (crossed(middle) == below ? low : high) = middle;
      }
      add(high, low);
      low = high;
      below = crossed(high);
    }
    low = probe;
  }
  add(to, low);
}

/// The ends of a ray, as many as a sector has parts. Beside a sector's edge, which is known to rounding only, and
/// where a narrow sector was overlooked, rays cross other switches: then those ends count that are the sector's, and
/// what is missing is put where typical rays have it, so that each part is nearly the same from ray to ray. (Were
/// parts counted from the centre, one would take from the next where a crossing comes in between; these are
/// integrated by rules of their own, of which one might see it and the other not.)
const CutRays::Ends& RayCharts::ends_in_sector(const Sector& sector, double psi) {
  const Ends& own = rays_.at(psi);
  const Ends& typical = sector.typical;
  if (is_like(own, typical)) return own;
  const double beside = 1e-9 * (sector.end - sector.begin);
  if (psi > sector.begin + beside && psi < sector.end - beside) overlooked_.push_back(psi);
  matched_ = {own.front()};
  const double scale = own.back().z / typical.back().z;
  for (std::size_t k = 1; k + 1 < typical.size(); ++k) {
    const double expected = std::clamp(scale * typical[k].z, matched_.back().z, own.back().z);
    End nearest{expected, typical[k].crossed};
    double distance = infinity;
    for (const End& end : own) {
      if (end.crossed != typical[k].crossed || end.z < matched_.back().z - CutRays::same_place * own.back().z) continue;
      if (std::fabs(end.z - expected) < distance) nearest = end;
      distance = std::min(distance, std::fabs(end.z - expected));
    }
    matched_.push_back(nearest);
  }
  matched_.push_back(own.back());
  return matched_;
}

} // namespace brdfplot
