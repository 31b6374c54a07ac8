#include "bake/bake.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace brdfplot::bake {

namespace {

/// Places on an axis in steps that no doubling of its nodes leaves: an index counts them.
constexpr std::uint32_t steps_per_interval = 1U << 12;
/// Half-way is where linear interpolation of a smooth function is off most; beside a kink it may be off more elsewhere.
constexpr double beyond_half_way = 1.5;

using Place = std::vector<std::uint32_t>;

/// A quantity at points, on the threads of this process or on those of all ranks.
class Points {
public:
  Points(const Baked& baked, const BakeOptions& options)
      : baked_(baked), team_(options.team),
        compute_([&baked, threads = options.threads](const auto& points, const Done& done) {
          parallel_for(points.size(), threads, [&](std::size_t k) { done(k, baked.at(points[k])); });
        }) {}

  const std::vector<std::string>& channels() const { return baked_.channels(); }
  std::vector<Numbers> at(const std::vector<Numbers>& points) const {
    std::vector<Numbers> computed(points.size());
    const auto take = [&](std::size_t k, Numbers values) { computed[k] = std::move(values); };
    if (team_ == nullptr)
      compute_(points, take);
    else if (!points.empty())
      team_->map(points, points.size(), compute_, take);
    return computed;
  }
  void help() const { team_->serve(compute_); }

private:
  const Baked& baked_;
  Team* team_;
  Compute compute_;
};

/// A grid that grows: what was computed once is kept.
class Grid {
public:
  Grid(const Points& points, std::vector<Axis> axes) : points_(points), axes_(std::move(axes)) {
    for (const Axis& axis : axes_) step_.push_back(steps_per_interval), first_.push_back(axis.nodes);
  }

  const std::vector<Axis>& axes() const { return axes_; }
  bool can_double(std::size_t axis) const { return step_[axis] > 2 && 2 * axes_[axis].nodes - 1 <= 4096; }
  void double_nodes(std::size_t axis) {
    step_[axis] /= 2;
    axes_[axis].nodes = 2 * axes_[axis].nodes - 1;
  }

  Table table(const std::string& material, const std::string& quantity) {
    Table table{material, quantity, axes_, points_.channels(), {}};
    const std::vector<Place> places = nodes();
    compute(places);
    for (const Place& place : places) {
      const std::vector<double>& values = known_.at(place);
      table.values.insert(table.values.end(), values.begin(), values.end());
    }
    return table;
  }

  /// What interpolation along an axis is off by half-way between nodes, and where.
  struct Off {
    double error = 0;
    std::vector<double> where;
  };
  Off off_along(std::size_t axis) {
    std::vector<Place> halfway;
    for (Place& place : nodes())
      if (place[axis] + step_[axis] <= end_of(axis)) {
        place[axis] += step_[axis] / 2;
        halfway.push_back(std::move(place));
      }
    compute(halfway);
    compute(nodes());
    Off off;
    for (const Place& place : halfway) {
      Place low = place, high = place;
      low[axis] -= step_[axis] / 2;
      high[axis] += step_[axis] / 2;
      for (std::size_t c = 0; c < points_.channels().size(); ++c) {
        const double between = (known_.at(low)[c] + known_.at(high)[c]) / 2;
        const double error = std::fabs(between - known_.at(place)[c]);
        if (error > off.error || off.where.empty()) off = {error, values_at(place)};
      }
    }
    return off;
  }

private:
  std::uint32_t end_of(std::size_t axis) const {
    return static_cast<std::uint32_t>(first_[axis] - 1) * steps_per_interval;
  }

  std::vector<double> values_at(const Place& place) const {
    std::vector<double> values;
    for (std::size_t k = 0; k < axes_.size(); ++k)
      values.push_back(axes_[k].at(static_cast<double>(place[k]) / end_of(k)));
    return values;
  }

  /// The places of all nodes, the first axis fastest.
  std::vector<Place> nodes() const {
    std::vector<Place> places;
    Place place(axes_.size(), 0);
    for (;;) {
      places.push_back(place);
      std::size_t k = 0;
      while (k < axes_.size() && (place[k] += step_[k]) > end_of(k)) place[k++] = 0;
      if (k == axes_.size()) return places;
    }
  }

  void compute(const std::vector<Place>& places) {
    std::vector<Place> missing;
    for (const Place& place : places)
      if (known_.find(place) == known_.end()) missing.push_back(place);
    if (known_.size() + missing.size() > most_points)
      throw InputError("bake", "the table takes more than " + std::to_string(most_points) +
                                   " points; accepted: fewer nodes, or a larger --error");
    std::vector<Numbers> values;
    for (const Place& place : missing) values.push_back(values_at(place));
    std::vector<Numbers> computed = points_.at(values);
    for (std::size_t k = 0; k < missing.size(); ++k) known_.emplace(std::move(missing[k]), std::move(computed[k]));
  }

  const Points& points_;
  std::vector<Axis> axes_;
  std::vector<std::uint32_t> step_; ///< between nodes
  std::vector<std::size_t> first_;  ///< how many nodes there were at first
  std::map<Place, std::vector<double>> known_;
};

/// The errors of a grid along each axis.
struct Errors {
  std::vector<Grid::Off> along;

  std::size_t largest() const {
    const auto found =
        std::ranges::max_element(along, [](const Grid::Off& a, const Grid::Off& b) { return a.error < b.error; });
    return static_cast<std::size_t>(found - along.begin());
  }
  double bound(double tolerance) const {
    double sum = 0;
    for (const Grid::Off& off : along) sum += off.error;
    return beyond_half_way * sum + tolerance;
  }
};

Errors errors_of(Grid& grid) {
  Errors errors;
  for (std::size_t k = 0; k < grid.axes().size(); ++k) errors.along.push_back(grid.off_along(k));
  return errors;
}

constexpr std::size_t first_nodes = 9;

/// The power whose interpolation along the axis is off least, all axes with few nodes.
int best_power(const Points& points, const std::vector<Axis>& axes, std::size_t axis) {
  std::vector<Axis> coarse = axes;
  for (Axis& one : coarse) one.nodes = first_nodes, one.power = std::max(one.power, 1);
  int best = 1;
  double least = infinity;
  // What is inverted leaves 0 as a root, or as a logarithm does.
  const std::vector<int> powers =
      axes[axis].variable == share_axis ? std::vector{1, 2, 3, 4, 6, 8} : std::vector{1, 2, 3};
  for (const int power : powers) {
    coarse[axis].power = power;
    const double error = Grid(points, coarse).off_along(axis).error;
    if (error < least) best = power, least = error;
  }
  return best;
}

void choose_nodes(const Points& points, std::vector<Axis>& axes, const BakeOptions& options) {
  for (std::size_t k = 0; k < axes.size(); ++k)
    if (axes[k].power == 0) axes[k].power = options.error ? best_power(points, axes, k) : 1;
  for (Axis& axis : axes)
    if (axis.nodes == 0) axis.nodes = options.error ? first_nodes : 32;
}

} // namespace

void help_to_bake(const MaterialDescription& material, const std::string& quantity, const std::vector<Axis>& axes,
                  const BakeOptions& options) {
  const Baked baked(material, quantity, axes, options.tolerance);
  Points(baked, options).help();
}

BakedTable bake(const MaterialDescription& material, const std::string& quantity, std::vector<Axis> axes,
                const BakeOptions& options) {
  if (axes.empty()) throw InputError("--over", "a table needs an axis");
  if (options.error && !(*options.error > options.tolerance))
    throw InputError("--error", "found " + format_number(*options.error) +
                                    ", accepted: a number above the tolerance, " + format_number(options.tolerance));
  const Baked baked(material, quantity, axes, options.tolerance);
  const Points points(baked, options);
  choose_nodes(points, axes, options);
  Grid grid(points, axes);
  Errors errors = errors_of(grid);
  while (options.error && errors.bound(options.tolerance) > *options.error) {
    const std::size_t worst = errors.largest();
    if (!grid.can_double(worst))
      throw AccuracyError("bake", "the axis " + axes[worst].variable +
                                      " would need more than 4096 nodes for an error of " +
                                      format_number(*options.error));
    grid.double_nodes(worst);
    errors = errors_of(grid);
  }
  BakedTable out{grid.table(material.name, quantity),
                 options.tolerance,
                 {},
                 errors.along[errors.largest()].where,
                 errors.bound(options.tolerance)};
  for (const Grid::Off& off : errors.along) out.axis_error.push_back(off.error);
  return out;
}

} // namespace brdfplot::bake
