/// \file
/// The distribution of visible normals, in bins of the hemisphere.

#include "simulation/measures.hpp"
#include "simulation/measures/hemisphere_bins.hpp"

namespace brdfplot::simulation {

namespace {

/// Heitz 2014, Eq. 16: the share of the visible projected area that a normal has, per solid angle.
class VisibleNormals : public Measure {
public:
  explicit VisibleNormals(const MeasureDescription& description)
      : id_(description.id), views_(views(description)), bins_(static_cast<std::size_t>(description.bins)) {}
  std::size_t tasks() const override { return views_.size(); }
  std::size_t width() const override { return bins_.count() + 1; }

  void sample(std::size_t task, const Tile& tile, double count, Random& random, std::span<double> sums,
              TraceCounts& counts) const override {
    const Direction d = tile.field->to_mesh(views_[task].omega);
    Facing facing;
    for_random_points(tile, count, random, [&](std::span<const SurfacePoint> points) {
      facing.take(points, d);
      facing.trace(*tile.tracer, d, counts);
      for (std::size_t k = 0; k < facing.points.size(); ++k) {
        if (facing.visible[k] == 0) continue;
        const double area = tile.weight * projected_area(facing.points[k].slope, d);
        sums[bins_.of(normal_of(tile.field->to_world(facing.points[k].slope)))] += area;
        sums[bins_.count()] += area;
      }
    });
  }

  Table tabulate(const std::vector<Tally>& tallies, bool /*complete*/) const override {
    Table table{id_, "visible_normals", {"theta_o", "phi_o", "theta_m", "phi_m", "d_visible", "d_visible_stderr"}, {}};
    for (std::size_t task = 0; task < tallies.size(); ++task)
      for (std::size_t bin = 0; bin < bins_.count(); ++bin) {
        std::vector<double> row = {views_[task].theta, views_[task].phi, bins_.theta(bin), bins_.phi(bin)};
        const double solid_angle = bins_.solid_angle(bin);
        append(row, tallies[task].estimate({bin, bins_.count()}, [solid_angle](std::span<const double> sums) {
          return Tally::ratio(sums) / solid_angle;
        }));
        table.rows.push_back(std::move(row));
      }
    return table;
  }

private:
  std::string id_;
  std::vector<View> views_;
  HemisphereBins bins_;
};

} // namespace

MeasureType visible_normals_measure() {
  return measure_type<VisibleNormals>({.type = "visible_normals",
                                       .doc = "distribution of visible normals in bins of the hemisphere",
                                       .source = "Heitz 2014, Eq. 16",
                                       .keys = {"bins"},
                                       .bins = 15});
}

} // namespace brdfplot::simulation
