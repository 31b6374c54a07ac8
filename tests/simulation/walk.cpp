#include "materials.hpp"

#include "analysis/integrals.hpp"
#include "base/random.hpp"
#include "microfacet/visible_normals.hpp"
#include "simulation/smith_profile.hpp"
#include "simulation/walk.hpp"

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <doctest/doctest.h>

using namespace test;
using namespace brdfplot::simulation;

namespace {

WalkResult walk_from(const Material& material, const Direction& o, std::vector<Direction> i = {},
                     std::size_t paths = 65536, Facets facets = Facets::conductor, int threads = 2) {
  return walk(material, facets, {o, std::move(i), paths, 1, threads});
}

Material diffuse(const std::string& distribution, double alpha) {
  TermDescription description = describe(distribution, alpha);
  description.type = "facet_diffuse";
  return build(description);
}

Measured energy(const WalkResult::ByBounce& from, std::size_t first, std::size_t last) {
  return WalkResult::energy(from, first, last).at(0);
}

Measured lobe_at(const WalkResult& result, std::size_t d, std::size_t first, std::size_t last) {
  return result.lobe_of(first, last).at(d);
}

Direction at_cosine(double mu, double phi = 0) { return from_angles(std::acos(mu), phi); }

/// |measured - truth| in standard errors, or in roundings where there is hardly anything random.
double score(const Measured& measured, double truth) {
  return std::fabs(measured.value - truth) / std::max(measured.standard_error, 1e-13 * std::fabs(truth));
}

Material with_fresnel(const std::string& distribution, double alpha, const std::string& type, const std::string& key,
                      double value) {
  TermDescription description = describe(distribution, alpha);
  description.fresnel = {.type = type, .values = {}};
  description.fresnel.values.set(key, value);
  return build(description);
}

/// A grid of directions over the upper or the lower hemisphere, with the solid angle of each.
struct Sphere {
  std::vector<Direction> directions;
  std::vector<double> solid_angles;
};

Sphere hemisphere(double from, double to, int thetas, int phis) {
  Sphere out;
  for (int t = 0; t < thetas; ++t)
    for (int p = 0; p < phis; ++p) {
      const double theta = from + (to - from) * (t + 0.5) / thetas;
      out.directions.push_back(from_angles(theta, 2 * std::numbers::pi * (p + 0.5) / phis));
      out.solid_angles.push_back(std::sin(theta) * (to - from) / thetas * 2 * std::numbers::pi / phis);
    }
  return out;
}

double integral_of_lobe(const WalkResult& result, const Sphere& sphere, std::size_t first, std::size_t last) {
  const Estimates lobe = result.lobe_of(first, last);
  double sum = 0;
  for (std::size_t d = 0; d < sphere.directions.size(); ++d) sum += lobe.at(d).value * sphere.solid_angles[d];
  return sum;
}

} // namespace

TEST_CASE("Lambda of falling rays is -1 - Lambda of rising ones, and sigma their projected area") {
  const SlopeMap slopes{.alpha_x = 0.4, .alpha_y = 0.9, .correlation = 0.6, .mean_x = 0.2, .mean_y = -0.1};
  const SmithProfile<GgxShape> ggx{slopes};
  const SmithProfile<BeckmannShape> beckmann{slopes};
  for (const double theta : {0.0, 1.0, 40.0, 89.0, 91.0, 140.0}) {
    const Direction o = from_angles(theta * degree, 2.1),
                    opposite = from_angles((180 - theta) * degree, 2.1 - std::numbers::pi);
    const double c = slopes.project(o).c;
    CHECK(ggx.Lambda(opposite) == doctest::Approx(-1 - ggx.Lambda(o)).epsilon(1e-12));
    CHECK(beckmann.Lambda(opposite) == doctest::Approx(-1 - beckmann.Lambda(o)).epsilon(1e-12));
    CHECK(ggx.sigma(o) == doctest::Approx(c * (1 + ggx.Lambda(o))).epsilon(1e-12));
    CHECK(ggx.sigma(o) - ggx.sigma(opposite) == doctest::Approx(c).epsilon(1e-12));
  }
}

TEST_CASE("the first bounce of the walk carries the energy of the height-correlated BRDF, all bounces carry 1") {
  struct Row {
    const char* distribution;
    double mu, alpha;
    double expected; ///< formulas: quadrature to 1e-4, or 0: none known but the library's
  };
  for (const Row& row : {Row{"ggx", 0.9, 0.5, 0.6840}, Row{"ggx", 0.6, 1, 0.4115}, Row{"ggx", 0.3, 0.5, 0.7453},
                         Row{"ggx", 0.1, 0.8, 0.8005}, Row{"beckmann", 0.9, 0.5, 0}, Row{"beckmann", 0.6, 1, 0},
                         Row{"beckmann", 0.05, 1, 0}}) {
    CAPTURE(row.distribution);
    CAPTURE(row.mu);
    const Material m = material(row.distribution, row.alpha);
    const Direction o = at_cosine(row.mu);
    const WalkResult result = walk_from(m, o, {}, 200000);
    const double albedo = compute_or_throw(Integral::albedo, m, o, 1e-7);
    if (row.expected > 0) CHECK(albedo == doctest::Approx(row.expected).epsilon(2e-4));
    CHECK(score(energy(result.reflected, 1, 1), albedo) < 3);
    CHECK(energy(result.reflected, 1, bounce_classes).value == doctest::Approx(1).epsilon(1e-12));
    CHECK(result.unfinished == 0);
  }
}

TEST_CASE("the single bounce of an anisotropic, correlated, tilted surface is its BRDF") {
  const Material m = build(general("beckmann", 0.3, 0.8, 0.5, {0.1, 0.2}));
  const Material g = build(general("ggx", 0.3, 0.8, -0.5, {0.1, 0.2}));
  const Direction o = from_angles(60 * degree, 0.4);
  std::vector<Direction> lights;
  for (int theta = -70; theta <= 70; theta += 20)
    for (const double phi : {0.4, 1.5}) lights.push_back(from_angles(theta * degree, phi));
  for (const Material* material : {&m, &g}) {
    const WalkResult result = walk_from(*material, o, lights, 20000);
    for (std::size_t d = 0; d < lights.size(); ++d)
      CHECK(score(lobe_at(result, d, 1, 1), value(*material, Quantity::brdf_cos, o, lights[d])) < 4);
    CHECK(score(energy(result.reflected, 1, 1), compute_or_throw(Integral::albedo, *material, o, 1e-7)) < 3);
  }
}

TEST_CASE("the lobe of every bounce integrates to the energy that leaves after it") {
  const Material m = material("ggx", 0.7);
  const Sphere sphere = hemisphere(0, std::numbers::pi / 2, 24, 24);
  const WalkResult result = walk_from(m, at_cosine(0.4), sphere.directions, 6400);
  for (const std::size_t bounce : {1U, 2U, 3U})
    CHECK(std::fabs(integral_of_lobe(result, sphere, bounce, bounce) - energy(result.reflected, bounce, bounce).value) <
          5 * energy(result.reflected, bounce, bounce).standard_error + 1e-3);
}

TEST_CASE("the walk is reciprocal, multiple bounces included, for conductors and diffuse facets") {
  const Direction a = from_angles(70 * degree, 0), b = from_angles(-20 * degree, 0.5);
  for (const Material& m : {with_fresnel("beckmann", 0.9, "schlick", "f0", 0.6), diffuse("beckmann", 0.9)}) {
    const auto there = lobe_at(walk_from(m, a, {b}, 100000), 0, 2, bounce_classes);
    const auto back = lobe_at(walk_from(m, b, {a}, 100000), 0, 2, bounce_classes);
    const double error = std::hypot(there.standard_error / b.z, back.standard_error / a.z);
    CHECK(std::fabs(there.value / b.z - back.value / a.z) < 3.5 * error);
    CHECK(there.value > 20 * there.standard_error);
  }
}

TEST_CASE("diffuse facets of albedo 1 lose nothing") {
  const WalkResult result = walk_from(diffuse("ggx", 1), at_cosine(0.3), {}, 6400);
  CHECK(energy(result.reflected, 1, bounce_classes).value == doctest::Approx(1).epsilon(1e-12));
  CHECK(result.unfinished == 0);
}

TEST_CASE("dielectric facets: all light leaves, above or below, and the first bounce is the BSDF") {
  const Material m = with_fresnel("ggx", 0.5, "dielectric", "eta", 1.5);
  const Direction o = at_cosine(0.5);
  const Sphere above = hemisphere(0, std::numbers::pi / 2, 24, 24);
  const Sphere below = hemisphere(std::numbers::pi / 2, std::numbers::pi, 24, 24);
  const WalkResult up = walk_from(m, o, above.directions, 6400, Facets::dielectric);
  const WalkResult down = walk_from(m, o, below.directions, 6400, Facets::dielectric);
  const auto reflected = energy(up.reflected, 1, bounce_classes);
  const auto transmitted = energy(up.transmitted, 1, bounce_classes);
  CHECK(reflected.value + transmitted.value == doctest::Approx(1).epsilon(1e-12));
  CHECK(score(energy(up.reflected, 1, 1), compute_or_throw(Integral::albedo, m, o, 1e-7)) < 3);
  CHECK(std::fabs(integral_of_lobe(up, above, 1, bounce_classes) - reflected.value) <
        4 * reflected.standard_error + 1e-3);
  CHECK(std::fabs(integral_of_lobe(down, below, 1, bounce_classes) - transmitted.value) <
        4 * transmitted.standard_error + 2e-3);
  // Walter et al. 2007, Eq. 21, with G2 = B(1 + Lambda_o, 1 + Lambda_i) (Heitz et al. 2016).
  const Direction i = from_angles(150 * degree, std::numbers::pi + 0.3);
  const double eta = 1.5;
  Direction h = normalized(o + eta * i);
  if (h.z < 0) h = -1.0 * h;
  const double in = dot(o, h), out = dot(i, h);
  const Direction mirrored{-i.x, -i.y, -i.z};
  const double g2 = boost::math::beta(1 + test::lambda(m, o), 1 + test::lambda(m, mirrored));
  const double truth = (1 - dielectric_reflectance(in, eta)) * in * -out * eta * eta / std::pow(in + eta * out, 2) *
                       value_at_normal(m, Quantity::d, o, h) * g2 / o.z;
  CHECK(score(lobe_at(walk_from(m, o, {i}, 100000, Facets::dielectric), 0, 1, 1), truth) < 3);
}

TEST_CASE("the mean Fresnel reflectance at the first bounce is Eq. 105") {
  const Material m = with_fresnel("beckmann", 0.5, "schlick", "f0", 0.04);
  const Direction o = from_angles(75 * degree, 0);
  // int F D_o dm, on a grid of normals.
  const Sphere normals = hemisphere(0, std::numbers::pi / 2, 400, 400);
  double truth = 0;
  for (std::size_t k = 0; k < normals.directions.size(); ++k) {
    const Direction& n = normals.directions[k];
    truth += value_at_normal(m, Quantity::d_visible, o, n) * value_at_normal(m, Quantity::fresnel, o, n) *
             normals.solid_angles[k];
  }
  CHECK(score(walk_from(m, o, {}, 100000).mean_fresnel(1, 1).at(0), truth) < 3);
}

TEST_CASE("walks are the same for any number of threads, and other ones for another seed") {
  const Material m = material("beckmann", 0.8);
  const std::vector<Direction> lights = {from_angles(0.3, 0), from_angles(-1, 2)};
  const WalkResult one = walk_from(m, at_cosine(0.5), lights, 1000, Facets::conductor, 1);
  const WalkResult three = walk_from(m, at_cosine(0.5), lights, 1000, Facets::conductor, 3);
  const WalkResult other = walk(m, Facets::conductor, {at_cosine(0.5), lights, 1000, 2, 1});
  CHECK(one.lobe == three.lobe);
  CHECK(one.reflected == three.reflected);
  CHECK(one.reflected != other.reflected);
  CHECK(one.paths == 1024);
}

TEST_CASE("the law of heights changes nothing: walks through Gaussian and uniform heights") {
  // Heitz et al. 2016 as written, in heights: a GGX conductor, the energy of the first bounce.
  const SmithProfile<GgxShape> profile{{.alpha_x = 0.5, .alpha_y = 0.5}};
  const auto run = [&](const auto& c1, const auto& inverse) {
    constexpr int paths = 100000;
    int single = 0;
    for (int k = 0; k < paths; ++k) {
      Random random(3, static_cast<std::uint64_t>(k));
      Direction omega{-std::sqrt(0.19), 0, -0.9};
      double h = 1 + inverse(0.999);
      for (int bounces = 0;; ++bounces) {
        const double u = random.uniform(), Lambda = profile.Lambda(omega);
        const double g1 = omega.z > 0 ? std::pow(c1(h), Lambda) : 0;
        if (u > 1 - g1) {
          single += bounces == 1;
          break;
        }
        h = inverse(c1(h) / std::pow(1 - u, 1 / Lambda));
        const Direction v = -1.0 * omega;
        omega = reflected(v, sample_visible_normal<GgxShape>(profile.slopes, v, random));
      }
    }
    const double p = single / double{paths};
    return Measured{p, std::sqrt(p * (1 - p) / paths)};
  };
  const auto gaussian =
      run([](double h) { return 0.5 * std::erfc(-h / std::numbers::sqrt2); },
          [](double c) { return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * std::max(c, 1e-300)); });
  const auto uniform =
      run([](double h) { return std::clamp(0.5 * (h + 1), 0.0, 1.0); }, [](double c) { return 2 * c - 1; });
  CHECK(score(gaussian, 0.6840) < 3);
  CHECK(score(uniform, 0.6840) < 3);
}

TEST_CASE("what the walk cannot do it says") {
  CHECK_THROWS_AS(walk_from(test::gtr(0.5, 3), at_cosine(0.5)), InputError);
  CHECK_THROWS_AS(walk_from(material("ggx", 0.5), at_cosine(0.5), {}, 64, Facets::dielectric), InputError);
  CHECK_THROWS_AS(walk_from(diffuse("ggx", 0.5), at_cosine(0.5), {}, 64, Facets::dielectric), InputError);
  CHECK_THROWS_AS(walk_from(material("ggx", 0.5), from_angles(2, 0)), InputError);
}
