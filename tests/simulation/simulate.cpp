#include "simulation/scenes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace test;

TEST_CASE("G1 of a Gaussian surface: a little below Smith's, and tending to it as the angle falls") {
  // Independent simulations found 3 to 6 percent at 75 degrees: 0.752 for Smith's 0.798, 0.576 for 0.614.
  for (const double alpha : {0.6, 1.0}) {
    auto description = scene(mesh("gaussian", alpha, 256, 8), measure("g1", {20, 75}, 40000));
    description.realisations = 4;
    const Table table = run(description).tables.at(0);
    const double measured = at(table, 1, "g1"), smith = at(table, 1, "smith");
    CHECK(measured < smith);
    CHECK(measured > 0.92 * smith);
    CHECK(at(table, 1, "g1_stderr") < 0.02);
    CHECK(relative(at(table, 0, "g1"), at(table, 0, "smith")) < 0.01);
    // By projected area it is Smith's: the visible area is that of the plane, whatever the surface (Eq. 14).
    CHECK(std::fabs(at(table, 1, "g1_by_area") - smith) < 4 * at(table, 1, "g1_by_area_stderr") + 0.002);
  }
}

TEST_CASE("the visible projected area is conserved") {
  // Eq. 11, within three standard errors, which are a few thousandths.
  const auto grazing = {10.0, 45.0, 75.0, 85.0};
  for (const char* type : {"gaussian", "ggx"})
    for (const std::uint64_t seed : {1U, 2U}) {
      auto description = scene(mesh(type, 0.8, 128, 8), measure("g1", grazing, 30000));
      description.seed = seed;
      description.measures[0].phi_o = {0.3};
      const Table table = run(description).tables.at(0);
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double error = at(table, row, "projected_area_stderr");
        CHECK(std::fabs(at(table, row, "projected_area") - 1) <= 3 * error);
        CHECK(error < 0.05);
      }
    }
}

TEST_CASE("a sheared, anisotropic surface conserves the area of its mesosurface") {
  ModelChoice choice = mesh("gaussian", 1, 128, 6);
  ModelChoice general{.type = "gaussian", .values = {}};
  general.values.set("alpha_x", 0.3);
  general.values.set("alpha_y", 0.7);
  general.values.set("correlation", 0.5);
  general.values.set("mean_slope", Vec2{0.3, -0.2});
  general.values.set("samples", 128.0);
  general.values.set("correlation_length", 6.0);
  auto g1 = measure("g1", {70}, 30000);
  g1.phi_o = {0.5, 3.0};
  SceneDescription description = scene(general, g1);
  const Table table = run(description).tables.at(0);
  description.realisations = 1;
  const Table one = run(description).tables.at(0);
  for (std::size_t row = 0; row < 2; ++row) {
    CHECK(std::fabs(at(one, row, "projected_area") - 1) <= 3 * at(one, row, "projected_area_stderr"));
    CHECK(std::fabs(at(table, row, "g1_by_area") - at(table, row, "smith")) <
          4 * at(table, row, "g1_by_area_stderr") + 0.002);
  }
}

TEST_CASE("V-cavities mask as Eq. 49 says") {
  // By inclination of the facet in the plane of incidence: cavities across the view have G1 = min(1, 2 mz oz / (o.m)).
  ModelChoice choice = surface("v_cavity", 0.6);
  choice.values.set("pairs", 512.0);
  const Table table = run(scene(choice, measure("g1", {60, 80}, 100000))).tables.at(0);
  for (std::size_t row = 0; row < 2; ++row)
    CHECK(std::fabs(at(table, row, "projected_area") - 1) <= 3 * at(table, row, "projected_area_stderr"));
  // G1 on average, int min(1, 2 mz oz / (o.m)) P22 over the slopes that face omega_o, from the same formula.
  for (std::size_t row = 0; row < 2; ++row) {
    const Direction o = from_angles(row == 0 ? 60 * degree : 80 * degree, 0);
    double seen = 0, front = 0;
    for (double x = -3.995; x < 4; x += 0.01)
      for (double y = -3.995; y < 4; y += 0.01) {
        const double p22 = std::exp(-(x * x + y * y) / 0.36), area = o.z - x * o.x;
        if (!(area > 0)) continue;
        front += p22;
        seen += p22 * std::min(1.0, 2 * o.z / area);
      }
    CHECK(std::fabs(at(table, row, "g1") - seen / front) < 4 * at(table, row, "g1_stderr"));
  }
}

TEST_CASE("masking by normal: facets that lean towards the viewer are seen more") {
  const Table table = run(scene(mesh("gaussian", 1, 128, 6), measure("g1_by_normal", {75}, 60000))).tables.at(0);
  double share = 0, sum = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    share += at(table, row, "share");
    sum += at(table, row, "share") * at(table, row, "g1");
  }
  const Table mean = run(scene(mesh("gaussian", 1, 128, 6), measure("g1", {75}, 60000))).tables.at(0);
  CHECK(share < 1); // those that face away are in none
  CHECK(sum / share == doctest::Approx(at(mean, 0, "g1")).epsilon(0.03));
}

TEST_CASE("G2 and the lambda that it implies") {
  auto description = scene(mesh("gaussian", 1, 256, 8), measure("g2", {75}, 40000));
  description.realisations = 2;
  description.measures[0].delta_phi = {0, 20 * degree, 90 * degree};
  const Table table = run(description).tables.at(0);
  // From one direction nothing is shadowed that is not masked: lambda = 0, G2 = G1.
  CHECK(at(table, 0, "g2") == doctest::Approx(at(table, 0, "g1_o")).epsilon(1e-3));
  CHECK(std::fabs(at(table, 0, "lambda")) < 1e-2);
  // Another simulation of such a surface: 0.478, 0.884.
  CHECK(std::fabs(at(table, 1, "lambda") - 0.478) < 4 * at(table, 1, "lambda_stderr") + 0.02);
  CHECK(std::fabs(at(table, 2, "lambda") - 0.884) < 4 * at(table, 2, "lambda_stderr") + 0.02);
}

TEST_CASE("visible normals: normalised, and nothing where nothing is seen") {
  const Table table = run(scene(mesh("gaussian", 0.5, 128, 6), measure("visible_normals", {60}, 40000))).tables.at(0);
  double sum = 0;
  const double ring = 90 * degree / 15, sector = 360 * degree / 60;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double theta = at(table, row, "theta_m");
    sum += at(table, row, "d_visible") * (std::cos(theta - ring / 2) - std::cos(theta + ring / 2)) * sector;
    // Facets that fall away from the viewer by more than 30 degrees are never seen.
    if (theta > 40 * degree && std::fabs(at(table, row, "phi_m") - 180 * degree) < 10 * degree)
      CHECK(at(table, row, "d_visible") == 0);
  }
  CHECK(sum == doctest::Approx(1));
}

TEST_CASE("energy is 1, over all bounces") {
  for (const char* type : {"gaussian", "v_cavity"}) {
    auto bounces = measure("bounces", {60}, 20000);
    const ModelChoice choice = std::string(type) == "gaussian" ? mesh(type, 1, 128, 6) : surface(type, 1);
    const SimulationResult result = run(scene(choice, bounces));
    CHECK(result.counts.lost == 0);
    const Table& table = result.tables.at(0);
    double sum = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) sum += at(table, row, "energy");
    CHECK(sum == doctest::Approx(1).epsilon(1e-12));
    CHECK(at(table, 0, "energy") < 1e-3); // left after 32 bounces
    CHECK(at(table, 1, "energy") > 0.5);
    CHECK(at(table, 2, "energy") > 0.05);
  }
}

TEST_CASE("lobes hold the energy that leaves") {
  auto description = scene(mesh("gaussian", 0.5, 128, 6), measure("hemisphere", {45}, 40000));
  description.measures.push_back(measure("bounces", {45}, 40000));
  description.measures.push_back(measure("lobe", {45}, 40000));
  description.measures[2].bins = 30;
  const SimulationResult result = run(description);
  double single = 0;
  const double ring = 90 * degree / 15, sector = 360 * degree / 60;
  for (std::size_t row = 0; row < result.tables[0].rows.size(); ++row) {
    const double theta = at(result.tables[0], row, "theta_i");
    single +=
        at(result.tables[0], row, "brdf_cos") * (std::cos(theta - ring / 2) - std::cos(theta + ring / 2)) * sector;
  }
  const double error = at(result.tables[1], 1, "energy_stderr");
  CHECK(std::fabs(single - at(result.tables[1], 1, "energy")) < 5 * error);
  // The lobe lies on the side away from the viewer.
  double forward = 0, backward = 0;
  for (std::size_t row = 0; row < 30; ++row)
    (at(result.tables[2], row, "theta_i") < 0 ? forward : backward) += at(result.tables[2], row, "brdf_cos");
  CHECK(forward > 3 * backward);
}

TEST_CASE("the same numbers on any number of threads, others from another seed") {
  auto description = scene(mesh("gaussian", 1, 64, 4), measure("hemisphere", {70}, 5000));
  description.measures.push_back(measure("g1", {70}, 5000));
  description.realisations = 2;
  const SimulationResult one = run(description, 1), two = run(description, 2), seven = run(description, 7);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(one.tables[k].rows == two.tables[k].rows);
    CHECK(one.tables[k].rows == seven.tables[k].rows);
  }
  description.seed = 2;
  CHECK(at(run(description).tables[1], 0, "g1") != at(one.tables[1], 0, "g1"));
}

TEST_CASE("a text that stands for a scene") {
  auto a = scene(mesh("gaussian", 1, 64, 4), measure("g1", {70}, 5000));
  auto b = a;
  b.name = "another name";
  b.surface.values.set("autocorrelation", std::string("gaussian")); // the default
  CHECK(canonical_text(a) == canonical_text(b));
  for (const auto& change : std::vector<std::function<void(SceneDescription&)>>{
           [](auto& s) { s.seed = 2; }, [](auto& s) { s.realisations = 2; },
           [](auto& s) { s.surface.values.set("alpha", 0.9); }, [](auto& s) { s.measures[0].rays = 5001; },
           [](auto& s) { s.measures[0].theta_o = {1.0}; }, [](auto& s) { s.measures[0].type = "lobe"; }}) {
    auto other = a;
    change(other);
    CHECK(canonical_text(a) != canonical_text(other));
  }
}
