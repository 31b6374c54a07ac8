/// \file
/// Measures the factor lambda of Heitz 2014, Eq. 101, on Gaussian surfaces with a Gaussian autocorrelation: the data
/// that fit_direction_factor reads.
///
///   brdfplot-simulate-direction-factor tests/reference/direction_factor.csv
///
/// The directions are those at which a = cot theta / alpha has given values, so that every roughness is asked where
/// masking and shadowing are strong enough to tell. Each roughness has surfaces of its own: stretching a surface
/// changes neither what sees what nor a, so that on the same surfaces all would give the same numbers. `set` tells the
/// rows that are fitted from those that test the fit, at other roughnesses, elevations and azimuths, and from those
/// outside the range of a that is fitted.

#include "base/threads/parallel.hpp"
#include "simulation/simulate.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace brdfplot;

struct Grid {
  std::string set;
  std::vector<double> alphas, a, degrees;
};

const std::vector<Grid> grids = {
    {"fit", {0.3, 0.6, 1.0}, {0.05, 0.15, 0.3, 0.5, 0.8}, {5, 10, 20, 30, 45, 60, 90, 120, 150, 180}},
    {"held_out", {0.45, 0.8}, {0.1, 0.22, 0.4, 0.65}, {8, 15, 25, 38, 52, 75, 105, 135, 165}},
    {"outside", {0.15, 1.5}, {0.025, 0.3, 1.0}, {8, 15, 25, 38, 52, 75, 105, 135, 165}}};

/// The surfaces of one roughness, and G2 for each pair of elevations.
simulation::SceneDescription scene(double alpha, const Grid& grid, std::uint64_t seed) {
  simulation::SceneDescription made{"", {.type = "gaussian", .values = {}}, seed, 8, {}};
  made.surface.values.set("alpha", alpha);
  for (std::size_t i = 0; i < grid.a.size(); ++i)
    for (std::size_t o = i; o < grid.a.size(); ++o) {
      simulation::MeasureDescription measure;
      measure.id = "g2_" + std::to_string(made.measures.size());
      measure.type = "g2";
      measure.theta_o = {std::atan(1 / (grid.a[o] * alpha))};
      measure.theta_i = {std::atan(1 / (grid.a[i] * alpha))};
      for (const double angle : grid.degrees) measure.delta_phi.push_back(angle * std::numbers::pi / 180);
      measure.rays = 4e5;
      made.measures.push_back(std::move(measure));
    }
  return made;
}

void write(std::ofstream& file, const std::string& set, double alpha, const simulation::Table& table) {
  for (const auto& row : table.rows) {
    file << set << ',' << alpha;
    for (const auto* column :
         {"theta_o", "theta_i", "delta_phi", "g1_o", "g1_i", "g2", "g2_stderr", "lambda", "lambda_stderr"})
      file << ',' << row[table.column(column)];
    file << '\n';
  }
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: brdfplot-simulate-direction-factor FILE.csv\n", stderr);
    return 2;
  }
  try {
    std::ofstream file(argv[1]);
    file << "set,alpha,theta_o,theta_i,phi,g1_o,g1_i,g2,g2_stderr,lambda,lambda_stderr\n";
    std::uint64_t seed = 0;
    for (const Grid& grid : grids)
      for (const double alpha : grid.alphas) {
        std::fprintf(stderr, "%s, alpha = %g\n", grid.set.c_str(), alpha);
        const auto result = simulation::simulate(scene(alpha, grid, ++seed), {hardware_threads(), {}, false});
        for (const auto& table : result.tables) write(file, grid.set, alpha, table);
      }
    if (!file.flush()) throw std::runtime_error(std::string("cannot write ") + argv[1]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "brdfplot-simulate-direction-factor: %s\n", e.what());
    return 1;
  }
}
