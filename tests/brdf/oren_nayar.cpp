#include "brdf/oren_nayar.hpp"
#include "../materials.hpp"
#include "../sample.hpp"
#include "analysis/integrals.hpp"
#include "brdf/diffuse.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace test;

namespace {

TermDescription nayar(double sigma) {
  TermDescription description = distribution("oren_nayar", {{"sigma", sigma}});
  description.masking.type = "v_cavity";
  description.type = "facet_diffuse";
  return description;
}

TermDescription fitted_nayar(double sigma, const std::string& form) {
  TermDescription description;
  description.name = description.type = "oren_nayar";
  description.values.set("sigma", sigma);
  description.values.set("form", form);
  return description;
}

constexpr OrenNayarFit fits[] = {OrenNayarFit::full, OrenNayarFit::direct, OrenNayarFit::qualitative};

/// How much of a facet of a V-shaped groove lies above the lines that the other edge draws from a direction: in the
/// cross-section the facet runs from (0, 0) to (1, h), the other edge is at (-1, h), and a point t of the way up is
/// hidden where the direction (x, z) passes below that edge.
double open_share(double h, double x, double z) {
  if (x >= 0) return 1; // on the side of the facet's own edge nothing stands before it
  // The line through (-1, h) along (x, z) meets the facet's (t, t h): t = (h x + z) / (h x - z).
  return std::clamp(1 - (h * x + z) / (h * x - z), 0.0, 1.0);
}

/// pi times the BRDF of grooves, over the normals in steps, from the geometry of each groove.
double by_grooves(double sigma, const Direction& o, const Direction& i) {
  constexpr int rows = 1200, columns = 1600;
  double sum = 0, ground = 0;
  for (int row = 0; row < rows; ++row) {
    const double theta = (row + 0.5) * 0.5 * std::numbers::pi / rows;
    const double weight = std::exp(-theta * theta / (2 * sigma * sigma)) * std::sin(theta);
    ground += weight * columns;
    for (int column = 0; column < columns; ++column) {
      const double phi = (column + 0.5) * 2 * std::numbers::pi / columns;
      const Direction m = from_angles(theta, phi);
      if (dot(o, m) <= 0 || dot(i, m) <= 0) continue;
      // The facet rises away from where it faces: towards -phi.
      const auto along = [&](const Direction& d) { return -(d.x * std::cos(phi) + d.y * std::sin(phi)); };
      const double h = std::tan(theta);
      // Both hidden parts begin at the bottom.
      const double open = std::min(open_share(h, along(o), o.z), open_share(h, along(i), i.z));
      sum += weight * open * dot(o, m) * dot(i, m) / m.z;
    }
  }
  return sum / ground / (o.z * i.z);
}

} // namespace

TEST_CASE("Oren and Nayar's fits are their formulas, at grazing angles too") {
  // Computed with mpmath at 40 digits.
  struct Row {
    double sigma, theta_o, theta_i, azimuth;
    double value[3];
  };
  const Row rows[] = {{0.1, 0.3, 0.7, 0.4, {0.319994581520627, 0.31625924608683993, 0.31625800316432541}},
                      {0.35, 1.2, 0.9, 0, {0.38984193470695502, 0.3722074966991682, 0.3722074966991682}},
                      {0.35, 1.2, 0.9, 3, {0.23344793052645672, 0.1986632423816867, 0.27522374136885768}},
                      {0.7, 1.5, 1.4, 2.5, {0.17034491469154252, 0.1003620755260741, 0.22320510311668249}},
                      {0.7, 0, 1.4, 1, {0.26597157653460146, 0.22320510311668249, 0.22320510311668249}},
                      {0.5, 1.57, 1.5707, 3.14, {0.1199069410376232, 0.048742177219349348, 0.24970861760969785}},
                      {0.9, 1.57, 1.56, 0.2, {12.030324173061656, 12.02876865613549, 11.907430949822513}},
                      {1e-6, 1, 1.1, 2, {0.31830988618323113, 0.31830988618274468, 0.31830988618330838}},
                      {3, 0.8, 0.8, 1.6, {0.21868428860587869, 0.16493810113918203, 0.16478421760639967}},
                      {1.5, 1.5707963, 1.5707, 2.2, {326.84746106635228, 326.76620189277581, 0.17951197069667265}}};
  for (const Row& row : rows)
    for (std::size_t k = 0; k < 3; ++k) {
      INFO("sigma = " << row.sigma << ", theta_o = " << row.theta_o << ", fit " << k);
      // Directions of double precision know tan(theta) to 1e-16 tan(theta) of itself.
      const double bound = 2e-14 + 2e-16 / std::cos(std::max(row.theta_o, row.theta_i));
      CHECK(relative(oren_nayar_brdf(fits[k], row.sigma, from_angles(row.theta_o, 0.3),
                                     from_angles(row.theta_i, 0.3 + row.azimuth)),
                     row.value[k]) < bound);
    }
}

TEST_CASE("Oren and Nayar's fits are reciprocal, Lambertian where smooth, and 0 below the horizon") {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 200; ++k) {
    const Direction o = from_angles(1.57 * unit(engine), 6.3 * unit(engine));
    const Direction i = from_angles(1.57 * unit(engine), 6.3 * unit(engine));
    for (const auto fit : fits) {
      const double sigma = 2 * unit(engine);
      CHECK(oren_nayar_brdf(fit, sigma, o, i) == doctest::Approx(oren_nayar_brdf(fit, sigma, i, o)).epsilon(1e-13));
      CHECK(oren_nayar_brdf(fit, 1e-9, o, i) == doctest::Approx(std::numbers::inv_pi).epsilon(1e-13));
    }
  }
  for (const auto fit : fits) {
    CHECK(oren_nayar_brdf(fit, 0.5, from_angles(1.6, 0), {0, 0, 1}) == 0);
    CHECK(oren_nayar_brdf(fit, 0.5, {0, 0, 1}, {1, 0, 0}) == 0);
    CHECK(std::isfinite(oren_nayar_brdf(fit, 0.5, from_angles(1.5707963267, 1), from_angles(1.5707963267, 1))));
  }
  // As published, without a floor: opposite directions near the horizon.
  const Direction o = from_angles(1.57, 0), i = from_angles(1.57, std::numbers::pi);
  CHECK(oren_nayar_brdf(OrenNayarFit::direct, 0.66, o, i) > 0);
  CHECK(oren_nayar_brdf(OrenNayarFit::direct, 0.68, o, i) < 0);
}

TEST_CASE("Oren and Nayar's distribution against 20-digit values") {
  struct Row {
    double sigma, theta, d;
  };
  // mpmath: exp(-theta^2 / (2 sigma^2)) / cos(theta) / (2 pi int exp(-t^2 / (2 sigma^2)) sin t dt).
  for (const Row& row : {Row{1e-6, 1e-7, 158361154501.69064},
                         {1e-6, 1.2e-6, 77469027597.242572},
                         {0.02, 0.002, 395.95646803362828},
                         {0.02, 0.024, 193.75419190821789},
                         {0.3, 0.03, 1.8138090076725079},
                         {0.3, 0.36, 0.94764912209249408},
                         {0.3, 1.5, 9.599280134185458e-5},
                         {0.5, 0.6, 0.40963911913793172},
                         {0.5, 1.5, 0.10908147274858464},
                         {1, 1.2, 0.35604221373126257},
                         {3, 0.1, 0.17020127141471118},
                         {3, 1.5, 2.1139479406716346},
                         {1000, 1.5, 2.249945589243212}}) {
    const Material m = build(nayar(row.sigma));
    INFO("sigma = " << row.sigma << ", theta = " << row.theta);
    const Direction normal = from_angles(row.theta, 2);
    CHECK(relative(value_at_normal(m, Quantity::d, {0, 0, 1}, normal), row.d) < 2e-14);
    const double z = std::cos(row.theta);
    CHECK(relative(value_at_normal(m, Quantity::p22, {0, 0, 1}, normal), row.d * z * z * z * z) < 4e-14);
  }
}

TEST_CASE("Eq. 31 in V-cavities is what the geometry of each groove gives") {
  for (const double sigma : {0.2, 0.5, 1.0})
    for (const auto& [theta_o, theta_i, azimuth] :
         {std::tuple(0.0, 0.7, 0.0), std::tuple(1.2, 0.9, 0.0), std::tuple(1.2, 0.9, std::numbers::pi),
          std::tuple(1.3, 1.3, 1.9)}) {
      INFO("sigma = " << sigma);
      const Direction o = from_angles(theta_o, 0.2), i = from_angles(theta_i, 0.2 + azimuth);
      const Estimate estimate = diffuse_brdf(build_microsurface(nayar(sigma)), o, i);
      CHECK(estimate.error <= 1e-10 * estimate.value);
      CHECK(relative(std::numbers::pi * estimate.value, by_grooves(sigma, o, i)) < 2e-5);
    }
}

TEST_CASE("Oren and Nayar's full fit is near Eq. 31, and the qualitative one farther") {
  // sigma = 0.5 in the plane of incidence, both sides.
  const Material exact = build(nayar(0.5));
  const auto worst = [&](const std::string& form) {
    const Material fitted = build(fitted_nayar(0.5, form));
    double most = 0;
    for (const double theta_o : sample_of<double>({0.3, 0.8, 1.1}, 2))
      for (const double theta_i : sample_of<double>({-1.2, -0.8, -0.2, 0.4, 1.0}, 2)) {
        const Direction o = from_angles(theta_o, 0), i = from_angles(theta_i, 0);
        most = std::max(most, relative(value(fitted, Quantity::brdf, o, i), value(exact, Quantity::brdf, o, i)));
      }
    return most;
  };
  const double direct = worst("direct"), qualitative = worst("qualitative");
  CHECK(direct < 0.1);
  CHECK(qualitative > 3 * direct);
  CHECK(worst("full") > direct); // with light that was reflected twice
}

TEST_CASE("fits of Oren and Nayar are materials: brdf_cos, albedo, and what they refuse") {
  const Direction o = from_angles(0.9, 0.3), i = from_angles(0.4, 2);
  const Material m = build(fitted_nayar(0.4, "full"));
  CHECK(value(m, Quantity::brdf, o, i) == oren_nayar_brdf(OrenNayarFit::full, 0.4, o, i));
  CHECK(value(m, Quantity::brdf_cos, o, i) == doctest::Approx(value(m, Quantity::brdf, o, i) * i.z).epsilon(1e-15));
  // The albedo by a midpoint rule.
  double sum = 0;
  constexpr int rows = 400, columns = 400;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double theta = (row + 0.5) * 0.5 * std::numbers::pi / rows;
      const Direction light = from_angles(theta, (column + 0.5) * 2 * std::numbers::pi / columns);
      sum += std::sin(theta) * std::cos(theta) * oren_nayar_brdf(OrenNayarFit::full, 0.4, o, light);
    }
  sum *= 0.5 * std::numbers::pi / rows * 2 * std::numbers::pi / columns;
  const Estimate albedo = compute(Integral::albedo, m, o, 1e-9);
  CHECK(albedo.error <= 1e-9);
  CHECK(albedo.value == doctest::Approx(sum).epsilon(1e-5));
  // In V-cavities with masking and shadowing, single scattering loses light.
  CHECK(compute(Integral::albedo, build(nayar(0.4)), o, 1e-3).value < 1);

  const auto refused = [](TermDescription description, const std::string& pointer) {
    try {
      build(description);
    } catch (const MaterialError& error) {
      CHECK(error.pointer() == pointer);
      return true;
    }
    return false;
  };
  CHECK(refused(distribution("oren_nayar", {{"sigma", 0.4}}), "/masking/type"));
  TermDescription mixed = mixture({{1, distribution("oren_nayar", {{"sigma", 0.4}}).distribution},
                                   {1, distribution("ggx", {{"alpha", 0.4}}).distribution}});
  CHECK(refused(mixed, "/masking/type"));
  mixed.masking.type = "v_cavity";
  CHECK_FALSE(refused(mixed, ""));
  TermDescription both = describe("ggx", 0.4);
  both.type = "oren_nayar";
  both.values.set("sigma", 0.4);
  CHECK(refused(both, "/distribution"));
}

TEST_CASE("diffuse facets that Kelemen's masking lets see all of an infinite area are refused at the first ray") {
  TermDescription description = nayar(0.4);
  description.type = "facet_diffuse";
  description.masking.type = "kelemen";
  const Material m = build(description);
  const Estimate e = diffuse_brdf(m.surface(), from_angles(1, 0), from_angles(0.5, 2));
  CHECK(std::isinf(e.error));
  CHECK(e.evaluations < 1'000'000);
  CHECK(std::isinf(compute(Integral::albedo, m, from_angles(1, 0), 1e-4).error));
}

TEST_CASE(
    "V-cavities of Oren and Nayar's distribution conserve the visible area, though Smith's would see none of it") {
  for (const double sigma : {0.05, 0.5, 2.0})
    for (const double theta : {0.0, 0.9, 1.5}) {
      const Material m = build(nayar(sigma));
      const Direction o = from_angles(theta, 0.4);
      for (const auto integral : {Integral::visible_norm, Integral::weak_furnace}) {
        const Estimate e = compute(integral, m, o, 1e-8);
        INFO("sigma = " << sigma << ", theta = " << theta);
        CHECK(std::fabs(e.value - 1) <= e.error);
        CHECK(e.error <= 1e-8);
      }
      const Estimate e = diffuse_weak_furnace(m.surface(), o, 1e-8);
      CHECK(std::fabs(e.value - 1) <= e.error);
      CHECK(e.error <= 1e-8);
    }
}
