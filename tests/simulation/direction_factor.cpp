#include "scenes.hpp"

#include "microfacet/direction_factor.hpp"

#include <doctest/doctest.h>

using namespace test;

TEST_CASE("the fitted factor holds on a surface that is stretched and correlated, with the azimuth before that map") {
  ModelChoice choice{.type = "gaussian", .values = {}};
  choice.values.set("alpha_x", 1.0);
  choice.values.set("alpha_y", 0.4);
  choice.values.set("correlation", 0.5);
  choice.values.set("samples", 512.0);
  MeasureDescription g2 = measure("g2", {75}, 60000);
  g2.phi_o = {0.4};
  g2.theta_i = {70 * degree};
  for (const double phi : {15, 30, 60, 100, 150, 180, 210, 250, 320}) g2.delta_phi.push_back(phi * degree);
  SceneDescription description = scene(choice, g2);
  description.realisations = 2;
  const Table table = run(description).tables.at(0);

  const SlopeMap map{1.0, 0.4, 0.5};
  double squares = 0, squares_without = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double phi = at(table, row, "delta_phi");
    const Direction o = from_angles(75 * degree, 0.4), i = from_angles(70 * degree, 0.4 + phi);
    const Vec2 u = map.on_unit_surface(o), v = map.on_unit_surface(i);
    const double stretched = std::atan2(std::fabs(u[0] * v[1] - u[1] * v[0]), u[0] * v[0] + u[1] * v[1]);
    const auto factor = [&](double azimuth) {
      return fitted_direction_correlation({azimuth, map.project(o), map.project(i)}).lambda;
    };
    const double measured = at(table, row, "lambda"), error = at(table, row, "lambda_stderr");
    INFO("phi = " << phi << ", measured " << measured << " +- " << error);
    CHECK(std::fabs(factor(stretched) - measured) < 0.08 + 3 * error);
    squares += std::pow(factor(stretched) - measured, 2);
    squares_without += std::pow(factor(std::fabs(std::remainder(phi, 2 * std::numbers::pi))) - measured, 2);
  }
  CHECK(squares < 0.25 * squares_without);
}
