#include "materials.hpp"

#include "analysis/sampling_check.hpp"
#include "base/random.hpp"
#include "models/registry.hpp"

#include <doctest/doctest.h>

#include <cstdlib>

using namespace test;

namespace {

double between(Random& random, double from, double to) { return from + (to - from) * random.uniform(); }
double log_between(Random& random, double from, double to) {
  return std::exp(between(random, std::log(from), std::log(to)));
}
template <class T>
const T& one_of(Random& random, const std::vector<T>& all) {
  return all[static_cast<std::size_t>(random.uniform() * static_cast<double>(all.size()))];
}

ModelChoice random_distribution(Random& random) {
  const auto alpha = [&] { return random.uniform() < 0.2 ? 0.001 : log_between(random, 1e-3, 2); };
  const std::string type =
      one_of<std::string>(random, {"beckmann", "beckmann", "ggx", "ggx", "student_t", "exponential_power", "gtr",
                                   "phong", "velvet", "sheen", "ward", "gaussian", "custom"});
  ModelChoice choice{type, {}};
  if (type == "sheen" || type == "gaussian" || type == "velvet")
    choice.values.set("alpha", log_between(random, 0.1, 1));
  else if (type == "phong")
    choice.values.set("exponent", log_between(random, 0.1, 1e6));
  else if (type == "gtr" || type == "ward" || random.uniform() < 0.4)
    choice.values.set("alpha", alpha());
  else {
    const double alpha_x = alpha(), ratio = log_between(random, 1e-3, 1e3);
    choice.values.set("alpha_x", alpha_x);
    choice.values.set("alpha_y", std::clamp(alpha_x * ratio, 1e-4, 2.0));
    choice.values.set("correlation", between(random, -0.9, 0.9));
    if (random.uniform() < 0.3)
      choice.values.set("mean_slope", Vec2{between(random, -0.5, 0.5), between(random, -0.5, 0.5)});
  }
  if (type == "student_t") choice.values.set("gamma", between(random, 1.7, 8));
  if (type == "exponential_power") choice.values.set("p", between(random, 0.3, 3));
  if (type == "gtr") choice.values.set("gamma", between(random, 1.2, 4));
  if (type == "custom")
    choice.values.set("shape",
                      one_of<std::string>(random, {"t^2 * exp(-t)", "exp(-((t - 1) / 0.01)^2)", "max(0, 1 - t2)",
                                                   "exp(-t2) + 1000 * exp(-1e4 * t2)", "t2 < 1 ? 1 : 0"}));
  return choice;
}

TermDescription of_type(const std::string& type) {
  TermDescription description;
  description.name = description.type = type;
  return description;
}

TermDescription lambert() {
  TermDescription description = of_type("lambert");
  description.values.set("albedo", Rgb{0.5, 0.2, 0.1});
  return description;
}

/// GGX is drawn as it is seen by two maps.
std::string strategy_of_facets(Random& random, bool ggx) {
  if (random.uniform() < 0.5) return "half_vector";
  return ggx && random.uniform() < 0.5 ? "heitz_2018" : "visible_normals";
}

TermDescription random_mixture(Random& random, bool ggx) {
  const double first = log_between(random, 1e-3, 1), second = log_between(random, 1e-3, 1);
  return mixture({{0.7, test::distribution("ggx", {{"alpha", first}}).distribution},
                  {0.3, test::distribution(ggx ? "ggx" : "beckmann", {{"alpha", second}}).distribution}});
}

TermDescription random_eon(Random& random) {
  TermDescription description = of_type("eon");
  description.values.set("roughness", random.uniform() < 0.2 ? 1 : random.uniform());
  description.values.set("albedo", Rgb{0.9, 0.5, 0.2});
  return description;
}

/// Kelemen and Szirmay-Kalos' specular part, and with a chance the matte one that takes what it leaves.
MaterialDescription random_kelemen(Random& random) {
  TermDescription specular = of_type("kelemen"), matte = of_type("complement");
  specular.distribution.type = random.uniform() < 0.7 ? "beckmann" : "ggx";
  specular.distribution.values.set("alpha", log_between(random, 1e-3, 1));
  specular.fresnel = {"schlick", {}};
  specular.fresnel.values.set("f0", between(random, 0.02, 0.9));
  if (random.uniform() < 0.3) return {"specular", {specular}, true};
  matte.of.push_back(specular);
  matte.values.set("color", Rgb{0.9, 0.5, 0.2});
  return {"both", {specular, matte}, true};
}

/// A mirror, a mixture, a sum of terms, or what is diffuse; and a strategy that suits it.
std::pair<MaterialDescription, std::string> random_configuration(Random& random) {
  TermDescription mirror = of_type("mirror");
  mirror.distribution = random_distribution(random);
  const double kind = random.uniform();
  if (kind < 0.5) return {mirror, strategy_of_facets(random, mirror.distribution.type == "ggx")};
  if (kind < 0.6) {
    const bool ggx = random.uniform() < 0.5;
    return {random_mixture(random, ggx), strategy_of_facets(random, ggx)};
  }
  if (kind < 0.65) return {lambert(), "cosine"};
  if (kind < 0.75) return {random_eon(random), random.uniform() < 0.8 ? "eon" : "cosine"};
  if (kind < 0.85) return {random_kelemen(random), random.uniform() < 0.8 ? "kelemen" : "default"};
  if (mirror.distribution.values.has("mean_slope")) return {mirror, "default"};
  mirror.fresnel = {"dielectric", {}};
  mirror.fresnel.values.set("eta", 1.5);
  return {MaterialDescription("coated", {mirror, lambert()}, true), "default"};
}

Direction random_viewer(Random& random, const Material& material) {
  for (;;) {
    const double theta = random.uniform() < 0.2 ? 89.9 * degree : std::acos(random.uniform());
    const Direction o = from_angles(theta, between(random, 0, 2 * std::numbers::pi));
    if (material.mesosurface().project(o).c > 0) return o;
  }
}

int configurations() {
  const char* asked = std::getenv("BRDFPLOT_SAMPLING_CONFIGURATIONS");
  return asked != nullptr ? std::atoi(asked) : 100;
}

/// Of a thousand configurations one or the other is four standard errors off by chance: 16 times as many samples from
/// another seed find a fault again, with four times as many standard errors, and a chance not.
SamplingFindings check_again(const Material& material, const Sampler& sampler, const Direction& o, SamplingTest test,
                             const SamplingFindings& found) {
  for (const std::string& fault : found.faults(test)) MESSAGE("looked at again: " << fault);
  test.samples *= 16;
  test.seed += 1'000'000'000;
  return check_sampling(material, sampler, o, test);
}

/// The findings about `density` in the place of the sampler's own.
SamplingFindings held_to(const Material& material, const std::string& strategy, const Direction& o,
                         const PairDensity& density) {
  return check_sampling(material, Sampler(material, strategy), o, {}, density);
}

} // namespace

TEST_CASE("random materials, viewers and strategies: samples follow the density, which integrates to 1, and the mean "
          "weight is the albedo") {
  const char* seed = std::getenv("BRDFPLOT_SAMPLING_SEED");
  Random random(seed != nullptr ? std::strtoull(seed, nullptr, 10) : 12, 0);
  SamplingTest test;
  test.significance = sidak(0.01, static_cast<std::size_t>(configurations()));
  for (int k = 0; k < configurations(); ++k) {
    const auto configuration = random_configuration(random);
    const MaterialDescription& description = configuration.first;
    const std::string& strategy = configuration.second;
    const Material material = build(description);
    const Direction o = random_viewer(random, material);
    test.seed = static_cast<std::uint64_t>(k);
    const Sampler sampler(material, strategy);
    SamplingFindings found = check_sampling(material, sampler, o, test);
    if (!found.holds(test)) found = check_again(material, sampler, o, test, found);
    CAPTURE(k);
    CAPTURE(description.terms[0].type);
    CAPTURE(description.terms[0].distribution.type);
    CAPTURE(description.terms.size());
    CAPTURE(strategy);
    CAPTURE(std::acos(o.z) / degree);
    for (const std::string& fault : found.faults(test)) FAIL_CHECK(fault);
    CHECK(found.cells > 20);
  }
}

TEST_CASE("densities that are wrong as renderers' are rejected") {
  const double alpha = 0.4;
  const Direction o = from_angles(1.2, 0.3);

  SUBCASE("Beckmann's visible normals, normalised with exp(-cos^2) for exp(-cot^2)") {
    const Material material = test::material("beckmann", alpha);
    const Sampler sampler(material, "visible_normals");
    const SamplingFindings found =
        held_to(material, "visible_normals", o, [&](std::size_t n, const Columns& v, const Columns& l, double* out) {
          sampler.densities(n, v, l, out);
          for (std::size_t k = 0; k < n; ++k) {
            const double c = v.z[k], s = std::sqrt((1 - c) * (1 + c)), a = c / (alpha * s);
            const double root_pi = std::sqrt(std::numbers::pi);
            const double right = (1 + std::erf(a)) * c + alpha * s * std::exp(-a * a) / root_pi;
            const double wrong = (1 + std::erf(a)) * c + alpha * s * std::exp(-c * c) / root_pi;
            out[k] *= right / wrong;
          }
        });
    CHECK(std::fabs(found.integral.value - 1) > 0.01);
    CHECK(found.p_value < 1e-6);
    CHECK(!found.holds({}));
  }
  SUBCASE("GGX's masking with alpha_x alpha_y for alpha_o^2") {
    const Material material = build(general("ggx", 0.2, 0.8, 0));
    const Sampler sampler(material, "visible_normals");
    const Direction at_x = from_angles(1.4, 0);
    const auto sigma = [](double c, double s) { return 0.5 * (c + std::hypot(c, s)); };
    const SamplingFindings found =
        held_to(material, "visible_normals", at_x, [&](std::size_t n, const Columns& v, const Columns& l, double* out) {
          sampler.densities(n, v, l, out);
          for (std::size_t k = 0; k < n; ++k)
            out[k] *= sigma(v.z[k], std::hypot(0.2 * v.x[k], 0.8 * v.y[k])) /
                      sigma(v.z[k], std::sqrt(0.2 * 0.8) * std::hypot(v.x[k], v.y[k]));
        });
    CHECK(std::fabs(found.integral.value - 1) > 0.01);
    CHECK(found.p_value < 1e-6);
    CHECK(!found.holds({}));
  }
  SUBCASE("half vectors of which those that turn away are forgotten") {
    const Material material = test::material("ggx", alpha);
    const Sampler sampler(material, "half_vector");
    const SamplingFindings found =
        held_to(material, "half_vector", o, [&](std::size_t n, const Columns& v, const Columns& l, double* out) {
          sampler.densities(n, v, l, out);
          for (std::size_t k = 0; k < n; ++k)
            if (!(v.z[k] + l.z[k] > 0)) out[k] = 0;
        });
    CHECK(std::fabs(found.integral.value - 1) > 0.01);
    CHECK(found.p_value < 1e-6);
    CHECK(!found.holds({}));
  }
  SUBCASE("a jacobian of 1 / 4 (h.g) for 1 / 4 (o.h), at alpha = 0.001 too") {
    for (const double roughness : {0.4, 0.001}) {
      const Material material = test::material("ggx", roughness);
      const Sampler sampler(material, "visible_normals");
      const SamplingFindings found =
          held_to(material, "visible_normals", o, [&](std::size_t n, const Columns& v, const Columns& l, double* out) {
            sampler.densities(n, v, l, out);
            for (std::size_t k = 0; k < n; ++k) {
              const Direction h = half_vector(v[k], l[k]);
              if (out[k] > 0) out[k] *= dot(v[k], h) / h.z;
            }
          });
      CHECK(found.p_value < 1e-6);
      CHECK(!found.holds({}));
    }
  }
  SUBCASE("a roughness that is 10 % off, at alpha = 0.001: its integral is 1 all the same") {
    const Material material = test::material("ggx", 0.001), other = test::material("ggx", 0.0011);
    const Sampler of_other(other, "visible_normals");
    const SamplingFindings found =
        held_to(material, "visible_normals", o, [&](std::size_t n, const Columns& v, const Columns& l, double* out) {
          of_other.densities(n, v, l, out);
        });
    CHECK(std::fabs(found.integral.value - 1) < 1e-6);
    CHECK(found.p_value < 1e-6);
    CHECK(!found.holds({}));
  }
  SUBCASE("no number, negative, and nothing where there is light") {
    const Material material = test::material("ggx", alpha);
    const Sampler sampler(material, "visible_normals");
    for (const double bad : {std::nan(""), -1.0, 0.0}) {
      const SamplingFindings found =
          held_to(material, "visible_normals", o, [&](std::size_t n, const Columns& v, const Columns& l, double* out) {
            sampler.densities(n, v, l, out);
            for (std::size_t k = 0; k < n; ++k)
              if (l.x[k] > 0.5) out[k] = bad;
          });
      CHECK(found.untold + found.uncovered > 0);
      CHECK(!found.holds({}));
    }
  }
}

TEST_CASE("Sidak's significance of each is that of all together") {
  CHECK(sidak(0.01, 1) == doctest::Approx(0.01));
  CHECK(1 - std::pow(1 - sidak(0.01, 100), 100) == doctest::Approx(0.01));
}
