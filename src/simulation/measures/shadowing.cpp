/// \file
/// G2 against the azimuth between the two directions, with the lambda that it implies.

#include "simulation/measures.hpp"

#include <algorithm>

namespace brdfplot::simulation {

namespace {

/// Heitz 2014, Eq. 101 solved for lambda, with each Lambda taken from the G1 of the same facets:
/// sums are of the facets that face both directions, and of those that see omega_o, omega_i, both.
double implied_lambda(std::span<const double> sums) {
  const double lambda_o = sums[0] / sums[1] - 1;
  const double lambda_i = sums[0] / sums[2] - 1;
  return (sums[0] / sums[3] - 1 - std::max(lambda_o, lambda_i)) / std::min(lambda_o, lambda_i);
}

class G2 : public Measure {
public:
  explicit G2(const MeasureDescription& description) : id_(description.id) {
    const auto& theta_i = description.theta_i.empty() ? description.theta_o : description.theta_i;
    for (const View& view : views(description))
      for (const double theta : theta_i)
        for (const double delta : description.delta_phi)
          pairs_.push_back({view, {theta, view.phi + delta, from_angles(theta, view.phi + delta)}, delta});
  }
  std::size_t tasks() const override { return pairs_.size(); }
  std::size_t width() const override { return 4; }

  void sample(std::size_t task, const Tile& tile, double count, Random& random, std::span<double> sums,
              TraceCounts& counts) const override {
    const Direction o = tile.field->to_mesh(pairs_[task].o.omega);
    const Direction i = tile.field->to_mesh(pairs_[task].i.omega);
    Facing facing;
    std::vector<unsigned char> sees_o;
    for_random_points(tile, count, random, [&](std::span<const SurfacePoint> points) {
      facing.take(points, o, i);
      facing.trace(*tile.tracer, o, counts);
      sees_o = facing.visible;
      facing.trace(*tile.tracer, i, counts);
      for (std::size_t k = 0; k < facing.points.size(); ++k) {
        sums[0] += tile.weight;
        sums[1] += tile.weight * sees_o[k];
        sums[2] += tile.weight * facing.visible[k];
        sums[3] += tile.weight * (sees_o[k] & facing.visible[k]);
      }
    });
  }

  Table tabulate(const std::vector<Tally>& tallies, bool /*complete*/) const override {
    Table table{id_,
                "g2",
                {"theta_o", "phi_o", "theta_i", "delta_phi", "g1_o", "g1_o_stderr", "g1_i", "g1_i_stderr", "g2",
                 "g2_stderr", "lambda", "lambda_stderr"},
                {}};
    for (std::size_t task = 0; task < tallies.size(); ++task) {
      const Pair& pair = pairs_[task];
      std::vector<double> row = {pair.o.theta, pair.o.phi, pair.i.theta, pair.delta};
      for (const std::size_t column : {1U, 2U, 3U}) append(row, tallies[task].estimate({column, 0}, Tally::ratio));
      append(row, tallies[task].estimate({0, 1, 2, 3}, implied_lambda));
      table.rows.push_back(std::move(row));
    }
    return table;
  }

private:
  struct Pair {
    View o, i;
    double delta;
  };
  std::string id_;
  std::vector<Pair> pairs_;
};

} // namespace

MeasureType g2_measure() {
  return measure_type<G2>({.type = "g2",
                           .doc = "masking and shadowing, and the lambda that it implies",
                           .source = "Heitz 2014, Eq. 101",
                           .keys = {"theta_i", "delta_phi"}});
}

} // namespace brdfplot::simulation
