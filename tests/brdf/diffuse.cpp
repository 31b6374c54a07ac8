#include "brdf/diffuse.hpp"
#include "../materials.hpp"
#include "../sample.hpp"
#include "analysis/integrals.hpp"
#include "integrate/hemisphere.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace test;

namespace {

TermDescription diffuse(TermDescription description) {
  description.type = "facet_diffuse";
  return description;
}

/// The albedo of diffuse facets, over the light.
Estimate hemisphere(const Material& material, const Direction& o, double tolerance) {
  return compute(Integral::albedo, material, o, tolerance);
}

/// int <o,m> <i,m> G2 D dm by a midpoint rule in theta_m and phi_m, a row of normals at a time.
double sum_over_normals(const Material& material, const Direction& o, const Direction& i) {
  constexpr std::size_t rows = 600, columns = 600;
  const std::vector<double> ox(columns, o.x), oy(columns, o.y), oz(columns, o.z);
  const std::vector<double> ix(columns, i.x), iy(columns, i.y), iz(columns, i.z);
  std::vector<double> x(columns), y(columns), z(columns), g2(columns), d(columns);
  const Batch batch{
      columns, {ox.data(), oy.data(), oz.data()}, {ix.data(), iy.data(), iz.data()}, {x.data(), y.data(), z.data()}};
  double sum = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const double theta = (static_cast<double>(row) + 0.5) * 0.5 * std::numbers::pi / rows;
    for (std::size_t k = 0; k < columns; ++k) {
      const Direction normal = from_angles(theta, (static_cast<double>(k) + 0.5) * 2 * std::numbers::pi / columns);
      x[k] = normal.x;
      y[k] = normal.y;
      z[k] = normal.z;
    }
    evaluate(material, Quantity::g2, batch, g2.data());
    evaluate(material, Quantity::d, batch, d.data());
    for (std::size_t k = 0; k < columns; ++k) {
      const Direction normal{x[k], y[k], z[k]};
      if (dot(o, normal) > 0 && dot(i, normal) > 0)
        sum += std::sin(theta) * dot(o, normal) * dot(i, normal) * g2[k] * d[k];
    }
  }
  return sum * 0.5 * std::numbers::pi / rows * 2 * std::numbers::pi / columns;
}

} // namespace

TEST_CASE("diffuse facets agree with a fine product rule over the normals") {
  // Eq. 31 by a midpoint rule in theta_m and phi_m, which knows nothing of slopes, horizons or kinks.
  struct Case {
    TermDescription material;
    double theta_o, theta_i, azimuth;
  };
  const std::vector<Case> cases = {{describe("beckmann", 0.4), 0.3, 1.0, 0.5},
                                   {describe("ggx", 0.8), 1.2, 1.3, 3.0},
                                   {describe("beckmann", 0.6, "v_cavity"), 1.0, 0.7, 0.2},
                                   {describe("ggx", 0.5, "v_cavity"), 1.3, 1.3, 2.0},
                                   {shadowed(describe("beckmann", 0.5), "minimum"), 1.3, 0.4, 1.0},
                                   {describe("ggx", 0.5, "kelemen"), 0.9, 0.6, 1.0},
                                   {general("beckmann", 0.3, 0.6, 0.4, {0.2, -0.1}), 0.8, 1.1, 1.9}};
  for (const auto& [description, theta_o, theta_i, azimuth] : cases) {
    const Material m = build(diffuse(description));
    const Direction o = from_angles(theta_o, 0.3), i = from_angles(theta_i, 0.3 + azimuth);
    const double sum = sum_over_normals(m, o, i);
    const double expected =
        sum / (std::numbers::pi * m.surface().slopes().project(o).c * m.surface().slopes().project(i).c);
    const double shown = theta_o; // Clang 14 has no structured binding in the lambda of INFO
    INFO(m.name << ", theta_o = " << shown);
    const Estimate estimate = diffuse_brdf(m.surface(), o, i);
    CHECK(relative(estimate.value, expected) < 2e-4);
    CHECK(estimate.error <= 1e-9 * estimate.value);
    CHECK(value(m, Quantity::brdf, o, i) == estimate.value);
    CHECK(value(m, Quantity::brdf_cos, o, i) == doctest::Approx(estimate.value * m.surface().slopes().project(i).c));
    CHECK(relative(value(m, Quantity::brdf, i, o), estimate.value) < 1e-9); // reciprocal
  }
}

TEST_CASE("the estimate of a diffuse BRDF is honest, wherever one looks") {
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < inputs(60, 12); ++k) {
    const double ax = 0.02 * std::pow(100, unit(engine)), ay = ax * std::pow(4, 2 * unit(engine) - 1);
    const Vec2 mean = k % 3 == 0 ? Vec2{0.3 * unit(engine), -0.3 * unit(engine)} : Vec2{0, 0};
    const Material m = build(diffuse(general(k % 2 == 0 ? "beckmann" : "ggx", ax, ay, 1.6 * unit(engine) - 0.8, mean,
                                             k % 4 == 3 ? "v_cavity" : "smith")));
    const Direction o = from_angles(unit(engine) * 89 * degree, 6.3 * unit(engine));
    const Direction i = from_angles(unit(engine) * 89 * degree, 6.3 * unit(engine));
    const Estimate fine = diffuse_brdf(m.surface(), o, i, {.relative = 1e-12});
    const Estimate coarse = diffuse_brdf(m.surface(), o, i, {.relative = 1e-5});
    INFO("case " << k << ": " << m.name << ", alpha_x = " << ax << ", alpha_y = " << ay);
    CHECK(std::fabs(coarse.value - fine.value) <= coarse.error + fine.error);
    CHECK(fine.value >= 0);
  }
}

TEST_CASE("light from where the viewer is, or from next to it, sees the facets that the viewer sees") {
  const auto tilted = mixture({{0.5, general("beckmann", 0.4, 0.6, 0.3, {-0.3, 0.2}).distribution},
                               {0.5, general("ggx", 0.3, 0.3, 0, {0.4, 0.1}).distribution}});
  for (TermDescription description : {describe("ggx", 0.4), describe("velvet", 0.4), tilted})
    for (const auto* masking : {"v_cavity", "kelemen"}) {
      description.masking.type = masking;
      const Material m = build(diffuse(description));
      for (const double theta : sample_of<double>({0.4, 0.0, 1.2}, 3)) {
        const Direction o = from_angles(theta, 0.3);
        const double same = value(m, Quantity::brdf, o, o);
        INFO(description.name << " with " << masking << ", theta_o = " << theta);
        CHECK(same > 0.05);
        for (const double turn : sample_of<double>({1e-12, 1e-15, 1e-8}, 3)) {
          CHECK(relative(value(m, Quantity::brdf, o, from_angles(theta + turn, 0.3)), same) < 1e-9 + 20 * turn);
          CHECK(relative(value(m, Quantity::brdf, o, from_angles(theta, 0.3 + turn)), same) < 1e-9 + 20 * turn);
        }
      }
    }
}

TEST_CASE("a smooth surface of diffuse facets is Lambertian, at grazing angles too where it is smooth enough") {
  const Material m = build(diffuse(describe("beckmann", 1e-4)));
  for (const double theta : {0.0, 0.7, 1.5})
    CHECK(value(m, Quantity::brdf, from_angles(theta, 0), from_angles(0.6, 2)) ==
          doctest::Approx(std::numbers::inv_pi).epsilon(1e-6));
  CHECK(value(m, Quantity::brdf, from_angles(2, 0), {0, 0, 1}) == 0);
  CHECK(value(m, Quantity::brdf, {0, 0, 1}, {1, 0, 0}) == 0);
  CHECK(compute_or_throw(Integral::albedo, m, from_angles(0.8, 0.3), 1e-3) == doctest::Approx(1).epsilon(2e-3));
}

TEST_CASE("the albedo of diffuse facets: with masking alone all light leaves, with shadowing less") {
  // Eq. 37 over the sphere of the light: below the horizon G2 = G1 is no longer 0, so only its part above is here.
  {
    const Material m = build(diffuse(describe("ggx", 0.5)));
    const Direction o = from_angles(0.9, 0.2);
    const double accuracy = inputs(1e-5, 1e-3);
    const Estimate coarse = hemisphere(m, o, inputs(1e-3, 1e-2));
    const Estimate fine = hemisphere(m, o, accuracy);
    CHECK(std::fabs(coarse.value - fine.value) <= coarse.error + fine.error);
    CHECK(fine.error <= accuracy);
    CHECK(fine.value < 1);
    const Estimate alone = hemisphere(build(diffuse(shadowed(describe("ggx", 0.5), "none"))), o, inputs(1e-4, 1e-3));
    CHECK(alone.value > fine.value);
    CHECK(alone.value < 1);
  }
  // The same by Monte Carlo-free brute force: a midpoint rule over the hemisphere.
  const Material m = build(diffuse(describe("beckmann", 0.7, "v_cavity")));
  const Direction o = from_angles(1.1, 0);
  double sum = 0;
  constexpr int rows = 24, columns = 24;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double theta = (row + 0.5) * 0.5 * std::numbers::pi / rows;
      const Direction i = from_angles(theta, (column + 0.5) * std::numbers::pi / columns);
      sum += std::sin(theta) * std::cos(theta) * diffuse_brdf(m.surface(), o, i, {.relative = 1e-3}).value;
    }
  sum *= 2 * 0.5 * std::numbers::pi / rows * std::numbers::pi / columns;
  CHECK(compute(Integral::albedo, m, o, 1e-3).value == doctest::Approx(sum).epsilon(3e-3));
}

TEST_CASE("Eq. 37 holds for what is physically based, and is the double integral that the paper writes") {
  for (const auto* masking : {"smith", "v_cavity"})
    for (const auto& description :
         {describe("beckmann", 0.1, masking), general("ggx", 0.3, 0.8, 0.5, {0.1, 0.2}, masking)})
      for (const double theta : {0.0, 0.8, 1.2}) {
        const Estimate e = diffuse_weak_furnace(build_microsurface(description), from_angles(theta, 1), 1e-9);
        CHECK(std::fabs(e.value - 1) <= e.error + 1e-12);
        CHECK(e.error <= 1e-9);
      }
  // The order of the paper: for every direction of the light, on either side of the surface, the facets that see it.
  const Material m = material("ggx", 0.6, "schlick_smith");
  const Direction o = from_angles(1.0, 0);
  struct Facet {
    Direction normal;
    double seen; ///< of o, <o,m> D(m) sin(theta_m)
  };
  std::vector<Facet> facets;
  for (int a = 0; a < 50; ++a)
    for (int b = 0; b < 50; ++b) {
      const double theta = (a + 0.5) * 0.5 * std::numbers::pi / 50;
      const Direction normal = from_angles(theta, (b + 0.5) * 2 * std::numbers::pi / 50);
      facets.push_back(
          {normal, std::sin(theta) * std::max(0.0, dot(o, normal)) * value_at_normal(m, Quantity::d, o, normal)});
    }
  constexpr int rows = 60, columns = 60;
  double sum = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double z = -1 + 2 * (row + 0.5) / rows;
      const Direction i = from_angles(std::acos(z), (column + 0.5) * std::numbers::pi / columns);
      double inner = 0;
      for (const Facet& facet : facets) inner += facet.seen * std::max(0.0, dot(i, facet.normal));
      sum += inner * 0.5 * std::numbers::pi / 50 * 2 * std::numbers::pi / 50;
    }
  sum *= g1(m, o) * 2 * 2.0 / rows * std::numbers::pi / columns / (std::numbers::pi * o.z);
  CHECK(diffuse_weak_furnace(m.surface(), o, 1e-9).value == doctest::Approx(sum).epsilon(3e-3));
}

TEST_CASE("every distribution covers the ground once") {
  for (const auto& description : {describe("beckmann", 0.01), describe("ggx", 2), describe("phong", 0.3),
                                  general("ggx", 0.1, 1, -0.9, {1, -2})}) {
    const Estimate e = ground_area(build_microsurface(description), 1e-10);
    INFO(description.name);
    CHECK(std::fabs(e.value - 1) <= e.error + 1e-13);
    CHECK(e.error <= 1e-10);
  }
}

TEST_CASE("mixtures of very different widths: Eqs. 13, 18, 36, 37, D, and diffuse facets are those of their parts") {
  const std::vector<WeightedChoices> mixtures = {
      {{0.5, describe("ggx", 0.01).distribution}, {0.5, describe("beckmann", 1).distribution}},
      {{0.5, describe("beckmann", 1e-5).distribution}, {0.5, general("beckmann", 0.5, 1, 0).distribution}},
      {{0.3, general("beckmann", 0.001, 1, 0).distribution}, {0.7, general("beckmann", 1, 0.001, 0).distribution}},
      {{0.5, general("ggx", 0.005, 1, 0.3, {0.1, 0.2}).distribution},
       {0.4, general("ggx", 1, 0.01, 0, {0.1, 0.2}).distribution},
       {0.1, general("ggx", 1e-4, 2e-4, 0, {0.1, 0.2}).distribution}}};
  for (const WeightedChoices& components : mixtures)
    for (const auto* masking : {"smith", "v_cavity"}) {
      if (sampled() && (&components - mixtures.data()) % 2 != (masking[0] == 's' ? 0 : 1)) continue;
      TermDescription description = diffuse(mixture(components));
      description.masking.type = masking;
      const Material m = build(description);
      const Estimate ground = ground_area(m.surface(), 1e-8);
      CHECK(std::fabs(ground.value - 1) <= ground.error);
      CHECK(ground.error <= 1e-8);
      for (const double theta : sample_of<double>({0.7, 0.0, 1.5}, 3)) {
        const Direction o = from_angles(theta, 0.4), i = from_angles(0.9, 1.5);
        const double c = m.surface().slopes().project(o).c;
        if (!(c > 0)) continue;
        INFO(description.name << " with " << description.masking.type << ", theta_o = " << theta);
        for (const auto integral : {Integral::projected_area, Integral::visible_norm, Integral::weak_furnace}) {
          const double exact = integral == Integral::projected_area ? c : 1;
          for (const Estimate& e : {compute(integral, m, o, 1e-8), compute_in_plane(integral, m, o, 1e-8)}) {
            CHECK(std::fabs(e.value - exact) <= e.error + 1e-13);
            CHECK(e.error <= 1e-8);
          }
        }
        const Estimate furnace = diffuse_weak_furnace(m.surface(), o, 1e-8);
        CHECK(std::fabs(furnace.value - 1) <= furnace.error);
        CHECK(furnace.error <= 1e-8);
        // Eq. 31 is linear in D where G2 is given.
        double sum = 0;
        for (const WeightedChoice& part : components) {
          TermDescription alone = diffuse(description);
          alone.distribution = part.model;
          const Material one = build(alone);
          const double masked =
              m.surface().has_lambda() ? value(m, Quantity::g2, o, i) / value(one, Quantity::g2, o, i) : 1;
          sum += part.weight * masked * diffuse_brdf(one.surface(), o, i, {.relative = 1e-12}).value;
        }
        const Estimate brdf = diffuse_brdf(m.surface(), o, i);
        CHECK(std::fabs(brdf.value - sum) <= brdf.error + 1e-12 * sum);
        CHECK(brdf.error <= 1e-9 * brdf.value);
      }
    }
}
