#include "figure/profile/drawing.hpp"

#include "figure/profile/paths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace brdfplot::plot {

namespace {

using Line = Sketch::Line;

/// What becomes of a part of the surface, and how it is drawn.
struct Sight {
  const char* label;
  int style;
};
constexpr std::array<Sight, 6> sights = {{{"microsurface", 6},
                                          {"visible", 0},
                                          {"visible and lit", 0},
                                          {"visible, shadowed", 2},
                                          {"masked", 1},
                                          {"facing away", 6}}};
enum SightIndex : std::size_t { plain, seen, seen_lit, seen_shadowed, masked, away };

/// The part of a profile that is drawn, distorted, with its corner at the origin.
class Drawing {
public:
  Drawing(const ProfileDescription& description, const Profile& profile)
      : description_(description), distortion_{description.stretch, description.shear},
        profile_(distortion_.of(profile)) {
    if (description.omega_o) {
      theta_o_ = distortion_.of(*description.omega_o);
      viewed_ = visible(profile_, theta_o_);
    }
    if (description.omega_i) {
      theta_i_ = distortion_.of(*description.omega_i);
      lit_ = visible(profile_, theta_i_, Watcher::light);
    }
    const double x = distortion_.stretch * description.from;
    offset_ = {x, distortion_.shear * x};
    for (int k = 0; k < description.cells; ++k) facets_.push_back(placed(profile_.facet(description.from + k)));
    width_ = distortion_.stretch * description.cells;
    window_ = {0, facets_.front().h0, width_, facets_.front().h0};
    for (const Segment& s : facets_) {
      window_.y0 = std::min({window_.y0, s.h0, s.h1});
      window_.y1 = std::max({window_.y1, s.h0, s.h1});
    }
  }

  std::vector<Series> series() const;
  Sketch sketch() const;

private:
  Segment placed(Segment s) const { return {s.x0 - offset_.x, s.h0 - offset_.h, s.x1 - offset_.x, s.h1 - offset_.h}; }
  std::size_t base(std::size_t k) const { return profile_.base(description_.from + static_cast<std::ptrdiff_t>(k)); }
  SightIndex sight(std::size_t k, double fraction) const;
  std::vector<double> borders(std::size_t k) const;
  /// Facet and fraction at a fraction of the width.
  std::pair<std::size_t, double> place(double fraction) const {
    const double at = fraction * static_cast<double>(facets_.size());
    const auto k = std::min(static_cast<std::size_t>(at), facets_.size() - 1);
    return {k, at - static_cast<double>(k)};
  }
  bool is_seen(std::size_t k, double fraction) const {
    return viewed_.empty() || (fraction >= viewed_[base(k)].from && fraction < viewed_[base(k)].to);
  }
  Line to_border(double x, double h, double ceiling, double theta) const;
  void add_rays(Sketch& sketch) const;
  void add_paths(Sketch& sketch) const;
  void add_projection(Sketch& sketch) const;
  void add_arrows(Sketch& sketch) const;
  double headroom() const { return 0.11 * width_; }

  const ProfileDescription& description_;
  Distortion distortion_;
  Profile profile_;
  double theta_o_ = 0, theta_i_ = 0;
  std::vector<Span> viewed_, lit_; ///< of the facets of a period; none without the direction
  Meeting offset_;
  std::vector<Segment> facets_; ///< those that are drawn
  double width_ = 0;
  Line window_{};
};

SightIndex Drawing::sight(std::size_t k, double fraction) const {
  if (viewed_.empty()) return plain;
  if (projected_area(facets_[k], theta_o_) <= 0) return away;
  if (!is_seen(k, fraction)) return masked;
  if (lit_.empty()) return seen;
  const Span& light = lit_[base(k)];
  return fraction >= light.from && fraction < light.to ? seen_lit : seen_shadowed;
}

/// Where sight may change within a facet, its ends included.
std::vector<double> Drawing::borders(std::size_t k) const {
  std::vector<double> out = {0, 1};
  for (const auto* spans : {&viewed_, &lit_})
    if (!spans->empty() && (*spans)[base(k)].length() > 0)
      out.insert(out.end(), {(*spans)[base(k)].from, (*spans)[base(k)].to});
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<Series> Drawing::series() const {
  std::array<Series, sights.size()> all;
  constexpr std::size_t none = sights.size();
  std::size_t last = none;
  for (std::size_t k = 0; k < facets_.size(); ++k) {
    if (profile_.independent) last = none;
    const auto at = borders(k);
    for (std::size_t b = 1; b < at.size(); ++b) {
      const SightIndex now = sight(k, (at[b - 1] + at[b]) / 2);
      const Segment part = facets_[k].part(at[b - 1], at[b]);
      Series& series = all[now];
      if (last != now) {
        if (!series.x.empty()) {
          series.x.push_back(series.x.back());
          series.y.push_back(std::numeric_limits<double>::quiet_NaN());
        }
        series.x.push_back(rounded_coordinate(part.x0));
        series.y.push_back(rounded_coordinate(part.h0));
      }
      series.x.push_back(rounded_coordinate(part.x1));
      series.y.push_back(rounded_coordinate(part.h1));
      last = now;
    }
  }
  std::vector<Series> out;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].x.empty()) continue;
    all[k].label = sights[k].label;
    all[k].style = sights[k].style;
    out.push_back(std::move(all[k]));
  }
  return out;
}

/// From a point towards theta to the ceiling, to the side of the window or, downwards, to its lower edge.
Line Drawing::to_border(double x, double h, double ceiling, double theta) const {
  const double sine = std::sin(theta), cosine = std::cos(theta);
  double length = ((cosine > 0 ? ceiling : window_.y0) - h) / cosine;
  if (sine > 0) length = std::min(length, (width_ - x) / sine);
  if (sine < 0) length = std::min(length, -x / sine);
  length = std::max(length, 0.0);
  return {x, h, x + length * sine, h + length * cosine};
}

void Drawing::add_rays(Sketch& sketch) const {
  for (int i = 0; i < description_.rays; ++i) {
    const auto [k, fraction] = place((i + 0.5) / description_.rays);
    if (projected_area(facets_[k], theta_o_) <= 0) continue;
    const Segment from = facets_[k].part(fraction, 1);
    const auto index = static_cast<std::ptrdiff_t>(k) + description_.from;
    const auto met = is_seen(k, fraction) ? std::nullopt : meeting(profile_, index, fraction, theta_o_);
    if (met) {
      const double x = met->x - offset_.x, h = met->h - offset_.h;
      // Beyond the window a ray would stop at what is not drawn.
      if (x >= 0 && x <= width_) sketch.stopped_rays.push_back({from.x0, from.h0, x, h});
    } else {
      sketch.rays.push_back(to_border(from.x0, from.h0, window_.y1 + headroom(), theta_o_));
    }
  }
}

/// Light from omega_o to points that are visible from there, and on from facet to facet.
void Drawing::add_paths(Sketch& sketch) const {
  const double ceiling = window_.y1 + headroom();
  for (int i = 0; i < description_.paths; ++i) {
    const auto [k, fraction] = place((i + 0.5) / description_.paths);
    if (projected_area(facets_[k], theta_o_) <= 0 || !is_seen(k, fraction)) continue;
    const MirrorPath path = mirror_path(facets_, k, fraction, theta_o_, description_.bounces);
    auto& lines = path.points.size() == 1 && !path.ended ? sketch.once : sketch.more_often;
    const Meeting& first = path.points.front();
    lines.push_back(to_border(first.x, first.h, ceiling, theta_o_));
    for (std::size_t n = 1; n < path.points.size(); ++n)
      lines.push_back({path.points[n - 1].x, path.points[n - 1].h, path.points[n].x, path.points[n].h});
    if (path.ended) continue;
    const Line last = to_border(path.points.back().x, path.points.back().h, ceiling, path.theta);
    lines.push_back(last);
    sketch.exits.push_back({"", last.x1, last.y1, path.theta});
  }
}

/// The parts that are visible, projected on a line across omega_o: they lie side by side.
void Drawing::add_projection(Sketch& sketch) const {
  const double sine = std::sin(theta_o_), cosine = std::cos(theta_o_);
  std::vector<Line> runs;
  for (std::size_t k = 0; k < facets_.size(); ++k) {
    const Span& span = viewed_[base(k)];
    if (!(span.length() > 0)) continue;
    const Segment part = facets_[k].part(span.from, span.to);
    const bool goes_on = !profile_.independent && !runs.empty() && runs.back().x1 == part.x0;
    if (!goes_on) runs.push_back({part.x0, part.h0, part.x1, part.h1});
    runs.back().x1 = part.x1;
    runs.back().y1 = part.h1;
  }
  double distance = -std::numeric_limits<double>::infinity();
  const double floor = window_.y1 + headroom();
  const auto along = [&](double x, double h) { return x * sine + h * cosine; };
  for (const Line& run : runs)
    for (const auto& [x, h] : {std::pair{run.x0, run.y0}, std::pair{run.x1, run.y1}})
      distance = std::max(distance, along(x, h) + (floor - h) / cosine);
  const auto foot = [&](double x, double h) {
    const double length = distance - along(x, h);
    return Line{x, h, x + length * sine, h + length * cosine};
  };
  for (const Line& run : runs) {
    const Line from = foot(run.x0, run.y0), to = foot(run.x1, run.y1);
    sketch.sight_lines.insert(sketch.sight_lines.end(), {from, to});
    sketch.projection.push_back({from.x1, from.y1, to.x1, to.y1});
  }
}

void Drawing::add_arrows(Sketch& sketch) const {
  const auto normal = [&](std::size_t k) {
    return std::atan2(facets_[k].h0 - facets_[k].h1, facets_[k].x1 - facets_[k].x0);
  };
  for (int i = 0; i < description_.normals; ++i) {
    const auto [k, fraction] = place((i + 0.5) / description_.normals);
    const Segment at = facets_[k].part(fraction, 1);
    sketch.normals.push_back({"", at.x0, at.h0, normal(k)});
  }
  if (description_.arrows.empty()) return;
  // The visible, lit point nearest to the one that is asked: from there no arrow crosses the surface.
  constexpr int steps = 1000;
  double best = description_.point;
  for (int i = 0; i <= 2 * steps; ++i) {
    const int away_by = (i + 1) / 2;
    const double step = static_cast<double>(away_by) / steps;
    const double point = description_.point + (i % 2 == 0 ? step : -step);
    if (point < 0 || point >= 1) continue;
    const auto [k, fraction] = place(point);
    if (!is_seen(k, fraction) || (!lit_.empty() && sight(k, fraction) != seen_lit)) continue;
    best = point;
    break;
  }
  const auto [k, fraction] = place(best);
  const Segment at = facets_[k].part(fraction, 1);
  for (const std::string& name : description_.arrows) {
    if (name == "omega_o") sketch.arrows.push_back({"ω_o", at.x0, at.h0, theta_o_});
    if (name == "omega_i") sketch.arrows.push_back({"ω_i", at.x0, at.h0, theta_i_});
    if (name == "omega_g") sketch.arrows.push_back({"ω_g", at.x0, at.h0, 0});
    if (name == "omega_m") sketch.arrows.push_back({"ω_m", at.x0, at.h0, normal(k)});
  }
}

Sketch Drawing::sketch() const {
  Sketch out;
  out.window = window_;
  if (!profile_.independent)
    for (const Segment& s : facets_) out.surface.push_back({s.x0, s.h0, s.x1, s.h1});
  if (description_.mesosurface) out.mesosurface.push_back({0, 0, width_, distortion_.shear * width_});
  add_rays(out);
  add_paths(out);
  if (description_.projection) add_projection(out);
  add_arrows(out);
  return out;
}

} // namespace

double rounded_coordinate(double value) { return std::round(value * 1e6) / 1e6; }

std::vector<Series> parts_of(const ProfileDescription& description, const Profile& profile) {
  return Drawing(description, profile).series();
}

Sketch sketch_of(const ProfileDescription& description, const Profile& profile) {
  return Drawing(description, profile).sketch();
}

} // namespace brdfplot::plot
