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
  /// Whether rays were asked for, since the last call of rectangles(), that cross other switches than their sector
  /// does: it then holds a narrow one that was overlooked, which the next call of rectangles() cuts out.
  bool has_overlooked() const { return !overlooked_.empty(); }
  void operator()(std::size_t chart, std::span<const double> x, std::span<const double> psi, ChartPoints& points);

private:
  using End = CutRays::End;
  using Ends = CutRays::Ends;
  struct Sector {
    double begin, end; ///< in psi
    Ends typical;      ///< the ends of a typical ray
  };
  static constexpr std::size_t most_parts = 1024; ///< of a ray; charts are numbered sector * most_parts + part

  std::vector<std::size_t> crossed(double psi);
  void add_sectors(double from, double to, std::vector<Rectangle>& all);
  const Ends& ends_in_sector(const Sector& sector, double psi);

  const SlopeFrame& frame_;
  CutRays rays_;
  bool symmetric_;
  bool kink_in_plane_;
  std::vector<Sector> sectors_;
  std::vector<double> overlooked_; ///< psi of rays that are not like their sector's
  Ends matched_;
};

} // namespace brdfplot
