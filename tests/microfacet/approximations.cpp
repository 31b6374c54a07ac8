// The approximations of real-time rendering to masking and shadowing, against the equations as they are printed, with
// 50 digits.
#include "../materials.hpp"
#include "base/errors.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

using namespace test;

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

constexpr double alphas[] = {1e-6, 1e-3, 0.3, 1.0, 2.0, 50.0, 1e6};
constexpr double cosines[] = {1e-300, 1e-100, 1e-8, 0.01, 0.3, 0.7, 0.999, 1 - 1e-12};

/// Of one z exactly, and of length 1 within a rounding.
Direction with_cosine(double z, double phi) {
  const double s = std::sqrt((1 - z) * (1 + z));
  return {s * std::cos(phi), s * std::sin(phi), z};
}

Real karis(const Real& c, const Real& alpha) { return 2 * c / (c * (2 - alpha) + alpha); }

/// RTR 9.45, times 4 NL NV.
Real hammon(const Real& l, const Real& v, const Real& alpha) {
  return 2 * l * v / (2 * l * v * (1 - alpha) + (l + v) * alpha);
}

Real neubelt(const Real& l, const Real& v) { return l * v / (l + v - l * v); }

double relative_to(double is, const Real& exact) {
  return std::fabs(static_cast<double>(Real((Real(is) - exact) / exact)));
}

} // namespace

TEST_CASE("approximations: Karis's masking is Eq. 9.44, for every roughness and angle") {
  for (const auto* type : {"ggx", "beckmann"})
    for (const double alpha : alphas) {
      const Material m = material(type, alpha, "karis");
      for (const double c : cosines) {
        INFO(type << ", alpha = " << alpha << ", c = " << c);
        CHECK(relative_to(g1(m, with_cosine(c, 0.4)), karis(c, alpha)) < 2e-15);
      }
      CHECK(g1(m, {0, 0, 1}) == 1);
      CHECK(g1(m, {1, 0, 0}) == 0);
    }
}

TEST_CASE("approximations: Hammon's shadowing is Eq. 9.45 and Neubelt's that of Eq. 9.74, whatever masks") {
  for (const auto* masking : {"smith", "karis", "implicit", "v_cavity"})
    for (const double alpha : alphas) {
      const Material h = build(shadowed(describe("ggx", alpha, masking), "hammon"));
      const Material n = build(shadowed(describe("ggx", alpha, masking), "neubelt"));
      for (const double v : cosines)
        for (const double l : cosines) {
          const Direction o = with_cosine(v, 0.4), i = with_cosine(l, 2.9);
          INFO(masking << ", alpha = " << alpha << ", v = " << v << ", l = " << l);
          if (v * l > 1e-250) { // else G2 itself is subnormal, or its steps are
            CHECK(relative_to(value(h, Quantity::g2, o, i), hammon(l, v, alpha)) < 3e-15);
            CHECK(relative_to(value(n, Quantity::g2, o, i), neubelt(l, v)) < 3e-15);
          }
          CHECK(relative(value(h, Quantity::g2, o, i), value(h, Quantity::g2, i, o)) < 1e-15);
          CHECK(std::isfinite(value(n, Quantity::brdf_cos, o, i)));
        }
    }
}

TEST_CASE("approximations: shadowing that does without Lambda asks for none") {
  // A formula of Lambda that is no number is an error where it is asked.
  for (const auto* shadowing : {"hammon", "neubelt", "height_correlated"}) {
    TermDescription term = shadowed(describe("velvet", 0.5, "custom"), shadowing);
    term.masking.values.set("lambda", std::string("log(cos_theta - 2)"));
    const Material m = build(term);
    const Direction o = from_angles(1.2, 0), i = from_angles(0.7, 2);
    INFO(shadowing);
    if (shadowing == std::string("height_correlated"))
      CHECK_THROWS_AS(value(m, Quantity::brdf, o, i), InputError);
    else
      CHECK(value(m, Quantity::brdf, o, i) ==
            value(build(shadowed(describe("velvet", 0.5), shadowing)), Quantity::brdf, o, i));
  }
}

TEST_CASE("approximations: with them a mirror is F D / (4 V) as printed") {
  for (const auto* type : {"ggx", "beckmann", "velvet"})
    for (const double phi : {0.3, 1.9, 3.1}) {
      const Direction o = from_angles(1.2, 0), i = from_angles(0.7, phi), half = half_vector(o, i);
      const double d = value_at_normal(material(type, 0.4), Quantity::d, o, half);
      const auto mirror = [&](const char* shadowing) {
        return value(build(shadowed(describe(type, 0.4), shadowing)), Quantity::brdf, o, i);
      };
      CHECK(mirror("neubelt") == doctest::Approx(d / (4 * (o.z + i.z - o.z * i.z))).epsilon(1e-14));
      if (std::string(type) == "velvet") continue; // its alpha is not the width of its slopes
      CHECK(mirror("hammon") == doctest::Approx(0.5 * d / (0.6 * 2 * o.z * i.z + 0.4 * (o.z + i.z))).epsilon(1e-14));
    }
}

TEST_CASE(
    "approximations: Hammon's is Karis's with correlated heights, on surfaces that are stretched and tilted too") {
  const auto description = [](const std::string& shadowing) {
    return shadowed(general("ggx", 0.2, 0.6, -0.5, {0.2, -0.1}, "karis"), shadowing);
  };
  const Material hammon_of = build(description("hammon")), heights = build(description("height_correlated"));
  // The factor is one of the direction alone: alpha_o of it, and the cosine after the shear.
  const SlopeMap& map = hammon_of.surface().slopes();
  for (const double theta : {1e-9, 0.3, 1.1, 1.5})
    for (const double phi : {0.0, 1.0, 2.0, 4.0}) {
      const Direction o = from_angles(theta, phi), i = from_angles(0.8, 1.3);
      CHECK(relative(value(hammon_of, Quantity::g2, o, i), value(heights, Quantity::g2, o, i)) < 1e-15);
      const Projection p = map.project(o);
      const double h = std::hypot(o.x, o.y), c = p.c / std::hypot(h, p.c), alpha = p.s / h;
      if (p.c > 0) CHECK(g1(heights, o) == doctest::Approx(2 * c / (c * (2 - alpha) + alpha)).epsilon(1e-13));
    }
  // The same surface, sheared: the same shadowing.
  const Material flat = build(shadowed(general("ggx", 0.4, 0.4, 0), "neubelt"));
  const Material tilted = build(shadowed(general("ggx", 0.4, 0.4, 0, {0.5, 0}), "neubelt"));
  const auto sheared = [](const Direction& d) { return normalized({d.x, d.y, d.z + 0.5 * d.x}); };
  const Direction o = from_angles(1.0, 0.3), i = from_angles(0.6, 2.0);
  CHECK(relative(value(tilted, Quantity::g2, sheared(o), sheared(i)), value(flat, Quantity::g2, o, i)) < 1e-14);
}

TEST_CASE("approximations: how far they are from GGX's own") {
  // formulas: 0.1632 where c = 1.149 alpha, 0.2326 where both c = 1.611 alpha, for small alpha.
  double of_karis = 0, of_hammon = 0;
  for (const double alpha : {1e-4, 1e-2, 0.3, 1.0}) {
    const Material smith = material("ggx", alpha), fit = material("ggx", alpha, "karis");
    const Material hammons = build(shadowed(describe("ggx", alpha), "hammon"));
    for (int k = 1; k < 4000; ++k) {
      const double c = std::min(1.0, 5e-3 * k * alpha);
      const Direction o = with_cosine(c, 0), i = with_cosine(c, 2);
      of_karis = std::max(of_karis, std::fabs(g1(fit, o) - g1(smith, o)));
      of_hammon = std::max(of_hammon, std::fabs(value(hammons, Quantity::g2, o, i) - value(smith, Quantity::g2, o, i)));
    }
  }
  CHECK(of_karis == doctest::Approx(0.1632).epsilon(2e-3));
  CHECK(of_hammon == doctest::Approx(0.2326).epsilon(2e-3));
}
