#include "figure/profile/profile.hpp"

#include "base/errors.hpp"
#include "base/threads/interrupt.hpp"
#include "microfacet/distributions/beckmann.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdfplot::plot {

namespace {

/// The coordinate across a direction: of two points on one ray towards theta it is the same, and a point is hidden by
/// one in front of it that has a greater one.
struct Across {
  explicit Across(double theta)
      : sine(std::fabs(std::sin(theta))), cosine(std::signbit(theta) ? -std::cos(theta) : std::cos(theta)) {}
  double operator()(double x, double h) const { return h * sine - x * cosine; }

  double sine, cosine; ///< x counts away from the observer
};

/// The facets in the order in which a direction meets them, the nearest to the observer first.
std::size_t from_front(std::size_t k, std::size_t count, double theta) {
  return std::signbit(theta) ? k : count - 1 - k;
}

/// Of joined facets: a running maximum from the front. What is in front of the period is the period before it.
std::vector<Span> visible_joined(const Profile& profile, double theta) {
  const Across across(theta);
  const bool left = std::signbit(theta);
  const std::size_t count = profile.facets.size();
  double highest = -std::numeric_limits<double>::infinity();
  for (const Segment& s : profile.facets) highest = std::max({highest, across(s.x0, s.h0), across(s.x1, s.h1)});
  highest -= projected_mesosurface(profile, theta);
  std::vector<Span> out(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t at = from_front(k, count, theta);
    const Segment& s = profile.facets[at];
    const double q0 = across(s.x0, s.h0), q1 = across(s.x1, s.h1);
    const double front = left ? q0 : q1, back = left ? q1 : q0;
    if (back > highest && back > front) {
      const double seen = front >= highest ? 1 : (back - highest) / (back - front);
      out[at] = left ? Span{1 - seen, 1} : Span{0, seen};
    }
    highest = std::max({highest, front, back});
  }
  return out;
}

/// Smith's probability that a facet which faces theta is visible, for its share of heights below it.
double chance_of_sight(const IndependentFacets& facets, double below, double theta) {
  const double s = facets.alpha * std::fabs(std::sin(theta));
  const double c = std::cos(theta) - facets.mean * std::sin(theta);
  return s > 0 ? std::pow(below, s * BeckmannShape::a_lambda(c / s) / c) : 1;
}

std::vector<Span> visible_independent(const Profile& profile, double theta, Watcher watcher) {
  const IndependentFacets& facets = *profile.independent;
  const auto& chance = watcher == Watcher::viewer ? facets.viewer : facets.light;
  std::vector<Span> out(profile.facets.size());
  for (std::size_t k = 0; k < out.size(); ++k)
    if (projected_area(profile.facets[k], theta) > 0 && chance[k] < chance_of_sight(facets, facets.below[k], theta))
      out[k] = {0, 1};
  return out;
}

/// The width below all facets: where they are independent there are gaps between them, which do not count.
double width_of(const Profile& profile) {
  double width = 0;
  for (const Segment& s : profile.facets) width += s.x1 - s.x0;
  return width;
}

} // namespace

std::size_t Profile::base(std::ptrdiff_t index) const {
  const auto count = static_cast<std::ptrdiff_t>(facets.size());
  return static_cast<std::size_t>((index % count + count) % count);
}

Segment Profile::facet(std::ptrdiff_t index) const {
  const std::size_t at = base(index);
  const auto count = static_cast<std::ptrdiff_t>(facets.size());
  const std::ptrdiff_t whole = (index - static_cast<std::ptrdiff_t>(at)) / count;
  const auto periods = static_cast<double>(whole);
  const Segment& s = facets[at];
  return {s.x0 + periods * period, s.h0 + periods * rise, s.x1 + periods * period, s.h1 + periods * rise};
}

Profile joined(const std::vector<double>& heights) {
  Profile out;
  const std::size_t count = heights.size();
  for (std::size_t k = 0; k < count; ++k) {
    const auto x = static_cast<double>(k);
    out.facets.push_back({x, heights[k], x + 1, heights[k + 1 < count ? k + 1 : 0]});
  }
  out.period = static_cast<double>(count);
  return out;
}

Segment Distortion::of(const Segment& s) const {
  const double x0 = stretch * s.x0, x1 = stretch * s.x1;
  return {x0, s.h0 + shear * x0, x1, s.h1 + shear * x1};
}

Profile Distortion::of(Profile profile) const {
  for (Segment& s : profile.facets) s = of(s);
  profile.period *= stretch;
  profile.rise += shear * profile.period;
  if (profile.independent) {
    profile.independent->alpha /= stretch;
    profile.independent->mean = profile.independent->mean / stretch + shear;
  }
  return profile;
}

double Distortion::of(double theta) const {
  const double x = stretch * std::sin(theta);
  return std::atan2(x, std::cos(theta) + shear * x);
}

double projected_area(const Segment& segment, double theta) {
  return (segment.x1 - segment.x0) * std::cos(theta) - (segment.h1 - segment.h0) * std::sin(theta);
}

double projected_mesosurface(const Profile& profile, double theta) {
  return projected_area({0, 0, profile.period, profile.rise}, theta);
}

std::vector<Span> visible(const Profile& profile, double theta, Watcher watcher) {
  if (!(projected_mesosurface(profile, theta) > 0))
    throw InputError("", "the direction is below the horizon of the surface");
  return profile.independent ? visible_independent(profile, theta, watcher) : visible_joined(profile, theta);
}

Shares& Shares::operator+=(const Shares& other) {
  facing += other.facing;
  seen += other.seen;
  return *this;
}

Visibility& Visibility::operator+=(const Visibility& other) {
  shares += other.shares;
  seen_area += other.seen_area;
  mesosurface += other.mesosurface;
  return *this;
}

Visibility measure(const Profile& profile, double theta) {
  Visibility out;
  const std::vector<Span> spans = visible(profile, theta);
  const double width = width_of(profile);
  for (std::size_t k = 0; k < spans.size(); ++k) {
    const Segment& s = profile.facets[k];
    const double share = (s.x1 - s.x0) / width, area = projected_area(s, theta) / width;
    if (area > 0) out.shares.facing += share;
    out.shares.seen += spans[k].length() * share;
    out.seen_area += spans[k].length() * area;
  }
  out.mesosurface = projected_mesosurface(profile, theta) / profile.period;
  return out;
}

Shares measure(const Profile& profile, double theta_o, double theta_i) {
  Shares out;
  const std::vector<Span> viewed = visible(profile, theta_o), lit = visible(profile, theta_i, Watcher::light);
  const double width = width_of(profile);
  for (std::size_t k = 0; k < viewed.size(); ++k) {
    const Segment& s = profile.facets[k];
    const double share = (s.x1 - s.x0) / width;
    if (projected_area(s, theta_o) > 0 && projected_area(s, theta_i) > 0) out.facing += share;
    const Span both{std::max(viewed[k].from, lit[k].from), std::min(viewed[k].to, lit[k].to)};
    out.seen += both.length() * share;
  }
  return out;
}

std::optional<Meeting> meeting(const Profile& profile, std::ptrdiff_t index, double fraction, double theta) {
  const Across across(theta);
  const bool left = std::signbit(theta);
  const Segment start = profile.facet(index).part(fraction, 1);
  const double level = across(start.x0, start.h0);
  double highest = level;
  for (const Segment& s : profile.facets) highest = std::max({highest, across(s.x0, s.h0), across(s.x1, s.h1)});
  // In front of these periods everything is lower than the ray.
  const double drop = projected_mesosurface(profile, theta);
  const Segment here = profile.facet(static_cast<std::ptrdiff_t>(profile.base(index)));
  const double shift = across(start.x0, start.h0) - across(here.part(fraction, 1).x0, here.part(fraction, 1).h0);
  // Near the horizon more than an integer holds.
  const double periods = std::ceil(std::max(highest + shift - level, 0.0) / drop) + 1;
  const double most = periods * static_cast<double>(profile.facets.size());
  for (std::ptrdiff_t k = 1; static_cast<double>(k) <= most; ++k) {
    if (k % 1024 == 0) throw_if_interrupted();
    const Segment s = profile.facet(left ? index - k : index + k);
    const double near = left ? across(s.x1, s.h1) : across(s.x0, s.h0);
    const double far = left ? across(s.x0, s.h0) : across(s.x1, s.h1);
    if (!(far > level)) continue;
    const double t = near < level ? (level - near) / (far - near) : 0;
    const Segment hit = left ? s.part(1 - t, 1) : s.part(t, 1);
    return Meeting{hit.x0, hit.h0};
  }
  return std::nullopt;
}

} // namespace brdfplot::plot
