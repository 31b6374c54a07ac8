// The stated domains: within, everything there is to evaluate is finite and as exact as stated; beyond, one line says
// so.
#include "../materials.hpp"
#include "../reference/reference.hpp"
#include "analysis/integrals.hpp"
#include "base/errors.hpp"
#include "base/random.hpp"
#include "models/registry.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace test;

namespace {

using Wide = boost::multiprecision::cpp_bin_float_100;

/// The ends of an interval and values between, on a scale that suits it. An end that is open is left by one step.
double draw(const Bounds& bounds, Random& random) {
  const double low = bounds.open_min ? std::nextafter(bounds.min, infinity) : bounds.min;
  const double high = bounds.open_max ? std::nextafter(bounds.max, -infinity) : bounds.max;
  const double u = random.uniform();
  if (u < 0.25) return low;
  if (u < 0.5) return high;
  const double v = random.uniform();
  if (low > 0) return std::clamp(low * std::pow(high / low, v), low, high);
  if (v < 0.5) return std::clamp(low + (high - low) * random.uniform(), low, high);
  return std::clamp(low + (high - low) * std::pow(10.0, -20 * random.uniform()), low, high);
}

/// A distribution of random parameters, all of them of its spec but text.
TermDescription draw(const ModelSpec& spec, Random& random) {
  TermDescription description;
  description.name = spec.type;
  description.distribution.type = spec.type;
  if (spec.type == "oren_nayar") description.masking.type = "v_cavity"; // Smith's is infinite
  const auto group = spec.alternatives.empty()
                         ? std::vector<std::string>{}
                         : spec.alternatives[static_cast<std::size_t>(random.uniform() * 0.999 *
                                                                      static_cast<double>(spec.alternatives.size()))];
  for (const ParameterSpec& parameter : spec.parameters) {
    const bool alternative = std::ranges::any_of(
        spec.alternatives, [&](const auto& keys) { return std::ranges::find(keys, parameter.key) != keys.end(); });
    if (alternative && std::ranges::find(group, parameter.key) == group.end()) continue;
    Value value = std::string("exp(-t2)");
    if (parameter.kind == ParameterKind::number) value = draw(parameter.bounds, random);
    if (parameter.kind == ParameterKind::boolean) continue;
    if (parameter.kind == ParameterKind::vec3) { // moments that go together
      const double xx = std::pow(10, 6 * random.uniform() - 6), yy = xx * std::pow(10, 2 * random.uniform() - 1);
      value = Rgb{xx, yy, (2 * random.uniform() - 1) * std::sqrt(xx * yy)};
    }
    if (parameter.kind == ParameterKind::vec2)
      value =
          random.uniform() < 0.5 ? Vec2{0, 0} : Vec2{draw(parameter.bounds, random), draw(parameter.bounds, random)};
    description.distribution.values.set(parameter.key, value);
    if (const auto* number = std::get_if<double>(&value))
      description.name += ", " + parameter.key + " = " + std::to_string(*number);
  }
  return description;
}

Direction draw_direction(Random& random) {
  const double phi = 2 * std::numbers::pi * random.uniform();
  const double small = std::pow(10.0, -12 * random.uniform());
  return from_angles(random.uniform() < 0.5 ? small : std::numbers::pi / 2 - small, phi);
}

bool refused(const TermDescription& description) {
  try {
    (void)build(description);
    return false;
  } catch (const InputError&) {
    return true;
  }
}

std::string refusal(const TermDescription& description) {
  try {
    (void)build(description);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("domains: every number of every model has two ends") {
  const auto check = [](const std::vector<ModelSpec>& specs) {
    for (const ModelSpec& spec : specs)
      for (const ParameterSpec& parameter : spec.parameters) {
        INFO(spec.type << ", " << parameter.key);
        if (parameter.kind == ParameterKind::formula || parameter.kind == ParameterKind::choice ||
            parameter.kind == ParameterKind::boolean)
          continue;
        CHECK(parameter.bounds.min > -1e16);
        CHECK(parameter.bounds.max < (parameter.kind == ParameterKind::components ? 1e101 : 1e16));
      }
  };
  check(specs_of<Distribution>());
  check(specs_of<Fresnel>());
}

TEST_CASE("domains: at random corners of the whole of every distribution's, all is finite and not negative") {
  Random random(20, 1);
  for (const ModelSpec& spec : specs_of<DistributionList<>>())
    for (int k = 0; k < 60; ++k) {
      const TermDescription description = draw(spec, random);
      if (refused(description)) continue; // a combination
      const Material m = build(description);
      INFO(description.name);
      for (int j = 0; j < 8; ++j) {
        Direction o = draw_direction(random);
        const Direction i = j % 2 ? Direction{-o.x, -o.y, o.z} : draw_direction(random), n = draw_direction(random);
        INFO("o = " << o.x << " " << o.y << " " << o.z << ", i = " << i.x << " " << i.y << " " << i.z);
        for (const Quantity q : {Quantity::p22, Quantity::d, Quantity::d_cos, Quantity::g1, Quantity::d_visible}) {
          INFO("quantity " << static_cast<int>(q));
          const double is = value_at_normal(m, q, o, n);
          CHECK(std::isfinite(is));
          CHECK(is >= 0);
        }
        for (const Quantity q : {Quantity::g2, Quantity::brdf, Quantity::brdf_cos}) {
          INFO("quantity " << static_cast<int>(q));
          const double is = value(m, q, o, i);
          CHECK(std::isfinite(is));
          CHECK(is >= 0);
          if (q == Quantity::brdf) CHECK(is < 1e300);
        }
        if (!m.surface().has_lambda() || !(m.surface().slopes().project(o).c > 0)) continue;
        CHECK(std::isfinite(lambda(m, o)));
        CHECK(lambda(m, o) >= 0);
      }
    }
}

TEST_CASE("domains: Lambda and D of GGX and Beckmann are exact at random corners of theirs") {
  Random random(21, 1);
  for (const auto model : {reference::Model::beckmann, reference::Model::ggx})
    for (int k = 0; k < 300; ++k) {
      const bool ggx = model == reference::Model::ggx;
      const ModelSpec spec = ggx ? Ggx::spec() : Beckmann::spec();
      const TermDescription description = draw(spec, random);
      if (refused(description)) continue;
      const Material m = build(description);
      const SlopeMap& map = m.surface().slopes();
      const reference::Stretch<Wide> stretch{map.alpha_x, map.alpha_y, map.correlation, map.mean_x, map.mean_y};
      const Direction o = draw_direction(random);
      const reference::Vector<Wide> wide{o.x, o.y, o.z};
      INFO(description.name << ", direction " << o.x << " " << o.y << " " << o.z);
      if (map.project(o).c > 1e-9) {
        const double exact = static_cast<double>(reference::lambda(model, stretch, wide));
        // exp(-a^2) changes by 2 a^2 of what is lost of a, the slope of the horizon.
        const double a = static_cast<double>(
            Wide(reference::mesosurface_area(stretch, wide) / reference::projected_roughness(stretch, wide)));
        if (exact > 1e-290) CHECK(relative(lambda(m, o), exact) < 2e-14 + (ggx ? 0 : 1e-15 * a * a));
      }
      const Wide p22 = reference::p22(model, stretch, Wide(-wide.x / wide.z), Wide(-wide.y / wide.z));
      const double d = static_cast<double>(Wide(p22 / (wide.z * wide.z * wide.z * wide.z)));
      if (d > 1e-290) CHECK(relative(value_at_normal(m, Quantity::d, o, o), d) < 1e-12);
    }
}

TEST_CASE("domains: the area of what is seen is there at the ends, or an error says that it is not") {
  Random random(22, 1);
  constexpr double tolerance = 1e-6;
  for (const ModelSpec& spec : specs_of<DistributionList<>>())
    for (int k = 0; k < 40; ++k) {
      TermDescription description = draw(spec, random);
      if (spec.find("mean_slope") != nullptr) description.distribution.values.set("mean_slope", Vec2{0, 0});
      if (refused(description)) continue;
      const Material m = build(description);
      const Direction o = from_angles(1.1, 0.3);
      INFO(description.name);
      try {
        const Estimate area = compute(Integral::projected_area, m, o, tolerance);
        // Else it is refused: where slopes of 1e95, at which integrals end, still have a share in the mean slope.
        if (m.surface().has_lambda() && area.error <= tolerance) CHECK(std::fabs(area.value - o.z) <= area.error);
      } catch (const AccuracyError&) {
      }
    }
}

TEST_CASE("domains: beyond, a line names the key, the value and what is accepted") {
  for (const auto* type : {"ggx", "beckmann"})
    for (const double alpha : {1e308, 1e155, 1e7, 9e-7, 1e-160, 5e-324}) {
      CHECK(refused(describe(type, alpha)));
      CHECK(refused(general(type, 1, alpha, 0)));
      CHECK(refused(distribution(type, {{"roughness", alpha}})) == (alpha < 1e-6 || alpha > 1e3));
    }
  CHECK(refusal(describe("ggx", 1e155)).find("found 1e+155, accepted: a number in [1e-06, 1e+06]") !=
        std::string::npos);
  CHECK(refusal(general("ggx", 1e-3, 2e3, 0)).find("alpha_x = 0.001 with alpha_y = 2000: found a ratio of 2e+06") !=
        std::string::npos);
  CHECK_FALSE(refused(general("ggx", 1e-3, 1e3, 0)));
  CHECK_FALSE(refused(general("beckmann", 1e3, 1e-3, 0.9999, {100, -100})));
  CHECK(refused(general("ggx", 1, 1, 0, {1e4, 0})));
  // What an anisotropy takes out of the domain.
  CHECK(refusal(distribution("ggx", {{"roughness", 1e-3}, {"disney_anisotropy", 1}})).find("alpha_y = 3.16") !=
        std::string::npos);
  CHECK(refused(distribution("ggx", {{"roughness", 1}, {"imageworks_anisotropy", std::nextafter(1.0, 0.0)}})));
  CHECK_FALSE(refused(distribution("ggx", {{"roughness", 1}, {"imageworks_anisotropy", 0.999}})));
  for (const auto& [type, key, value] :
       {std::tuple("gtr", "gamma", 1e308), std::tuple("gtr", "gamma", 1001.0), std::tuple("student_t", "gamma", 1e308),
        std::tuple("exponential_power", "p", 1e308), std::tuple("velvet", "amplitude", 1e308)})
    CHECK(refused(distribution(type, {{"alpha", 0.5}, {key, value}})));
  CHECK(refused(distribution("phong", {{"exponent", 1e308}})));
  CHECK(refused(mixture({{1e308, describe("ggx", 0.1).distribution}, {1e308, describe("ggx", 0.2).distribution}})));
  for (const auto& [type, key, value] :
       {std::tuple("dielectric", "eta", 1e308), std::tuple("dielectric", "eta", 1e-308),
        std::tuple("conductor", "eta", 1e308), std::tuple("conductor", "k", 1e308),
        std::tuple("schlick", "exponent", 1e308)}) {
    TermDescription description = describe("ggx", 0.5);
    description.fresnel.type = type;
    if (std::string(type) == "schlick") description.fresnel.values.set("f0", 0.04);
    if (std::string(type) == "conductor") {
      description.fresnel.values.set("eta", 0.2);
      description.fresnel.values.set("k", 3.0);
    }
    description.fresnel.values.set(key, value);
    const std::string text = std::string(type) + ", " + key + " = " + std::to_string(value);
    INFO(text);
    CHECK(refused(description));
  }
}

TEST_CASE("domains: Fresnel's reflectances hold from one end of theirs to the other") {
  Random random(23, 1);
  for (int k = 0; k < 2000; ++k) {
    const double eta = draw({.min = 1e-6, .max = 1e6}, random), absorption = draw({.min = 0, .max = 1e6}, random);
    const double c = random.uniform() < 0.1 ? 1 : std::pow(10.0, -9 * random.uniform());
    INFO("eta = " << eta << ", k = " << absorption << ", c = " << c);
    // p = sqrt(n^2 - s^2) = q + i y in wide numbers.
    const auto reference = [&](const Wide& k_is) {
      const Wide n = eta, s2 = 1 - Wide(c) * c, t = n * n - k_is * k_is - s2,
                 w = sqrt(Wide(t * t + 4 * n * n * k_is * k_is));
      const Wide q = sqrt(Wide((w + t) / 2)), y = sqrt(Wide((w - t) / 2));
      const Wide perpendicular = ((c - q) * (c - q) + y * y) / ((c + q) * (c + q) + y * y);
      const Wide a = c * q, parallel = ((a - s2) * (a - s2) + c * c * y * y) / ((a + s2) * (a + s2) + c * c * y * y);
      return static_cast<double>(Wide(perpendicular * (1 + parallel) / 2));
    };
    CHECK(std::fabs(conductor_reflectance(c, eta, absorption) - reference(absorption)) < 4e-15);
    // Near the critical angle, c^2 = 1 - eta^2, the reflectance has a vertical tangent.
    if (eta > 1.0001 || eta < 1e-5) CHECK(std::fabs(dielectric_reflectance(c, eta) - reference(0)) < 4e-14);
  }
}
