/// \file
/// Whether the spread of a result over seeds is what its standard error says.
#include "simulation/scenes.hpp"

#include "../sample.hpp"
#include "base/random.hpp"
#include "config/temp_files.hpp"
#include "simulation/walk.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace test;

namespace {

/// More seeds tell more exactly: BRDFPLOT_SEEDS=400. A sampled run only walks through: its two tell nothing.
std::uint64_t seeds() { return random_inputs("BRDFPLOT_SEEDS", 40, 2); }

/// Runs of one quantity.
struct Runs {
  std::vector<double> values;
  double stated2 = 0; ///< sum of the squares of the errors

  void add(const Measured& measured) {
    values.push_back(measured.value);
    stated2 += measured.standard_error * measured.standard_error;
  }
};

/// All the quantities of a name. Their ratios of spread to stated error, of the mean squares, are averaged: of 40 runs
/// a single one scatters by 11 %.
class Quantities {
public:
  void add(const std::string& place, const Measured& measured) { runs_[place].add(measured); }
  double spread_over_stated() const {
    double sum = 0, n = 0;
    for (const auto& [place, runs] : runs_) {
      const auto count = static_cast<double>(runs.values.size());
      // What is so rare that not every run, or only one surface of a run, has it, has no error to be held to.
      if (runs.values.size() < seeds() || !std::isfinite(runs.stated2)) continue;
      const double spread = mean_of(runs.values).standard_error;
      if (!(runs.stated2 > 0)) {
        const std::string& at = place; // clang 14 captures no structured binding
        CHECK_MESSAGE(spread < 1e-12, at);
        continue;
      }
      sum += spread * spread * count * count / runs.stated2;
      n += 1;
    }
    return std::sqrt(sum / n);
  }

private:
  std::map<std::string, Runs> runs_;
};

using ByName = std::map<std::string, Quantities>;

/// Every measured column of a table, by what stands before the first: the place of a row.
void add(ByName& all, const Table& table) {
  for (const auto& row : table.rows) {
    std::string place;
    for (std::size_t k = 0; k + 1 < table.columns.size(); ++k) {
      const std::string& column = table.columns[k];
      if (table.columns[k + 1] == column + "_stderr")
        all[table.type + " " + column].add(place, {row[k], row[k + 1]});
      else if (!column.ends_with("_stderr"))
        place += std::to_string(row[k]) + " ";
    }
  }
}

void check_within(const ByName& all, const std::string& of) {
  for (const auto& [name, quantities] : all) {
    const double ratio = quantities.spread_over_stated();
    const std::string about = of + ", " + name;
    if (!sampled()) CHECK_MESSAGE(std::fabs(ratio - 1) < 0.15, about << ": spread over stated error " << ratio);
  }
}

/// Some of every measure, from four sides.
SceneDescription everything(const ModelChoice& surface) {
  SceneDescription description;
  description.name = "test";
  description.surface = surface;
  const auto take = [&](const std::string& type, const std::vector<double>& degrees) -> MeasureDescription& {
    MeasureDescription one = measure(type, degrees, 10000);
    one.phi_o = {0, 0.8, 1.6, 2.4};
    one.bounces = 8;
    return description.measures.emplace_back(one);
  };
  take("g1", {50, 75});
  take("g1_by_normal", {60}).bins = 8;
  auto& g2 = take("g2", {70});
  g2.delta_phi = {40 * degree, 120 * degree};
  take("visible_normals", {60}).bins = 2;
  auto& lobe = take("lobe", {60});
  lobe.bins = 6;
  lobe.half_width = 0.3;
  take("hemisphere", {60}).bins = 2;
  take("bounces", {70});
  return description;
}

ByName runs_of(SceneDescription description) {
  ByName all;
  for (description.seed = 1; description.seed <= seeds(); ++description.seed)
    for (const Table& table : run(description).tables) add(all, table);
  return all;
}

} // namespace

TEST_CASE("standard errors are what seeds scatter by: Gaussian surfaces") {
  check_within(runs_of(everything(mesh("gaussian", 0.8, 64, 4))), "gaussian");
}

TEST_CASE("standard errors are what seeds scatter by: GGX surfaces") {
  check_within(runs_of(everything(mesh("ggx", 0.5, 64, 4))), "ggx");
}

TEST_CASE("standard errors are what seeds scatter by: V-cavities") {
  ModelChoice choice = surface("v_cavity", 0.6);
  choice.values.set("pairs", 32.0);
  check_within(runs_of(everything(choice)), "v_cavity");
}

TEST_CASE("standard errors are what seeds scatter by: a given height map, by its rays alone") {
  constexpr int n = 32;
  Random random(1, 1);
  std::string text = "Pf\n32 32\n-1.0\n";
  for (int k = 0; k < n * n; ++k) {
    const auto height = static_cast<float>(2 * random.uniform());
    text.append(reinterpret_cast<const char*>(&height), sizeof height);
  }
  const brdfplot::test::TempFolder folder;
  ModelChoice choice{.type = "height_map", .values = {}};
  choice.values.set("file", folder.write("map.pfm", text));
  choice.values.set("height", 1.0);
  choice.values.set("border", std::string("mirror"));
  SceneDescription description = everything(choice);
  check_within(runs_of(description), "height_map");
  // One realisation of it tells as much.
  description.realisations = 1;
  const Table table = run(description).tables.at(0);
  CHECK(at(table, 0, "g1_stderr") < 0.05);
}

TEST_CASE("standard errors are what seeds scatter by: the walk on Smith's surface") {
  TermDescription metal = describe("ggx", 0.6);
  metal.fresnel.type = "conductor";
  metal.fresnel.values.set("eta", 0.2);
  metal.fresnel.values.set("k", 3.0);
  const Material material = build(metal);
  ByName all;
  WalkRequest request;
  request.omega_o = from_angles(1.2, 0.3);
  request.paths = 6400;
  request.threads = 2;
  for (const double theta : {0.2, 0.8, 1.3})
    for (const double phi : {0.5, 2.0, 3.4}) request.omega_i.push_back(from_angles(theta, phi));
  for (request.seed = 1; request.seed <= seeds(); ++request.seed) {
    const WalkResult walked = walk(material, Facets::conductor, request);
    for (const std::size_t first : {1U, 2U, 3U}) {
      const std::string bounces = std::to_string(first);
      all["energy"].add(bounces, WalkResult::energy(walked.reflected, first, first).at(0));
      all["mean_fresnel"].add(bounces, walked.mean_fresnel(first, first).at(0));
      for (std::size_t k = 0; k < request.omega_i.size(); ++k)
        all["lobe"].add(bounces + " " + std::to_string(k), walked.lobe_of(first, first).at(k));
    }
  }
  check_within(all, "walk");
}

TEST_CASE("of one random surface there is no standard error, but of what a surface as a whole fixes") {
  auto description = scene(mesh("gaussian", 0.8, 64, 4), measure("g1", {60}, 10000));
  description.realisations = 1;
  const Table table = run(description).tables.at(0);
  CHECK(std::isinf(at(table, 0, "g1_stderr")));
  CHECK(std::isinf(at(table, 0, "g1_by_area_stderr")));
  CHECK(at(table, 0, "projected_area_stderr") < 0.02);
  description.realisations = 2;
  CHECK(std::isfinite(at(run(description).tables.at(0), 0, "g1_stderr")));
}
