// What every distribution must satisfy, for all of the list, and what is particular to some.
#include "../materials.hpp"
#include "analysis/integrals.hpp"
#include "math/quadrature.hpp"
#include "models/registry.hpp"

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <vector>

using namespace test;

namespace {

/// int D cos dm over the hemisphere in polar coordinates, which the library's own integrals do not use. `width`: where
/// the mass is.
double area(const Material& m, double width, double phi_step = 0.0981747704246810387) {
  double sum = 0;
  for (double phi = 0; phi < 2 * std::numbers::pi - 1e-9; phi += phi_step) { // periodic: the trapezoid converges fast
    const auto f = [&](const double* v, double* y, std::size_t n) {
      for (std::size_t k = 0; k < n; ++k) {
        const double theta = std::atan(width * std::tan(v[k]));
        const double slope = std::tan(v[k]);
        const double jacobian = width * (1 + slope * slope) / (1 + width * width * slope * slope);
        const Direction normal = from_angles(theta, phi);
        y[k] = value_at_normal(m, Quantity::d_cos, {0, 0, 1}, normal) * std::sin(theta) * jacobian;
      }
    };
    const std::array<double, 3> cuts = {0, 0.8, std::numbers::pi / 2};
    sum += integrate(f, cuts, {.absolute = 1e-12}).value;
  }
  return sum * phi_step;
}

} // namespace

TEST_CASE("the distributions of these tests are all that there are") {
  std::set<std::string> tested;
  for (const auto& description : every_distribution()) tested.insert(description.distribution.type);
  for (const auto& spec : specs_of<Distribution>()) CHECK_MESSAGE(tested.count(spec.type) == 1, spec.type);
}

TEST_CASE("every distribution of the list: int D cos = 1") {
  for (const auto& description : every_distribution()) {
    INFO(description.name);
    const Material m = build(description);
    const SlopeMap& map = m.surface().slopes();
    const bool symmetric = map.centred() && map.correlation == 0 && map.alpha_x == map.alpha_y;
    const double step = symmetric ? std::numbers::pi : 2 * std::numbers::pi / 1024;
    CHECK(area(m, std::min(map.alpha_x, map.alpha_y), step) == doctest::Approx(1).epsilon(1e-8));
  }
}

TEST_CASE("every distribution of the list: p22 is D cos^4, and D is finite and 0 below the surface") {
  for (const auto& description : every_distribution()) {
    INFO(description.name);
    const Material m = build(description);
    for (const double theta : {0.0, 1e-300, 1e-9, 0.3, 0.9, 1.3, 1.5707, std::numbers::pi / 2, 1.6, 3.0}) {
      const Direction normal = from_angles(theta, 0.7);
      const double d = value_at_normal(m, Quantity::d, {0, 0, 1}, normal);
      CHECK(std::isfinite(d));
      CHECK(d >= 0);
      if (theta > std::numbers::pi / 2) CHECK(d == 0);
      const double p22 = value_at_normal(m, Quantity::p22, {0, 0, 1}, normal);
      if (theta < 1.5 && p22 > 1e-280)
        CHECK(relative(p22, d * std::pow(normal.z, 4)) < 1e-12 * (1 + std::fabs(std::log(p22))));
    }
  }
}

TEST_CASE("every distribution of the list: Lambda is 0 at the normal, falls towards it, and c Lambda ends finite") {
  for (const auto& description : every_distribution()) {
    INFO(description.name);
    const Material m = build(description);
    if (!m.surface().has_lambda()) continue;
    double before = 0;
    for (const double theta : {0.0, 1e-8, 0.01, 0.2, 0.8, 1.2, 1.5, 1.57, 1.5707963}) {
      const Direction o = from_angles(theta, 0.4);
      const double c = m.surface().slopes().project(o).c;
      if (!(c > 0)) continue;
      const double is = lambda(m, o);
      CHECK(is >= before);
      CHECK(std::isfinite(c * is));
      if (theta == 0) CHECK(is == 0);
      before = is;
    }
  }
}

TEST_CASE("every distribution of the list: visible normals are normalised at phi = 0, 45, 90 degrees") {
  for (const auto& description : every_distribution()) {
    const Material m = build(description);
    for (const double phi : {0.0, 45.0, 90.0})
      for (const double theta : {0.1, 1.0, 1.5}) {
        INFO(description.name << ", theta = " << theta << ", phi = " << phi);
        const Direction o = from_angles(theta, phi * degree);
        if (!(m.surface().slopes().project(o).c > 0.01)) continue;
        const Estimate norm = compute(Integral::visible_norm, m, o, 1e-8);
        // Normals whose density is infinite at the horizon (student_t, gamma < 2) take the integral longer than it has.
        CHECK(norm.error <= (description.distribution.type == "student_t" ? 1e-5 : 1e-8));
        CHECK(std::fabs(norm.value - 1) <= norm.error);
      }
  }
}

TEST_CASE("every distribution is normalised: int D cos = 1") {
  for (const auto* type : {"beckmann", "ggx"})
    for (const double alpha : {1e-3, 0.05, 0.5, 1.0, 10.0}) {
      INFO(type << ", alpha = " << alpha);
      CHECK(area(material(type, alpha), alpha) == doctest::Approx(1).epsilon(1e-9));
    }
  for (const double alpha : {1e-3, 0.05, 0.5, 1.0, 1.3})
    CHECK(area(material("phong", alpha), alpha) == doctest::Approx(1).epsilon(1e-9));
  for (const double alpha : {1e-3, 0.05, 0.5, 1.0, 3.0})
    for (const double gamma : {0.1, 0.5, 1.0, 2.0, 3.5, 10.0}) {
      INFO("gtr, alpha = " << alpha << ", gamma = " << gamma);
      CHECK(area(gtr(alpha, gamma), alpha) == doctest::Approx(1).epsilon(1e-9));
    }
}

TEST_CASE("anisotropic, correlated and sheared distributions are normalised") {
  for (const auto* type : {"beckmann", "ggx"}) {
    INFO(type);
    CHECK(area(build(general(type, 0.3, 0.6, 0)), 0.4) == doctest::Approx(1).epsilon(1e-8));
    CHECK(area(build(general(type, 0.3, 0.6, -0.7)), 0.4, 0.01227184630308513) == doctest::Approx(1).epsilon(1e-8));
    CHECK(area(build(general(type, 0.5, 0.4, 0.5, {0.3, -0.2})), 0.5, 0.01227184630308513) ==
          doctest::Approx(1).epsilon(1e-8));
  }
}

TEST_CASE("p22 is D cos^4, at the slope of the normal") {
  for (const auto& m : {material("beckmann", 0.4), material("phong", 0.4), gtr(0.4, 1.3),
                        build(general("ggx", 0.3, 0.7, 0.4, {0.2, 0.1}))})
    for (const double theta : {0.0, 0.3, 0.9, 1.3}) {
      const Direction normal = from_angles(theta, 0.7);
      const double d = value_at_normal(m, Quantity::d, {0, 0, 1}, normal);
      CHECK(relative(value_at_normal(m, Quantity::p22, {0, 0, 1}, normal), d * std::pow(normal.z, 4)) < 1e-13);
    }
}

TEST_CASE("D is finite, 0 or more, and 0 below the surface, at the ends of the domain") {
  for (const double alpha : {1e-6, 1e-3, 1.0, 1e3})
    for (const auto* type : {"beckmann", "ggx"})
      for (const double theta : {0.0, 1e-300, 1e-160, 1e-8, 0.5, 1.5707963267948, std::numbers::pi / 2, 1.6, 3.0}) {
        INFO(type << ", alpha = " << alpha << ", theta = " << theta);
        const double d = value_at_normal(material(type, alpha), Quantity::d, {0, 0, 1}, from_angles(theta, 2));
        CHECK(std::isfinite(d));
        CHECK(d >= 0);
        if (theta > std::numbers::pi / 2) CHECK(d == 0);
      }
}

TEST_CASE("GTR is continuous through gamma = 1 and alpha = 1") {
  const Direction normal = from_angles(0.7, 0);
  const auto d = [&](double alpha, double gamma) {
    return value_at_normal(gtr(alpha, gamma), Quantity::d, {0, 0, 1}, normal);
  };
  for (const double step : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    CHECK(std::fabs(d(0.3, 1 + step) / d(0.3, 1) - 1) < 3 * step + 1e-15);
    CHECK(std::fabs(d(0.3, 1 - step) / d(0.3, 1) - 1) < 3 * step + 1e-15);
    CHECK(std::fabs(d(1 + step, 2.5) * std::numbers::pi - 1) < 8 * step + 1e-15);
    CHECK(std::fabs(d(1 - step, 0.5) * std::numbers::pi - 1) < 8 * step + 1e-15);
  }
  CHECK(d(1, 3) == doctest::Approx(1 / std::numbers::pi).epsilon(1e-15));
}

TEST_CASE("GTR's normalisation is that of RTR4, Eq. 9.47, where the print can be evaluated") {
  for (const double alpha : {0.02, 0.5, 2.0})
    for (const double gamma : {0.5, 2.0, 3.5, 10.0}) {
      const double printed = (gamma - 1) * (alpha * alpha - 1) / (1 - std::pow(alpha * alpha, 1 - gamma));
      CHECK(std::exp(gtr_log_normalization(alpha, gamma)) == doctest::Approx(printed).epsilon(1e-12));
    }
  CHECK(std::exp(gtr_log_normalization(0.5, 1)) == doctest::Approx((0.25 - 1) / std::log(0.25)).epsilon(1e-14));
}

TEST_CASE("Phong by alpha is Phong by exponent") {
  TermDescription by_exponent = describe("phong", 1);
  by_exponent.distribution.values = {};
  by_exponent.distribution.values.set("exponent", 2 / 0.09 - 2);
  const Direction normal = from_angles(0.4, 0);
  CHECK(relative(value_at_normal(build(by_exponent), Quantity::d, {0, 0, 1}, normal),
                 value_at_normal(material("phong", 0.3), Quantity::d, {0, 0, 1}, normal)) < 1e-13);
}

TEST_CASE("Phong by gloss is Phong by exponent, 1 to 8192") {
  for (const auto& [gloss, exponent] : {std::pair(0.0, 1.0), std::pair(3.0 / 13, 8.0), std::pair(1.0, 8192.0)}) {
    const Material by_gloss = build(distribution("phong", {{"gloss", gloss}}));
    const Material by_exponent = build(distribution("phong", {{"exponent", exponent}}));
    const Direction normal = from_angles(0.1, 0);
    CHECK(relative(value_at_normal(by_gloss, Quantity::d, {0, 0, 1}, normal),
                   value_at_normal(by_exponent, Quantity::d, {0, 0, 1}, normal)) < 1e-13);
  }
}

TEST_CASE("anisotropy by alpha_x, alpha_y, correlation is a rotated pair of principal roughnesses") {
  // Heitz 2014, Eq. 92 with the corrected signs: principal (a1, a2) turned by b.
  const double a1 = 0.7, a2 = 0.2, b = 0.6, c = std::cos(b), s = std::sin(b);
  const double ax = std::sqrt(c * c * a1 * a1 + s * s * a2 * a2);
  const double ay = std::sqrt(s * s * a1 * a1 + c * c * a2 * a2);
  const double r = (a1 * a1 - a2 * a2) * s * c / (ax * ay);
  for (const auto* type : {"beckmann", "ggx"}) {
    const Material turned = build(general(type, ax, ay, r));
    const Material straight = build(general(type, a1, a2, 0));
    for (const double phi : {0.0, 0.5, 1.7, 4.0}) {
      const Direction direction = from_angles(1.2, phi), back = from_angles(1.2, phi - b);
      CHECK(relative(lambda(turned, direction), lambda(straight, back)) < 1e-12);
      CHECK(relative(value_at_normal(turned, Quantity::d, direction, direction),
                     value_at_normal(straight, Quantity::d, back, back)) < 1e-11);
    }
  }
}

TEST_CASE("extreme anisotropy and correlation stay finite") {
  for (const auto* type : {"beckmann", "ggx"})
    for (const double r : {0.0, 0.999999999, -0.999999999})
      for (const double phi : {0.0, 0.3, 1.5707963, 2.0}) {
        const Material m = build(general(type, 1e-2, 1e2, r));
        const Direction o = from_angles(1.3, phi);
        CHECK(std::isfinite(lambda(m, o)));
        CHECK(lambda(m, o) >= 0);
        CHECK(std::isfinite(value_at_normal(m, Quantity::d, o, from_angles(0.8, phi))));
      }
}

TEST_CASE("every model of every list has a name of its own, a line of doc, a source, and documented parameters") {
  const auto check = [](const std::vector<ModelSpec>& specs) {
    std::set<std::string> names;
    for (const auto& spec : specs) {
      INFO(spec.type);
      CHECK(names.insert(spec.type).second);
      CHECK_FALSE(spec.doc.empty());
      CHECK_FALSE(spec.source.empty());
      for (const auto& parameter : spec.parameters) CHECK_FALSE(parameter.doc.empty());
    }
  };
  CHECK(&specs_of<Distribution>() == &specs_of<Distribution>()); // made once
  check(specs_of<Distribution>());
  check(specs_of<Masking>());
  check(specs_of<Shadowing>());
  check(specs_of<Fresnel>());
}
