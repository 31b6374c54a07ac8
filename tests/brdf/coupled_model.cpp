// The coupled model of Kelemen and Szirmay-Kalos (2001), and light of further bounces: closed forms against the
// equations as they are printed, with 50 digits; tables against the integrals that they stand for.
#include "../materials.hpp"
#include "../sample.hpp"
#include "analysis/integrals.hpp"
#include "brdf/evaluate_single.hpp"
#include "brdf/integrals/reflected_light.hpp"
#include "brdf/integrals/term_albedo.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

#include <array>
#include <random>

using namespace test;

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

TermDescription kelemen(const std::string& distribution, double alpha, const std::string& density = "projected") {
  TermDescription term;
  term.type = "kelemen";
  term.distribution.type = distribution;
  term.distribution.values.set("alpha", alpha);
  term.values.set("density", density);
  return term;
}

TermDescription of(const std::string& type, const TermDescription& other) {
  TermDescription term;
  term.type = type;
  term.of = {other};
  return term;
}

TermDescription with_fresnel(TermDescription term, const std::string& type,
                             std::initializer_list<std::pair<std::string, Value>> values) {
  term.fresnel.type = type;
  for (const auto& [key, value] : values) term.fresnel.values.set(key, value);
  return term;
}

MaterialDescription sum(const TermDescription& first, const TermDescription& second) {
  return {"sum", {first, second}, true};
}

Direction at(double mu, double phi = 0) {
  const double s = std::sqrt((1 - mu) * (1 + mu));
  return {s * std::cos(phi), s * std::sin(phi), mu};
}

/// Eq. 3 with the density of half vectors as it is named.
Real printed(const std::string& distribution, const Real& alpha, bool with_cosine, const Direction& o,
             const Direction& i) {
  const std::array<Real, 3> h = {Real(o.x) + i.x, Real(o.y) + i.y, Real(o.z) + i.z};
  const Real length2 = h[0] * h[0] + h[1] * h[1] + h[2] * h[2];
  const Real c2 = h[2] * h[2] / length2, t2 = (1 - c2) / c2, a2 = alpha * alpha;
  const Real pi = boost::math::constants::pi<Real>();
  const Real d = distribution == "beckmann" ? Real(exp(-t2 / a2) / (pi * a2 * c2 * c2))
                                            : Real(1 / (pi * a2 * c2 * c2 * (1 + t2 / a2) * (1 + t2 / a2)));
  return d * (with_cosine ? Real(sqrt(c2)) : Real(1)) / length2; // |o + i|^2 = 2 (1 + o.i)
}

double mean_albedo(const TermDescription& term) { return TermAlbedo(term).table().mean(0); }

std::string error_of(const MaterialDescription& description) {
  try {
    build(description);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("kelemen: the printed equation with 50 digits, from the normal to grazing") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const std::string distribution : {"beckmann", "ggx"})
    for (const double alpha : {0.01, 0.1, 0.5, 1.0, 3.0})
      for (const bool with_cosine : {true, false}) {
        const Material m = build(kelemen(distribution, alpha, with_cosine ? "projected" : "d"));
        for (int k = 0; k < 60; ++k) {
          const double grazing = std::pow(10.0, -12 * uniform(random));
          const Direction o = at(k % 3 == 0 ? grazing : uniform(random), 6 * uniform(random));
          // Near the mirror direction, and anywhere.
          const Direction near = normalized(
              {-o.x + alpha * (uniform(random) - 0.5) * o.z, -o.y + alpha * (uniform(random) - 0.5) * o.z, o.z});
          const Direction i = k % 2 == 0 ? near : at(uniform(random), 6 * uniform(random));
          const double got = value(m, Quantity::brdf, o, i);
          const double truth = static_cast<double>(printed(distribution, alpha, with_cosine, o, i));
          // The half vector has three roundings of its length; D sees those of its slope over alpha.
          const Direction h = half_vector(o, i);
          const double t2 = (h.x * h.x + h.y * h.y) / (h.z * h.z * alpha * alpha);
          CHECK(std::fabs(got - truth) <= (2e-15 + 2e-15 * (1 + 1 / (alpha * alpha)) * (1 + t2)) * truth + 1e-300);
          CHECK(value(m, Quantity::brdf, o, i) == doctest::Approx(value(m, Quantity::brdf, i, o)).epsilon(1e-13));
        }
      }
}

TEST_CASE("kelemen: in float it is the double one, rounded") {
  const Material m = build(kelemen("ggx", 0.4));
  const Direction o = from_angles(0.3, 0), i = from_angles(-0.2, 0.1);
  float single = 0;
  evaluate(m, Quantity::brdf, {1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, {}}, &single);
  CHECK(single == static_cast<float>(value(m, Quantity::brdf, o, i)));
}

TEST_CASE("kelemen: P is D cos, D over its integral, or D, and the first two integrate to 1") {
  const Direction o = from_angles(0.4, 0.3), i = from_angles(0.9, 2.5), h = half_vector(o, i);
  for (const std::string type : {"beckmann", "ggx"})
    for (const double alpha : {0.05, 0.4, 1.0, 3.0}) {
      const Material facets = material(type, alpha);
      const auto integral_of_d = [&](bool with_cosine) {
        const auto along = [&](const double* theta, double* y, std::size_t n) {
          for (std::size_t k = 0; k < n; ++k)
            y[k] = 2 * std::numbers::pi * std::sin(theta[k]) * (with_cosine ? std::cos(theta[k]) : 1) *
                   value_at_normal(facets, Quantity::d, {0, 0, 1}, from_angles(theta[k], 0));
        };
        const std::array<double, 2> range = {0, std::numbers::pi / 2};
        return integrate(along, range, {.absolute = 1e-12}).value;
      };
      CHECK(std::fabs(integral_of_d(true) - 1) < 1e-11);
      const auto rho = [&](const std::string& density) {
        return value(build(kelemen(type, alpha, density)), Quantity::brdf, o, i);
      };
      CHECK(rho("projected") == doctest::Approx(rho("d") * h.z).epsilon(1e-14));
      CHECK(rho("normalised") == doctest::Approx(rho("d") / integral_of_d(false)).epsilon(1e-10));
    }
}

TEST_CASE("kelemen: mean albedos of the three densities are those computed elsewhere") {
  const std::vector<std::array<double, 4>> known = {{0.4, 0.790, 0.735, 0.745}, {0.8, 0.569, 0.452, 0.490}};
  for (const auto& [alpha, d, normalised, projected] : sample_of(known, 2)) {
    CHECK(std::fabs(mean_albedo(kelemen("beckmann", alpha, "d")) - d) < 5.1e-4);
    CHECK(std::fabs(mean_albedo(kelemen("beckmann", alpha, "normalised")) - normalised) < 5.1e-4);
    CHECK(std::fabs(mean_albedo(kelemen("beckmann", alpha)) - projected) < 5.1e-4);
  }
}

TEST_CASE("tables of albedo: between the nodes within the error that they state, which is small") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<TermDescription> terms = {kelemen("beckmann", 0.3),
                                        describe("ggx", 0.02),
                                        general("ggx", 0.3, 0.6, 0),
                                        with_fresnel(describe("ggx", 0.3), "dielectric", {{"eta", 1.5}}),
                                        describe("beckmann", 0.5, "v_cavity"),
                                        describe("ggx", 1)};
  terms.back().weight = 0.5;
  for (const TermDescription& term : sample_of(terms, terms.size())) {
    const AlbedoTable table = TermAlbedo(term).table();
    const WeightedTerm built = build_term(term);
    CHECK(table.error() < (built.is_isotropic() ? 1e-7 : 1e-6));
    for (int k = 0; k < inputs(40, 4); ++k) {
      const double mu = k % 2 == 0 ? uniform(random) : std::pow(10.0, -8 * uniform(random));
      const Direction o = at(mu, 7 * uniform(random));
      const ColourEstimate truth = reflected_light({&built}, o, 1e-10, {0, 1}, every_direction);
      CAPTURE(term.type);
      CAPTURE(mu);
      CHECK(std::fabs(table.albedo(0, o) - truth.value[0]) <= table.error() + truth.error[0]);
    }
  }
}

TEST_CASE("complement: with color 1 and F = 1 nothing is lost, whatever the angle, the roughness and the density") {
  // 500 of them: the distribution and the reading of P in turn, the rest at random.
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  const std::array<std::string, 3> densities = {"projected", "normalised", "d"};
  const std::array<std::string, 5> distributions = {"beckmann", "ggx", "ward", "gaussian", "phong"};
  double worst = 0;
  const std::size_t tables = random_inputs("BRDFPLOT_RANDOM_TABLES", 25, 2);
  for (std::size_t one = 0; one < tables; ++one) {
    const double alpha = std::pow(10, -2 + 2.3 * uniform(random));
    const auto specular = kelemen(distributions[one % 5], alpha, densities[one / 5 % 3]);
    const Material m = build(sum(specular, of("complement", specular)));
    for (int k = 0; k < inputs(20, 4); ++k) {
      const Direction o = at(k == 0 ? 1e-4 : uniform(random), 6 * uniform(random));
      const Estimate e = compute(Integral::albedo, m, o, 1e-7);
      worst = std::max(worst, std::fabs(e.value - 1));
    }
  }
  MESSAGE("largest difference from 1: " << worst);
  CHECK(worst <= 1e-6);
}

TEST_CASE("complement: with color 1 nothing is lost with any Fresnel term, in any channel") {
  const std::vector<std::pair<std::string, std::vector<std::pair<std::string, Value>>>> all = {
      {"none", {}},
      {"schlick", {{"f0", Rgb{0.9, 0.5, 0.04}}}},
      {"f82", {{"f0", 0.8}, {"f82", 0.7}}},
      {"dielectric", {{"eta", 1.5}}},
      {"conductor", {{"eta", Rgb{0.143, 0.374, 1.442}}, {"k", Rgb{3.983, 2.385, 1.603}}}}};
  CHECK(all.size() == specs_of<Fresnel>().size());
  for (const auto& [type, values] : sample_of(all, all.size())) {
    TermDescription specular = kelemen("ggx", 0.35);
    specular.fresnel.type = type;
    for (const auto& [key, value] : values) specular.fresnel.values.set(key, value);
    const Material m = build(sum(specular, of("complement", specular)));
    for (const double mu : {1.0, 0.15}) {
      const ColourEstimate e = compute_channels(Integral::albedo, m, at(mu), 1e-8);
      for (std::size_t c = 0; c < static_cast<std::size_t>(m.channels()); ++c) CHECK(std::fabs(e.value[c] - 1) <= 1e-6);
    }
  }
}

TEST_CASE("complement: the sum reflects E + color (1 - E), for each channel") {
  const TermDescription gold = with_fresnel(kelemen("beckmann", 0.4), "conductor",
                                            {{"eta", Rgb{0.143, 0.374, 1.442}}, {"k", Rgb{3.983, 2.385, 1.603}}});
  TermDescription matte = of("complement", gold);
  const Rgb color = {1, 0.5, 0};
  matte.values.set("color", color);
  const Material m = build(sum(gold, matte)), alone = build(gold);
  for (const double mu : sample_of<double>({1.0, 0.7, 0.2, 0.01}, 3)) {
    const ColourEstimate whole = compute_channels(Integral::albedo, m, at(mu), 1e-8);
    const ColourEstimate specular = compute_channels(Integral::albedo, alone, at(mu), 1e-9);
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(std::fabs(whole.value[c] - (specular.value[c] + color[c] * (1 - specular.value[c]))) < 1e-7);
  }
}

TEST_CASE("complement: named beside it or written within it, one value; of a mirror and its weight too") {
  TermDescription coat = with_fresnel(describe("ggx", 0.1), "schlick", {{"f0", 0.04}});
  coat.name = "coat";
  coat.weight = 0.5;
  TermDescription named;
  named.type = "complement";
  named.of_name = "coat";
  const Material by_name = build(sum(coat, named)), within = build(sum(coat, of("complement", coat)));
  const Direction o = from_angles(0.5, 1), i = from_angles(1.3, 2);
  CHECK(value(by_name, Quantity::brdf, o, i) == value(within, Quantity::brdf, o, i));
  CHECK(std::fabs(compute(Integral::albedo, by_name, o, 1e-8).value - 1) < 1e-7);
  auto swept = sum(coat, of("complement", coat));
  set_parameter(swept, "complement.of.alpha", 0.6);
  CHECK(value(build(swept), Quantity::brdf, o, i) != value(within, Quantity::brdf, o, i));
}

TEST_CASE("multiple_bounce: with F = 1 all light comes back, at every roughness and angle, for every microsurface") {
  double worst = 0;
  const auto take = [&](const std::string& type, double alpha, const std::string& masking) {
    const TermDescription mirror = describe(type, alpha, masking);
    const Material m = build(sum(mirror, of("multiple_bounce", mirror)));
    for (const double mu : sample_of<double>({1.0, 0.9, 0.6, 0.3, 0.1, 0.01, 1e-4, 1e-8}, 8))
      worst = std::max(worst, std::fabs(compute(Integral::albedo, m, at(mu), 2e-7).value - 1));
  };
  for (const std::string& type : sample_of<std::string>({"ggx", "beckmann"}, 2)) {
    for (const double alpha : sample_of<double>({0.6, 0.001, 0.01, 0.1, 0.3, 1.0, 10.0}, 7)) take(type, alpha, "smith");
    for (const double alpha : sample_of<double>({0.6, 0.001, 0.01, 0.1, 0.3, 1.0}, 6)) take(type, alpha, "v_cavity");
  }
  const TermDescription brushed = general("ggx", 0.3, 0.6, 0);
  const Material m = build(sum(brushed, of("multiple_bounce", brushed)));
  for (const double phi : sample_of<double>({0.4, 0.0, 1.5, 2.5}, 4))
    for (const double mu : sample_of<double>({0.5, 1.0, 0.1}, 3))
      worst = std::max(worst, std::fabs(compute(Integral::albedo, m, at(mu, phi), 1e-8).value - 1));
  MESSAGE("largest difference from 1: " << worst);
  CHECK(worst <= 1e-6);
}

TEST_CASE("tables of albedo: masking by a fit that jumps, or that has a root at the normal") {
  const std::vector<TermDescription> terms = {describe("beckmann", 0.3, "smith_rational"),
                                              describe("ggx", 0.3, "schlick_smith")};
  for (const TermDescription& mirror : sample_of(terms, terms.size())) {
    CAPTURE(mirror.masking.type);
    const AlbedoTable table = TermAlbedo(mirror).table();
    CHECK(table.error() < 1e-6);
    const WeightedTerm built = build_term(mirror);
    // a = 1.6, where Walter's Lambda ends, is at mu = 0.433.
    for (const double mu : {1.0, 1 - 1e-9, 0.9999, 0.4326, 0.4328, 0.4329, 0.4331, 0.1, 1e-3, 1e-6}) {
      const ColourEstimate truth = reflected_light({&built}, at(mu, 0.3), 1e-9, {0, 1}, every_direction);
      CHECK(std::fabs(table.albedo(0, at(mu, 0.3)) - truth.value[0]) <= table.error() + truth.error[0]);
    }
  }
}

TEST_CASE("albedo: of V-cavities near grazing it is 1 - cos theta / (12 alpha), and kelemen has its table") {
  // With y = o.m / cos theta, rho cos of Eqs. 29 and 49 is the density of slopes by min(y, 2, 4 y - 2), y > 1/2. Where
  // these differ, y <= 2, GGX's density along the plane of incidence is 1 / (2 alpha); its integral lacks 1 / 6 there.
  const Material m = build(describe("ggx", 0.001, "v_cavity"));
  const double loss = 1 - compute(Integral::albedo, m, at(1e-9), 1e-10).value;
  CHECK(loss == doctest::Approx(1e-6 / 12).epsilon(1e-3));
  CHECK(1 - compute(Integral::albedo, m, at(1e-10), 1e-11).value == doctest::Approx(0.1 * loss).epsilon(1e-2));
  CHECK(std::fabs(1 - compute(Integral::albedo, m, at(1e-14), 1e-10).value) < 1e-10);
  CHECK(TermAlbedo(describe("ggx", 0.05, "kelemen")).table().error() < 1e-6);
}

TEST_CASE("multiple_bounce: the energy of its two readings is that of the series they stand for") {
  const TermDescription mirror = with_fresnel(describe("ggx", 0.7), "schlick", {{"f0", Rgb{0.9, 0.5, 0.04}}});
  const AlbedoTable table = TermAlbedo(describe("ggx", 0.7)).table();
  const double lost = table.mean_loss(0);
  TermDescription as_printed = of("multiple_bounce", mirror);
  as_printed.values.set("mean_fresnel", std::string("printed"));
  const Material energy = build(of("multiple_bounce", mirror)), other = build(as_printed);
  const Fresnel fresnel = *build_term(mirror).fresnel();
  for (std::size_t c = 0; c < 3; ++c) {
    const double f = mean_fresnel(fresnel, c);
    // Light that has been lost once is reflected by f at each further bounce, and leaves with mean R = 1 - lost.
    double series = 0, weight = f;
    for (int bounce = 2; bounce < 400; ++bounce) {
      series += weight * f * (1 - lost);
      weight *= f * lost;
    }
    const Estimate got = compute(Integral::albedo, energy, at(0.4), 1e-9, static_cast<int>(c));
    CHECK(got.value == doctest::Approx(table.loss(0, at(0.4)) * series).epsilon(1e-7));
    const Estimate bright = compute(Integral::albedo, other, at(0.4), 1e-9, static_cast<int>(c));
    CHECK(bright.value == doctest::Approx(got.value / f).epsilon(1e-7));
  }
}

TEST_CASE("terms of another: what cannot be is refused, with what is accepted") {
  TermDescription rough = describe("ggx", 0.3);
  TermDescription named;
  named.type = "complement";
  named.of_name = "coat";
  CHECK(error_of(sum(rough, named)).find("/terms/1/of: unknown term \"coat\"; accepted: ") != std::string::npos);
  named.of_name.clear();
  CHECK(error_of(sum(rough, named)).find("/terms/1/of: found none; accepted: a term") != std::string::npos);
  CHECK(error_of(sum(rough, of("complement", of("complement", rough)))).find("not itself of another") !=
        std::string::npos);
  CHECK(error_of(sum(rough, of("complement", general("ggx", 0.1, 0.4, 0.5)))).find("not symmetric about x and y") !=
        std::string::npos);
  TermDescription rim;
  rim.type = "hammon_diffuse";
  rim.values.set("alpha", 1.0);
  // What takes an integral to find is told when the albedo is first needed.
  const Material bright = build(sum(rough, of("complement", rim)));
  CHECK_THROWS_WITH_AS(value(bright, Quantity::brdf, at(0.5), at(0.7)), doctest::Contains("has an albedo of 1."),
                       InputError);
  CHECK(error_of(sum(rough, of("multiple_bounce", rim))).find("a term with a Fresnel term") != std::string::npos);
  TermDescription sheared = kelemen("ggx", 0.3);
  sheared.distribution.values.set("mean_slope", Vec2{0.1, 0});
  CHECK(error_of(MaterialDescription(sheared)).find("mean_slope") != std::string::npos);
}

TEST_CASE("a kelemen term has every Fresnel term, and what is asked of it, as a mirror has") {
  const std::vector<std::pair<std::string, std::vector<std::pair<std::string, Value>>>> all = {
      {"none", {}},
      {"schlick", {{"f0", Rgb{0.9, 0.5, 0.1}}, {"f90", 0.8}, {"exponent", 4.0}}},
      {"f82", {{"f0", 0.8}, {"f82", 0.7}}},
      {"dielectric", {{"eta", 1.5}}},
      {"dielectric", {{"eta", 0.7}}},
      {"conductor", {{"eta", Rgb{0.2, 0.9, 1.1}}, {"k", 3.0}}}};
  for (const auto& [type, values] : all) {
    TermDescription mirror = describe("ggx", 0.3);
    mirror.fresnel.type = type;
    for (const auto& [key, value] : values) mirror.fresnel.values.set(key, value);
    TermDescription kelemen = mirror;
    kelemen.type = "kelemen";
    const std::string shown = type; // Clang 14 has no structured binding in the lambda of INFO
    INFO(shown);
    const Material a = build(mirror), b = build(kelemen);
    const Direction o = from_angles(1.1, 0.2), i = from_angles(0.7, 2);
    std::array<double, 3> f_a{}, f_b{}, rho{}, white{};
    const auto of = [&](const Material& m, Quantity quantity, std::array<double, 3>& out) {
      evaluate(m, quantity, {1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, {}}, out.data());
    };
    CHECK(channels_of(b, Quantity::fresnel) == channels_of(a, Quantity::fresnel));
    of(a, Quantity::fresnel, f_a);
    of(b, Quantity::fresnel, f_b);
    CHECK(f_a == f_b);
    for (int c = 0; c < a.channels(); ++c)
      CHECK(compute(Integral::average_fresnel, b, o, 1e-9, c).value ==
            compute(Integral::average_fresnel, a, o, 1e-9, c).value);
    TermDescription without = kelemen;
    without.fresnel = {.type = "none"};
    of(b, Quantity::brdf, rho);
    of(build(without), Quantity::brdf, white);
    for (std::size_t c = 0; c < static_cast<std::size_t>(b.channels()); ++c)
      CHECK(relative(rho[c], white[0] * f_b[c]) < 1e-14);
  }
}

TEST_CASE("fresnel of several terms is of the one with a microsurface, or of one that is named") {
  TermDescription one = describe("ggx", 0.3), two = one;
  one.name = "one";
  two.name = "two";
  one.type = two.type = "kelemen";
  const Direction o = from_angles(1.1, 0.2);
  const Material both = build(MaterialDescription{"both", {one, two}, true});
  CHECK_THROWS_WITH(test::value(both, Quantity::fresnel, o, o), doctest::Contains("of one, two"));
  one.type = "mirror";
  CHECK(test::value(build(MaterialDescription{"both", {one, two}, true}), Quantity::fresnel, o, o) == 1);
}
