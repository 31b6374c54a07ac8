/// \file
/// G1 on average and by normal.

#include "brdf/blocks/surface_quantities.hpp"
#include "simulation/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace brdfplot::simulation {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Smith's G1 of the distribution that the surface is meant to have.
double smith_g1(const std::optional<Microsurface>& smith, const Direction& omega) {
  return smith ? evaluate(*smith, Quantity::g1, omega, std::nullopt, std::nullopt) : nan;
}

class G1 : public Measure {
public:
  G1(const MeasureDescription& description, std::optional<Microsurface> smith)
      : id_(description.id), views_(views(description)), smith_(std::move(smith)) {}
  std::size_t tasks() const override { return views_.size(); }
  std::size_t width() const override { return width_; }
  bool fixed_by_surface() const override { return true; }

  void sample(std::size_t task, const Tile& tile, double count, Random& random, std::span<double> sums,
              TraceCounts& counts) const override {
    const Direction omega = views_[task].omega;
    const Direction d = tile.field->to_mesh(omega);
    Facing facing;
    double front = 0, seen = 0, front_area = 0, seen_area = 0;
    const auto all = for_random_points(tile, count, random, [&](std::span<const SurfacePoint> points) {
      facing.take(points, d);
      facing.trace(*tile.tracer, d, counts);
      for (std::size_t k = 0; k < facing.points.size(); ++k) {
        const double area = projected_area(facing.points[k].slope, d);
        front += 1;
        front_area += area;
        if (facing.visible[k] == 0) continue;
        seen += 1;
        seen_area += area;
      }
    });
    const double scale = tile.weight / static_cast<double>(all);
    const double values[] = {scale * front, scale * seen, scale * front_area, scale * seen_area, tile.weight * d.z};
    for (std::size_t k = 0; k < width_; ++k) sums[k] += values[k];
  }

  Table tabulate(const std::vector<Tally>& tallies, bool complete) const override {
    Table table{id_,
                "g1",
                {"theta_o", "phi_o", "g1", "g1_stderr", "g1_by_area", "g1_by_area_stderr", "projected_area",
                 "projected_area_stderr", "smith"},
                {}};
    for (std::size_t task = 0; task < tallies.size(); ++task) {
      const View& view = views_[task];
      std::vector<double> row = {view.theta, view.phi};
      append(row, tallies[task].estimate({1, 0}, Tally::ratio));
      append(row, tallies[task].estimate({3, 2}, Tally::ratio));
      // A whole period shows its own area whatever its shape: only the rays are random.
      append(row, complete ? tallies[task].estimate_of_rays({3, 4}, Tally::ratio)
                           : tallies[task].estimate({3, 4}, Tally::ratio));
      row.push_back(smith_g1(smith_, view.omega));
      table.rows.push_back(std::move(row));
    }
    return table;
  }

private:
  static constexpr std::size_t width_ = 5;
  std::string id_;
  std::vector<View> views_;
  std::optional<Microsurface> smith_;
};

/// Bins of the slope along the azimuth of omega_o (the direction in which the facet rises towards the viewer counts
/// negative: it faces away), over the horizontal span in which all but a few facets lie.
class G1ByNormal : public Measure {
public:
  G1ByNormal(const MeasureDescription& description, std::optional<Microsurface> smith)
      : id_(description.id), views_(views(description)), smith_(std::move(smith)),
        bins_(static_cast<std::size_t>(description.bins)) {}
  std::size_t tasks() const override { return views_.size(); }
  std::size_t width() const override { return 2 * bins_ + 1; }

  void sample(std::size_t task, const Tile& tile, double count, Random& random, std::span<double> sums,
              TraceCounts& counts) const override {
    const View& view = views_[task];
    const Direction d = tile.field->to_mesh(view.omega);
    Facing facing;
    const auto all = for_random_points(tile, count, random, [&](std::span<const SurfacePoint> points) {
      facing.take(points, d);
      facing.trace(*tile.tracer, d, counts);
      for (std::size_t k = 0; k < facing.points.size(); ++k) {
        const Slope slope = tile.field->to_world(facing.points[k].slope);
        const double tilt = std::atan(-(slope.x * std::cos(view.phi) + slope.y * std::sin(view.phi)));
        const std::size_t bin = bin_of(tilt);
        sums[2 * bin] += tile.weight / count;
        if (facing.visible[k] != 0) sums[2 * bin + 1] += tile.weight / count;
      }
    });
    sums[2 * bins_] += tile.weight * static_cast<double>(all) / count;
  }

  Table tabulate(const std::vector<Tally>& tallies, bool /*complete*/) const override {
    Table table{
        id_, "g1_by_normal", {"theta_o", "phi_o", "theta_m", "share", "share_stderr", "g1", "g1_stderr", "smith"}, {}};
    for (std::size_t task = 0; task < tallies.size(); ++task)
      for (std::size_t bin = 0; bin < bins_; ++bin) {
        const Measured share = tallies[task].estimate({2 * bin, 2 * bins_}, Tally::ratio);
        if (!(share.value > 0)) continue;
        std::vector<double> row = {views_[task].theta, views_[task].phi, centre_of(bin)};
        append(row, share);
        append(row, tallies[task].estimate({2 * bin + 1, 2 * bin}, Tally::ratio));
        row.push_back(smith_g1(smith_, views_[task].omega));
        table.rows.push_back(std::move(row));
      }
    return table;
  }

private:
  static constexpr double half_pi = std::numbers::pi / 2;
  std::size_t bin_of(double tilt) const {
    const double place = (tilt / std::numbers::pi + 0.5) * static_cast<double>(bins_);
    return std::min(static_cast<std::size_t>(place), bins_ - 1);
  }
  double centre_of(std::size_t bin) const {
    return std::numbers::pi * (static_cast<double>(bin) + 0.5) / static_cast<double>(bins_) - half_pi;
  }

  std::string id_;
  std::vector<View> views_;
  std::optional<Microsurface> smith_;
  std::size_t bins_;
};

} // namespace

MeasureType g1_measure() {
  return measure_type<G1>(
      {.type = "g1",
       .doc = "masking: the share of the facets facing omega_o that it sees, by plane and by projected area",
       .source = "Heitz 2014, Eqs. 11-14"});
}

MeasureType g1_by_normal_measure() {
  return measure_type<G1ByNormal>({.type = "g1_by_normal",
                                   .doc = "masking by the inclination of the facet towards the viewer",
                                   .source = "Heitz 2014, Eq. 40",
                                   .keys = {"bins"},
                                   .bins = 36});
}

} // namespace brdfplot::simulation
