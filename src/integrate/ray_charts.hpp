/// \file
/// Charts of the plane of scaled slopes: parts of rays between the places where an integrand is not smooth.
#pragma once

#include "integrate/charts.hpp"
#include "integrate/cut_rays.hpp"

#include <span>
#include <vector>

namespace brdfplot {

/// One chart is one part of the rays of a sector. A sector is a range of angles in which all rays cross the same
/// switches in the same order and in like places; within one, the ends of the parts are smooth in psi.
class RayCharts {
public:
  /// `symmetric`: half the plane stands for both. `kink_in_plane_of_incidence`: the azimuths of the light that are
  /// equal and opposite to the viewer's are edges of sectors too.
  RayCharts(const SlopeFrame& frame, const std::vector<Switch>& switches, CutRays::Reach reach, bool symmetric,
            bool kink_in_plane_of_incidence)
      : frame_(frame), rays_(frame, switches, std::move(reach)), symmetric_(symmetric),
        kink_in_plane_(kink_in_plane_of_incidence) {}

  /// All of the plane, in x across a part and in y = psi.
  std::vector<Rectangle> rectangles();
  void operator()(std::size_t chart, std::span<const double> x, std::span<const double> psi, ChartPoints& points);

private:
  using End = CutRays::End;
  using Ends = CutRays::Ends;
  static constexpr std::size_t most_parts = 1024; ///< of a ray; charts are numbered sector * most_parts + part

  std::vector<std::size_t> crossed(double psi);
  void add_sectors(double from, double to, std::vector<Rectangle>& all);
  const Ends& ends_in_sector(const Ends& typical, double psi);

  const SlopeFrame& frame_;
  CutRays rays_;
  bool symmetric_;
  bool kink_in_plane_;
  std::vector<Ends> sectors_; ///< the ends of a typical ray of each
  Ends matched_;
};

} // namespace brdfplot
