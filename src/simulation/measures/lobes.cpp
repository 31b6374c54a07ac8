/// \file
/// Lobes of the light that mirror facets reflect, and how it is shared among the bounces.

#include "simulation/measures.hpp"
#include "simulation/measures/hemisphere_bins.hpp"
#include "simulation/measures/paths.hpp"

#include <cmath>
#include <numbers>

namespace brdfplot::simulation {

namespace {

/// Paths from every view, whose ends fall into bins: of single scattering, of more, and of all.
class PathMeasure : public Measure {
public:
  explicit PathMeasure(const MeasureDescription& description)
      : id_(description.id), views_(views(description)), bounces_(description.bounces) {}
  std::size_t tasks() const override { return views_.size(); }

protected:
  /// rho cos theta_i of a bin: its share of the paths per solid angle.
  static void append_density(std::vector<double>& row, const Tally& tally, std::size_t column, std::size_t all,
                             double solid_angle) {
    append(row, tally.estimate({column, all}, [solid_angle](std::span<const double> sums) {
      return Tally::ratio(sums) / solid_angle;
    }));
  }

  std::string id_;
  std::vector<View> views_;
  int bounces_;
};

/// The plane of incidence, as a wedge: directions within `half_width` of the plane, in bins of the angle in it.
/// Negative angles are on the side away from the viewer, as in figures of a fixed phi_i = phi_o.
class Lobe : public PathMeasure {
public:
  explicit Lobe(const MeasureDescription& description)
      : PathMeasure(description), bins_(static_cast<std::size_t>(description.bins)),
        sin_half_width_(std::sin(description.half_width)) {}
  std::size_t width() const override { return 2 * bins_ + 1; }

  void sample(std::size_t task, const Tile& tile, double count, Random& random, std::span<double> sums,
              TraceCounts& counts) const override {
    const View& view = views_[task];
    const double cos_phi = std::cos(view.phi), sin_phi = std::sin(view.phi);
    const auto paths = for_paths(tile, count, view.omega, bounces_, random, counts, [&](const PathEnd& end) {
      const double along = cos_phi * end.omega_i.x + sin_phi * end.omega_i.y;
      const double across = cos_phi * end.omega_i.y - sin_phi * end.omega_i.x;
      if (!end.escaped || std::fabs(across) > sin_half_width_ || !(end.omega_i.z > 0)) return;
      const double place = (std::atan2(along, end.omega_i.z) / std::numbers::pi + 0.5) * static_cast<double>(bins_);
      const std::size_t bin = std::min(static_cast<std::size_t>(place), bins_ - 1);
      sums[2 * bin + (end.bounces > 1 ? 1 : 0)] += tile.weight;
    });
    sums[2 * bins_] += tile.weight * static_cast<double>(paths);
  }

  Table tabulate(const std::vector<Tally>& tallies, bool /*complete*/) const override {
    Table table{
        id_, "lobe", {"theta_o", "phi_o", "theta_i", "brdf_cos", "brdf_cos_stderr", "multiple", "multiple_stderr"}, {}};
    // The area of the wedge between two angles: (their difference) int cos b db, b the angle to the plane.
    const double solid_angle = std::numbers::pi / static_cast<double>(bins_) * 2 * sin_half_width_;
    for (std::size_t task = 0; task < tallies.size(); ++task)
      for (std::size_t bin = 0; bin < bins_; ++bin) {
        const double theta = std::numbers::pi * ((static_cast<double>(bin) + 0.5) / static_cast<double>(bins_) - 0.5);
        std::vector<double> row = {views_[task].theta, views_[task].phi, theta};
        append_density(row, tallies[task], 2 * bin, 2 * bins_, solid_angle);
        append_density(row, tallies[task], 2 * bin + 1, 2 * bins_, solid_angle);
        table.rows.push_back(std::move(row));
      }
    return table;
  }

private:
  std::size_t bins_;
  double sin_half_width_;
};

class Hemisphere : public PathMeasure {
public:
  explicit Hemisphere(const MeasureDescription& description)
      : PathMeasure(description), bins_(static_cast<std::size_t>(description.bins)) {}
  std::size_t width() const override { return 2 * bins_.count() + 1; }

  void sample(std::size_t task, const Tile& tile, double count, Random& random, std::span<double> sums,
              TraceCounts& counts) const override {
    const auto paths = for_paths(tile, count, views_[task].omega, bounces_, random, counts, [&](const PathEnd& end) {
      if (end.escaped) sums[2 * bins_.of(end.omega_i) + (end.bounces > 1 ? 1 : 0)] += tile.weight;
    });
    sums[2 * bins_.count()] += tile.weight * static_cast<double>(paths);
  }

  Table tabulate(const std::vector<Tally>& tallies, bool /*complete*/) const override {
    Table table{id_,
                "hemisphere",
                {"theta_o", "phi_o", "theta_i", "phi_i", "brdf_cos", "brdf_cos_stderr", "multiple", "multiple_stderr"},
                {}};
    for (std::size_t task = 0; task < tallies.size(); ++task)
      for (std::size_t bin = 0; bin < bins_.count(); ++bin) {
        std::vector<double> row = {views_[task].theta, views_[task].phi, bins_.theta(bin), bins_.phi(bin)};
        append_density(row, tallies[task], 2 * bin, 2 * bins_.count(), bins_.solid_angle(bin));
        append_density(row, tallies[task], 2 * bin + 1, 2 * bins_.count(), bins_.solid_angle(bin));
        table.rows.push_back(std::move(row));
      }
    return table;
  }

private:
  HemisphereBins bins_;
};

/// The share of the energy that leaves after each number of bounces; what is left is the row of 0 bounces.
class Bounces : public PathMeasure {
public:
  using PathMeasure::PathMeasure;
  std::size_t width() const override { return static_cast<std::size_t>(bounces_) + 2; }

  void sample(std::size_t task, const Tile& tile, double count, Random& random, std::span<double> sums,
              TraceCounts& counts) const override {
    const auto paths = for_paths(tile, count, views_[task].omega, bounces_, random, counts, [&](const PathEnd& end) {
      sums[end.escaped ? static_cast<std::size_t>(end.bounces) : 0] += tile.weight;
    });
    sums[width() - 1] += tile.weight * static_cast<double>(paths);
  }

  Table tabulate(const std::vector<Tally>& tallies, bool /*complete*/) const override {
    Table table{id_, "bounces", {"theta_o", "phi_o", "bounces", "energy", "energy_stderr"}, {}};
    for (std::size_t task = 0; task < tallies.size(); ++task)
      for (std::size_t k = 0; k + 1 < width(); ++k) {
        std::vector<double> row = {views_[task].theta, views_[task].phi, static_cast<double>(k)};
        append(row, tallies[task].estimate({k, width() - 1}, Tally::ratio));
        table.rows.push_back(std::move(row));
      }
    return table;
  }
};

} // namespace

MeasureType lobe_measure() {
  return measure_type<Lobe>(
      {.type = "lobe",
       .doc = "BRDF times cos theta_i in the plane of incidence, of single and of multiple scattering, F = 1",
       .source = "Heitz 2014, Fig. 11",
       .keys = {"bins", "bounces"},
       .bins = 90});
}

MeasureType hemisphere_measure() {
  return measure_type<Hemisphere>({.type = "hemisphere",
                                   .doc = "the same in bins of the hemisphere",
                                   .source = "Heitz 2014, Fig. 11",
                                   .keys = {"bins", "bounces"},
                                   .bins = 15});
}

MeasureType bounces_measure() {
  return measure_type<Bounces>({.type = "bounces",
                                .doc = "energy by the number of bounces; row 0: what has not left",
                                .source = "Heitz 2014, section 7",
                                .keys = {"bounces"}});
}

} // namespace brdfplot::simulation
