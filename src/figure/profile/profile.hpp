/// \file
/// A microsurface in profile: its facets where a plane of incidence cuts it, and what of them a direction in that plane
/// sees. A ray in the plane does not leave it, so that masking of the cut is masking of the surface.
///
/// Directions are signed angles theta from the geometric normal, positive to the right: (sin theta, cos theta).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace brdfplot::plot {

/// A piece of a profile from its left to its right end.
struct Segment {
  double x0 = 0, h0 = 0;
  double x1 = 0, h1 = 0;

  /// The part between two fractions of it.
  [[nodiscard]] Segment part(double from, double to) const {
    const double dx = x1 - x0, dh = h1 - h0;
    return {x0 + from * dx, h0 + from * dh, x0 + to * dx, h0 + to * dh};
  }
};

/// From fraction to fraction of a segment; empty where from >= to.
struct Span {
  double from = 0, to = 0;
  [[nodiscard]] double length() const { return to > from ? to - from : 0; }
};

/// What Smith's model knows of facets that are independent: how high they are, and a number that settles their fate.
struct IndependentFacets {
  double alpha = 1;           ///< of the Gaussian slopes
  double mean = 0;            ///< slope of the mesosurface
  std::vector<double> below;  ///< share of the heights below each facet's, C1(h)
  std::vector<double> viewer; ///< uniform in (0, 1)
  std::vector<double> light;
};

/// One period of a surface, continued periodically: after `period` along x it has risen by `rise`. Facets are joined,
/// or
/// (`independent`) apart.
struct Profile {
  std::vector<Segment> facets; ///< by x
  double period = 0;
  double rise = 0;
  std::optional<IndependentFacets> independent{};

  /// A facet of any period: index k + n facets.size() is facet k, n periods on.
  [[nodiscard]] Segment facet(std::ptrdiff_t index) const;
  [[nodiscard]] std::size_t base(std::ptrdiff_t index) const;
};

/// Heights at x = 0, 1, 2, ..., joined by facets.
Profile joined(const std::vector<double>& heights);

/// A stretch along x and then a vertical shear by a slope (Heitz 2014, sections 5.1 and 5.5), of surfaces and
/// directions alike. stretch > 0.
struct Distortion {
  double stretch = 1;
  double shear = 0;

  [[nodiscard]] Segment of(const Segment& s) const;
  [[nodiscard]] Profile of(Profile profile) const;
  [[nodiscard]] double of(double theta) const;
};

/// The area that a segment projects towards theta, signed: positive where it faces theta.
double projected_area(const Segment& segment, double theta);

/// The same of the mesosurface below a period.
double projected_mesosurface(const Profile& profile, double theta);

enum class Watcher { viewer, light };

/// Which part of each facet is visible from theta. Exact for a continuous surface: a point is visible if none that lies
/// in front of it is higher across the direction, a running maximum. Independent facets are seen whole or not at all:
/// those that face theta with Smith's probability for their height, C1(h)^Lambda (Smith 1967; Heitz et al. 2016), for
/// which each facet has one random number per `watcher`.
/// \throws InputError where the mesosurface does not face theta.
std::vector<Span> visible(const Profile& profile, double theta, Watcher watcher = Watcher::viewer);

/// Of the area of the geometric surface, the share over which facets face, and over which they are visible.
struct Shares {
  double facing = 0;
  double seen = 0;

  Shares& operator+=(const Shares& other);
};

/// How much of a profile faces a direction and is visible from it, per area of the geometric surface.
struct Visibility {
  Shares shares;
  double seen_area = 0;   ///< projected area of what is visible
  double mesosurface = 0; ///< projected area of the mesosurface

  Visibility& operator+=(const Visibility& other);
};
Visibility measure(const Profile& profile, double theta);

/// What faces both directions, and is visible from both.
Shares measure(const Profile& profile, double theta_o, double theta_i);

/// Where the ray from a point of facet `index` (at a fraction of it) towards theta meets a joined surface again, if it
/// does.
struct Meeting {
  double x = 0, h = 0;
};
std::optional<Meeting> meeting(const Profile& profile, std::ptrdiff_t index, double fraction, double theta);

} // namespace brdfplot::plot
