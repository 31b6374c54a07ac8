#include "materials.hpp"

#include "base/errors.hpp"
#include "sampling/cosine.hpp"
#include "sampling/points.hpp"
#include "sampling/sampler.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace test;

namespace {

TermDescription lambert() {
  TermDescription description;
  description.type = description.name = "lambert";
  return description;
}

std::string refusal(const Material& material, const std::string& strategy) {
  try {
    const Sampler sampler(material, strategy);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

double density(const Sampler& sampler, const Direction& o, const Direction& i) {
  double value = 0;
  sampler.densities(1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, &value);
  return value;
}

} // namespace

TEST_CASE("a strategy that a term has not is an error that says what each has") {
  const Material both = build(MaterialDescription("both", {describe("ggx", 0.3), lambert()}, true));
  const std::string all = refusal(both, "visible_normals");
  CHECK(all.find("both: the term \"lambert\" has no strategy \"visible_normals\"") == 0);
  CHECK(all.find("\"lambert\": cosine") != std::string::npos);
  CHECK(all.find("\"ggx with smith\": cosine, half_vector, visible_normals") != std::string::npos);
  CHECK(refusal(both, "default").empty());
  CHECK(refusal(both, "cosine").empty());
  CHECK(refusal(both, "halfvector").find("half_vector") != std::string::npos);
  TermDescription steep = test::distribution("oren_nayar", {{"sigma", 0.5}});
  steep.masking.type = "v_cavity";
  CHECK(refusal(build(steep), "visible_normals").find("has no strategy") != std::string::npos);
  CHECK(refusal(build(steep), "half_vector").empty());
}

TEST_CASE("by default: what is seen where masking has a Lambda, half vectors where not, else the cosine") {
  CHECK(default_strategy(material("ggx", 0.3).terms[0]) == Strategy::visible_normals);
  CHECK(default_strategy(material("ggx", 0.3, "v_cavity").terms[0]) == Strategy::half_vector);
  CHECK(default_strategy(build(lambert()).terms[0]) == Strategy::cosine);
}

TEST_CASE("directions are of unit length, with a density, at the ends of the cube, of angles and of roughness") {
  for (const auto* type : {"beckmann", "ggx", "student_t", "exponential_power"})
    for (const auto& [alpha_x, alpha_y] : {std::pair(1e-4, 1e-4), std::pair(1e-4, 0.1), std::pair(1.0, 1e-3)}) {
      TermDescription description = general(type, alpha_x, alpha_y, 0.3);
      if (std::string(type) == "student_t") description.distribution.values.set("gamma", 2.5);
      if (std::string(type) == "exponential_power") description.distribution.values.set("p", 0.7);
      const Material material = build(description);
      for (const auto* strategy : {"cosine", "half_vector", "visible_normals"})
        for (const double theta : {0.0, 1e-9, 0.8, 89.9 * degree, 0.5 * std::numbers::pi})
          for (const double u1 : {0.0, 0.5, 1 - 0x1p-53})
            for (const double u2 : {0.0, 0.5, 1 - 0x1p-53}) {
              CAPTURE(description.name);
              CAPTURE(strategy);
              CAPTURE(theta);
              CAPTURE(u1);
              CAPTURE(u2);
              const Direction o = from_angles(theta, 0.7);
              const Sampler sampler(material, strategy);
              const Direction i = Sampler::Viewer(sampler, o).sample({u1, u2, 1 - 0x1p-53});
              CHECK(std::fabs(dot(i, i) - 1) < 1e-14);
              const double pdf = density(sampler, o, i);
              CHECK(pdf >= 0);
              CHECK(std::isfinite(pdf));
            }
    }
}

TEST_CASE("the weight of visible normals is G2 / G1 F, whatever the roughness") {
  for (const double alpha : {1e-4, 0.1, 1.0}) {
    const Material m = build(shadowed(describe("ggx", alpha), "none"));
    const Sampler sampler(m, "visible_normals");
    for (const double theta : {0.0, 0.7, 1.5}) {
      const Direction o = from_angles(theta, 0.3);
      const Sampler::Viewer viewer(sampler, o);
      for (const SamplePoint& point : points(PointKind::sobol, 1, 1, 0, 64)) {
        const Direction i = viewer.sample(point);
        const double f = value(m, Quantity::brdf_cos, o, i);
        if (i.z > 0) CHECK(f / density(sampler, o, i) == doctest::Approx(1).epsilon(1e-9)); // shadowing: none
      }
    }
  }
}

TEST_CASE("nothing is drawn from below the mesosurface") {
  const Material m = build(general("ggx", 0.2, 0.4, 0, {1, 0}));
  const Sampler sampler(m, "default");
  const Direction below = from_angles(60 * degree, 0);
  REQUIRE(m.mesosurface().project(below).c < 0);
  const Direction i = Sampler::Viewer(sampler, below).sample({0.3, 0.4, 0.5});
  CHECK(i.x == doctest::Approx(-std::numbers::sqrt2 / 2));
  CHECK(density(sampler, below, i) == 0);
}

TEST_CASE("points are the same in whatever parts they are asked for, and differ between streams and seeds") {
  for (const PointKind kind : {PointKind::random, PointKind::sobol}) {
    const auto all = points(kind, 7, 3, 0, 1000), part = points(kind, 7, 3, 400, 100);
    for (std::size_t k = 0; k < part.size(); ++k) CHECK(part[k] == all[400 + k]);
    CHECK(points(kind, 8, 3, 0, 1)[0] != all[0]);
    CHECK(points(kind, 7, 4, 0, 1)[0] != all[0]);
    for (const SamplePoint& point : all)
      for (const double u : point) CHECK((u > 0 && u < 1));
  }
  // 2^8 points of Sobol's sequence, shifted digit by digit, have one in each interval of 2^-8, along each axis.
  for (std::size_t d = 0; d < 3; ++d) {
    std::set<int> cells;
    for (const SamplePoint& point : points(PointKind::sobol, 7, 3, 0, 256))
      cells.insert(static_cast<int>(256 * point[d]));
    CHECK(cells.size() == 256);
  }
  CHECK(point_kind("sobol", "--points") == PointKind::sobol);
  CHECK_THROWS_WITH_AS((void)point_kind("soboll", "--points"), doctest::Contains("sobol"), InputError);
}

TEST_CASE("a choice by shares keeps its number uniform") {
  double u = 0.3;
  CHECK(chosen({0.25, 0, 0.75}, u) == 2);
  CHECK(u == doctest::Approx(0.05 / 0.75));
  u = 1 - 0x1p-53;
  CHECK(chosen({0.5, 0.5 - 1e-12, 0}, u) == 1);
  CHECK(u < 1);
}
