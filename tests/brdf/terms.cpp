#include "../materials.hpp"
#include "analysis/integrals.hpp"
#include "brdf/integrals/reflected_moments.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>

using namespace test;

namespace {

TermDescription lambert(const Value& albedo, const Value& weight = 1.0) {
  TermDescription term;
  term.type = "lambert";
  term.weight = weight;
  term.values.set("albedo", albedo);
  return term;
}

TermDescription coat() {
  TermDescription term = describe("ggx", 0.2);
  term.name = "coat";
  term.fresnel.type = "dielectric";
  term.fresnel.values.set("eta", 1.5);
  return term;
}

TermDescription flakes() {
  TermDescription term = describe("beckmann", 0.4);
  term.name = "flakes";
  term.weight = 0.5;
  term.fresnel.type = "schlick";
  term.fresnel.values.set("f0", Rgb{0.7, 0.09, 0.07});
  return term;
}

MaterialDescription paint() { return {"paint", {coat(), flakes(), lambert(Rgb{0.2, 0.02, 0.01}, 0.9)}, true}; }

std::array<double, 3> channels(const Material& m, Quantity quantity, const Direction& o, const Direction& i,
                               const std::string& term = "") {
  std::array<double, 3> out{};
  evaluate(m, quantity, {1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, {}}, out.data(), term);
  return out;
}

std::string error_of(const MaterialDescription& description) {
  try {
    build(description);
  } catch (const MaterialError& error) {
    return error.pointer() + ": " + error.reason();
  }
  return "";
}

} // namespace

TEST_CASE("terms: Lambert is albedo / pi, and its albedo is its albedo") {
  const Material m = build(lambert(Rgb{0.2, 0.5, 1}));
  const Direction o = from_angles(0.7, 1), i = from_angles(1.2, 4);
  CHECK(m.channels() == 3);
  const Rgb albedo = {0.2, 0.5, 1};
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(channels(m, Quantity::brdf, o, i)[c] == doctest::Approx(albedo[c] / std::numbers::pi).epsilon(1e-15));
    CHECK(channels(m, Quantity::brdf_cos, o, i)[c] ==
          doctest::Approx(albedo[c] * i.z / std::numbers::pi).epsilon(1e-15));
    const Estimate e = compute(Integral::albedo, m, o, 1e-9, static_cast<int>(c));
    CHECK(e.error <= 1e-9);
    CHECK(std::fabs(e.value - albedo[c]) <= e.error);
  }
  CHECK(channels(m, Quantity::brdf, o, {0, 0, -1})[2] == 0);
  CHECK(channels(m, Quantity::brdf, from_angles(1.7, 0), i)[2] == 0);
  CHECK(compute(Integral::furnace, m, o, 1e-9).value == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("terms: a material is the weighted sum of its terms, value by value and integral by integral") {
  const MaterialDescription description = paint();
  const Material sum = build(description);
  CHECK(sum.channels() == 3);
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 200; ++k) {
    const Direction o = from_angles(1.6 * unit(engine), 6 * unit(engine));
    const Direction i = from_angles(1.6 * unit(engine), 6 * unit(engine));
    for (const Quantity quantity : {Quantity::brdf, Quantity::brdf_cos}) {
      std::array<double, 3> expected{};
      for (const TermDescription& term : description.terms) {
        TermDescription alone = term;
        alone.weight = 1.0;
        const Material one = build(alone);
        const auto value = channels(one, quantity, o, i);
        for (std::size_t c = 0; c < 3; ++c)
          expected[c] += std::get<double>(term.weight) * value[one.channels() == 3 ? c : 0];
        const auto named = channels(sum, quantity, o, i, term.name.empty() ? term.type : term.name);
        CHECK(named[0] == doctest::Approx(std::get<double>(term.weight) * value[0]).epsilon(1e-14));
      }
      const auto value = channels(sum, quantity, o, i);
      for (std::size_t c = 0; c < 3; ++c) CHECK(value[c] == doctest::Approx(expected[c]).epsilon(1e-14));
    }
  }
  const Direction o = from_angles(0.8, 0.3);
  for (int c = 0; c < 3; ++c) {
    double expected = 0;
    for (const TermDescription& term : description.terms) {
      const Material one = build(term);
      expected += compute(Integral::albedo, one, o, 1e-10, one.channels() == 3 ? c : 0).value;
    }
    const Estimate e = compute(Integral::albedo, sum, o, 1e-9, c);
    CHECK(e.error <= 1e-9);
    CHECK(std::fabs(e.value - expected) <= 1e-9);
  }
}

TEST_CASE("terms: quantities of a microsurface are those of the term that is named") {
  const Material m = build(paint());
  const Direction o = from_angles(1.2, 0.3), i = from_angles(0.4, 2);
  for (const TermDescription& term : {coat(), flakes()}) {
    const Material one = build(term);
    for (const Quantity quantity : {Quantity::lambda, Quantity::d, Quantity::g1, Quantity::g2, Quantity::d_visible}) {
      const double alone = value(one, quantity, o, i);
      CHECK(channels(m, quantity, o, i, term.name)[0] == alone);
      if (term.name == "coat") CHECK(alone == evaluate(m.surface("coat"), quantity, o, i, std::nullopt));
    }
    CHECK(compute(Integral::projected_area, m, o, 1e-9, 0, term.name).value ==
          compute(Integral::projected_area, one, o, 1e-9).value);
    CHECK(channels(m, Quantity::fresnel, o, i, term.name)[0] == channels(one, Quantity::fresnel, o, i)[0]);
  }
  CHECK_THROWS_WITH_AS(channels(m, Quantity::g1, o, i),
                       doctest::Contains("accepted: TERM. before the name, of coat, flakes"), InputError);
  CHECK_THROWS_WITH_AS(channels(m, Quantity::g1, o, i, "lambert"), doctest::Contains("accepted: coat, flakes"),
                       InputError);
  CHECK_THROWS_WITH_AS(channels(m, Quantity::brdf, o, i, "coatt"), doctest::Contains("did you mean \"coat\"?"),
                       InputError);
  CHECK_THROWS_WITH_AS(channels(build(lambert(0.5)), Quantity::d, o, i),
                       doctest::Contains("none of its terms has a microsurface"), InputError);
  CHECK_THROWS_WITH_AS(compute(Integral::furnace, m, o), doctest::Contains("coat, flakes, lambert"), InputError);
}

TEST_CASE("terms: an albedo of facets, and Oren and Nayar's with the square for light that was reflected twice") {
  const Direction o = from_angles(0.9, 0.3), i = from_angles(0.4, 2);
  TermDescription facets = describe("ggx", 0.5);
  facets.type = "facet_diffuse";
  const double white = value(build(facets), Quantity::brdf, o, i);
  facets.values.set("albedo", Rgb{0.25, 0.5, 1});
  CHECK(channels(build(facets), Quantity::brdf, o, i)[0] == 0.25 * white);
  CHECK(channels(build(facets), Quantity::brdf, o, i)[2] == white);
  CHECK(compute(Integral::albedo, build(facets), o, 1e-6, 0).value ==
        doctest::Approx(0.25 * compute(Integral::albedo, build(facets), o, 1e-6, 2).value).epsilon(1e-5));

  TermDescription nayar;
  nayar.name = nayar.type = "oren_nayar";
  nayar.values.set("sigma", 0.6);
  const auto with = [&](const std::string& form, double albedo) {
    nayar.values.set("form", form);
    nayar.values.set("albedo", albedo);
    return value(build(nayar), Quantity::brdf, o, i);
  };
  const double twice = with("full", 1) - with("direct", 1);
  CHECK(twice > 0);
  CHECK(with("full", 0.5) == doctest::Approx(0.5 * with("direct", 1) + 0.25 * twice).epsilon(1e-13));
  CHECK(with("direct", 0.5) == 0.5 * with("direct", 1));
}

TEST_CASE("terms: parameters are set by the name of the term") {
  MaterialDescription description = paint();
  set_parameter(description, "coat.alpha", 0.7);
  set_parameter(description, "flakes.weight", 2);
  set_parameter(description, "lambert.albedo", 0.3);
  const Material m = build(description);
  CHECK(m.surface("coat").slopes().alpha_x == 0.7);
  CHECK(m.terms[1].weight.value == Rgb{2, 2, 2});
  CHECK(std::get<Lambert>(m.terms[2].term).albedo.value == Rgb{0.3, 0.3, 0.3});
  CHECK_THROWS_WITH_AS(set_parameter(description, "alpha", 1), doctest::Contains("coat.alpha"), MaterialError);
  CHECK_THROWS_WITH_AS(set_parameter(description, "coat.albedo", 1), doctest::Contains("albedo"), MaterialError);
}

TEST_CASE("terms: what cannot be built is refused with its place") {
  CHECK(error_of({"", {}, true}) == "/terms: found none; accepted: one or more");
  MaterialDescription twice{"", {lambert(0.1), lambert(0.2)}, true};
  CHECK(error_of(twice).starts_with("/terms/1/name: found \"lambert\" twice"));
  MaterialDescription odd = paint();
  odd.terms[1].type = "miror";
  CHECK(error_of(odd).starts_with("/terms/1/type: unknown type \"miror\"; did you mean \"mirror\"?"));
  odd = paint();
  odd.terms[2].fresnel.type = "schlick";
  CHECK(error_of(odd).starts_with("/terms/2/fresnel/type: found \"schlick\""));
  odd = paint();
  odd.terms[2].values.set("albedo", 1.5);
  CHECK(error_of(odd).starts_with("/terms/2/albedo: "));
  odd = paint();
  odd.terms[2].weight = -1.0;
  CHECK(error_of(odd).starts_with("/terms/2/weight: found -1"));
  odd = paint();
  odd.terms[0] = general("ggx", 0.2, 0.2, 0, {0.1, 0});
  odd.terms[0].name = "coat";
  CHECK(error_of(odd).starts_with("/terms: found a mean slope"));
  odd.terms.resize(1);
  CHECK(error_of(odd).empty());
}

TEST_CASE("terms: several weights in one pass are each in a pass of its own") {
  const Material m = build(paint());
  std::vector<const WeightedTerm*> terms;
  for (const WeightedTerm& term : m.terms) terms.push_back(&term);
  const std::vector<LightWeight> weights = {[](const Direction& i) { return i.x; },
                                            [](const Direction& i) { return i.z; }, every_direction};
  for (const double theta : {0.0, 0.7, 1.5})
    for (const std::size_t channel : {0U, 2U}) {
      const Direction o = from_angles(theta, 0);
      const ColourEstimate all = reflected_moments(terms, o, 1e-8, channel, weights);
      for (std::size_t k = 0; k < weights.size(); ++k) {
        const Estimate one = reflected_light(terms, o, 1e-8, {channel, 1}, weights[k]).channel(0);
        CAPTURE(theta);
        CHECK(all.error[k] <= 1e-8);
        CHECK(std::fabs(all.value[k] - one.value) <= all.error[k] + one.error);
      }
    }
}
