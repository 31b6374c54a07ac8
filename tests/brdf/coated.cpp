// Coats and what lies beneath them, wrap lighting and Turquin's scaling: against the formulas written out, and
// integrals against sums that know nothing of the library's.
#include "../materials.hpp"
#include "../sample.hpp"
#include "analysis/integrals.hpp"
#include "brdf/evaluate_single.hpp"
#include "brdf/integrals/term_albedo.hpp"
#include "microfacet/fresnel.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

using namespace test;

namespace {

using std::numbers::pi;

TermDescription glass_coat(double weight = 1) {
  TermDescription coat = describe("ggx", 0.1);
  coat.name = "coat";
  coat.weight = weight;
  coat.fresnel.type = "dielectric";
  coat.fresnel.values.set("eta", 1.5);
  return coat;
}

TermDescription gold() {
  TermDescription base = describe("beckmann", 0.4);
  base.name = "gold";
  base.fresnel.type = "schlick";
  base.fresnel.values.set("f0", Rgb{1, 0.7, 0.3});
  return base;
}

TermDescription matte() {
  TermDescription base;
  base.name = "matte";
  base.type = "lambert";
  base.values.set("albedo", Rgb{0.8, 0.5, 0.1});
  return base;
}

/// A coated term of the coat and the base, as the reader makes it.
MaterialDescription coated(TermDescription coat, std::vector<TermDescription> base, const std::string& attenuation,
                           const Value& tint = 1.0) {
  LayerDescription layer{"paint", 1.0, "", {}, "/terms/0"};
  layer.values.set("attenuation", attenuation);
  layer.values.set("tint", tint);
  coat.layers = {layer};
  layer.coat = coat.name;
  MaterialDescription all{"coated", {coat}, true};
  for (TermDescription& term : base) {
    term.layers = {layer};
    all.terms.push_back(term);
  }
  return all;
}

std::array<double, 3> rho(const Material& m, const Direction& o, const Direction& i, const std::string& term = "",
                          Quantity quantity = Quantity::brdf) {
  std::array<double, 3> out{};
  evaluate(m, quantity, {1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, {}}, out.data(), term);
  return out;
}

double albedo(const Material& m, const Direction& o, std::size_t channel, const std::string& term = "") {
  return compute_channels_or_throw(Integral::albedo, m, o, 1e-8, term)[channel];
}

/// A sum of midpoints in theta and phi, finer than it has to be for what is smooth.
template <class F>
double over_lights(double theta_end, const F& f) {
  constexpr int rows = 800, columns = 40;
  double sum = 0;
  for (int r = 0; r < rows; ++r) {
    const double theta = (r + 0.5) * theta_end / rows;
    for (int k = 0; k < columns; ++k) sum += std::sin(theta) * f(from_angles(theta, (k + 0.5) * 2 * pi / columns));
  }
  return sum * theta_end / rows * 2 * pi / columns;
}

TermDescription wrap(double w, const std::string& form, const Value& scatter = 1.0) {
  TermDescription term;
  term.type = "wrap";
  term.values.set("albedo", 0.5);
  term.values.set("w", w);
  term.values.set("form", form);
  term.values.set("scatter", scatter);
  return term;
}

std::string error_of(const MaterialDescription& description) {
  try {
    build(description);
  } catch (const MaterialError& error) {
    return error.what();
  }
  return "none";
}

} // namespace

TEST_CASE("coated: the base is seen through the coat as each attenuation says") {
  const Direction o = from_angles(1.2, 0.3), i = from_angles(0.7, 2.5);
  const double weight = 0.7;
  const auto left = [&](double c) { return 1 - weight * dielectric_reflectance(c, 1.5); };
  const double oh = std::sqrt(0.5 * (1 + dot(o, i)));
  const Material alone = build(MaterialDescription{"base", {gold(), matte()}, true});
  const auto base = rho(alone, o, i);
  const auto coat = rho(build(MaterialDescription{"coat", {glass_coat(weight)}, true}), o, i);
  const std::vector<std::pair<std::string, double>> factors = {
      {"both", left(o.z) * left(i.z)}, {"half", left(o.z)}, {"half_vector", left(oh)}, {"none", 1.0}};
  for (const auto& one : factors) {
    const std::string& attenuation = one.first;
    const double factor = one.second;
    CAPTURE(attenuation);
    const Material m = build(coated(glass_coat(weight), {gold(), matte()}, attenuation));
    const auto got = rho(m, o, i), part = rho(m, o, i, "gold"), group = rho(m, o, i, "paint");
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(got[c] == doctest::Approx(coat[0] + factor * base[c]).epsilon(1e-13));
      CHECK(part[c] == doctest::Approx(factor * rho(alone, o, i, "gold")[c]).epsilon(1e-13));
      CHECK(group[c] == got[c]);
    }
  }
}

TEST_CASE("coated: what passes at grazing keeps its digits") {
  // 1 - F of eta = 1.5 by mpmath with 60 digits (tests/microfacet/fresnel_losses.cpp).
  const std::vector<std::pair<double, double>> lost = {{1e-12, 5.8137767414800531e-12},
                                                       {1e-6, 5.8137573415503234e-6},
                                                       {0.003, 0.017268094008831595},
                                                       {0.1, 0.42840747965755082}};
  const Direction up{0, 0, 1};
  for (const auto& [c, left] : lost) {
    const double shown = c; // Clang 14 has no structured binding in the lambda of CAPTURE
    CAPTURE(shown);
    const Direction o{std::sqrt((1 - c) * (1 + c)), 0, c}, opposite{-o.x, 0, c};
    const auto base = [&](const std::string& attenuation, const Direction& i) {
      return rho(build(coated(glass_coat(), {matte()}, attenuation)), o, i, "matte")[0] * pi / 0.8;
    };
    CHECK(relative(base("half", up), left) < 1e-14);
    CHECK(relative(base("both", up), left * 0.96) < 1e-14);
    CHECK(relative(base("both", opposite), left * left) < 1e-14);
    CHECK(relative(base("half_vector", opposite), left) < 1e-14); // o.h = c
  }
}

TEST_CASE("coated: a tint is what the way through the coat leaves, twice its square root along the normal") {
  const Rgb tint{0.5, 0.9, 0};
  const Material m = build(coated(glass_coat(), {matte()}, "none", tint)),
                 clear = build(coated(glass_coat(), {matte()}, "none"));
  const Direction normal{0, 0, 1}, o = from_angles(1.55, 0), i = from_angles(0.4, 1);
  const auto cosine_within = [](const Direction& d) { return std::sqrt(1 - (1 - d.z * d.z) / 2.25); };
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(rho(m, normal, normal, "matte")[c] == doctest::Approx(tint[c] * rho(clear, normal, normal, "matte")[c]));
    const double path = 0.5 * (1 / cosine_within(o) + 1 / cosine_within(i));
    CHECK(rho(m, o, i, "matte")[c] ==
          doctest::Approx(std::pow(tint[c], path) * rho(clear, o, i, "matte")[c]).epsilon(1e-13));
    CHECK(rho(m, o, i, "coat")[c] == rho(clear, o, i, "coat")[c]);
  }
}

TEST_CASE("coated: albedos are the integrals of what is evaluated") {
  for (const std::string attenuation : {"both", "half", "half_vector"}) {
    CAPTURE(attenuation);
    const Material m = build(coated(glass_coat(), {gold(), matte()}, attenuation, Rgb{0.9, 0.8, 0.7}));
    const Direction o = from_angles(1.0, 0);
    for (const std::string term : {"gold", "matte"}) {
      const double truth = over_lights(pi / 2, [&](const Direction& i) { return rho(m, o, i, term)[1] * i.z; });
      CHECK(albedo(m, o, 1, term) == doctest::Approx(truth).epsilon(1e-5));
    }
    CHECK(albedo(m, o, 1) ==
          doctest::Approx(albedo(m, o, 1, "coat") + albedo(m, o, 1, "gold") + albedo(m, o, 1, "matte")).epsilon(1e-7));
  }
}

TEST_CASE("coated: beneath a sheen lies what its albedo leaves") {
  TermDescription sheen = describe("ggx", 0.6); // tables of sheens take a minute
  sheen.name = "sheen";
  sheen.weight = Rgb{0.5, 0.2, 0.1};
  const Material m = build(coated(sheen, {matte()}, "albedo"));
  TermDescription white = matte();
  white.values.set("albedo", 1.0);
  const Material full = build(coated(sheen, {white}, "albedo"));
  for (const double theta : sample_of(std::vector<double>{0.8, 0.1, 1.5}, 3)) {
    const Direction o = from_angles(theta, 0.4), i = from_angles(0.6, 3);
    const Rgb at_o = compute_channels_or_throw(Integral::albedo, m, o, 1e-8, "sheen");
    const Rgb at_i = compute_channels_or_throw(Integral::albedo, m, i, 1e-8, "sheen");
    const Rgb sum = compute_channels_or_throw(Integral::albedo, full, o, 1e-7);
    for (std::size_t c = 0; c < 3; ++c) {
      const double least = std::min(1 - at_o[c], 1 - at_i[c]);
      CHECK(rho(m, o, i, "matte")[c] == doctest::Approx(least * Rgb{0.8, 0.5, 0.1}[c] / pi).epsilon(1e-7));
      CHECK(rho(m, o, i, "matte")[c] == doctest::Approx(rho(m, i, o, "matte")[c]).epsilon(1e-14));
      CHECK(sum[c] <= 1 + 1e-6);
    }
  }
}

TEST_CASE("coated: coats lie over coats, and names set what they are of") {
  MaterialDescription twice = coated(glass_coat(), {gold()}, "both");
  LayerDescription outer{"varnish", 0.5, "top", {}, "/terms/0"};
  TermDescription top = glass_coat();
  top.name = "top";
  for (TermDescription& term : twice.terms) term.layers.insert(term.layers.begin(), outer);
  outer.coat.clear();
  top.layers = {outer};
  twice.terms.insert(twice.terms.begin(), top);
  const Direction o = from_angles(1.1, 0), i = from_angles(0.5, 1);
  const double left = (1 - dielectric_reflectance(o.z, 1.5)) * (1 - dielectric_reflectance(i.z, 1.5));
  const double base = rho(build(gold()), o, i)[0];
  CHECK(rho(build(twice), o, i, "gold")[0] == doctest::Approx(0.5 * left * left * base).epsilon(1e-13));
  set_parameter(twice, "top.eta", 1.0 + 1e-9);
  set_parameter(twice, "varnish.weight", 1.0);
  CHECK(rho(build(twice), o, i, "gold")[0] == doctest::Approx(left * base).epsilon(1e-12));
  set_parameter(twice, "paint.tint", 0.25);
  CHECK(rho(build(twice), {0, 0, 1}, {0, 0, 1}, "gold")[0] ==
        doctest::Approx(0.25 * 0.96 * 0.96 * rho(build(gold()), {0, 0, 1}, {0, 0, 1})[0]).epsilon(1e-8));
  const auto keys = parameter_keys(twice);
  for (const std::string key : {"top.eta", "varnish.weight", "paint.tint", "gold.alpha"})
    CHECK(std::ranges::count(keys, key) == 1);
}

TEST_CASE("coated: what a coat has not is refused, with what is accepted") {
  TermDescription plain = matte();
  plain.name = "coat";
  CHECK(error_of(coated(plain, {gold()}, "both"))
            .find("/terms/0/attenuation: found \"both\" with the coat \"coat\", "
                  "which has no Fresnel term") != std::string::npos);
  CHECK(error_of(coated(plain, {gold()}, "none", 0.5)).find("/terms/0/tint") != std::string::npos);
  TermDescription thin = glass_coat();
  thin.fresnel.values.set("eta", 0.7);
  CHECK(error_of(coated(thin, {gold()}, "both")).find("eta >= 1") != std::string::npos);
  CHECK(error_of(coated(glass_coat(2), {gold()}, "half")).find("weight in [0, 1]") != std::string::npos);
  TermDescription brushed = glass_coat();
  brushed.distribution = general("ggx", 0.1, 0.4, 0).distribution;
  CHECK(error_of(coated(brushed, {gold()}, "albedo")).find("isotropic coat") != std::string::npos);
}

TEST_CASE("wrap: Eq. 9.71 in its three readings, from below the horizon too") {
  const double w = 0.4;
  const auto clamp = [](double x) { return std::min(std::max(x, 0.0), 1.0); };
  const Direction o = from_angles(0.3, 0);
  for (const double l : {-0.5, -0.4, -0.2, 0.0, 0.1, 0.55, 0.6, 0.9, 1.0}) {
    CAPTURE(l);
    const Direction i{std::sqrt(1 - l * l), 0, l};
    const double scatter = clamp(0.3 + std::max(l, 0.0));
    const std::array<double, 3> expected = {scatter * clamp(l + w) / (1 + w), scatter * clamp((l + w) / (1 + w)),
                                            scatter * std::max(l + w, 0.0) / ((1 + w) * (1 + w))};
    std::size_t form = 0;
    for (const std::string name : {"printed", "ratio", "conserving"}) {
      const Material m = build(wrap(w, name, 0.3));
      const double light = 0.5 / pi * expected[form++];
      CHECK(rho(m, o, i, "", Quantity::brdf_cos)[0] == doctest::Approx(light).epsilon(1e-14));
      CHECK(rho(m, o, i)[0] == doctest::Approx(l > 0 ? light / l : 0).epsilon(1e-14));
    }
  }
}

TEST_CASE("wrap: its integrals are over all light; 1 / (1 + w)^2 conserves, the others do not") {
  const Direction o = from_angles(0.8, 0.1);
  for (const double w : {0.0, 0.3, 1.0}) {
    CAPTURE(w);
    CHECK(albedo(build(wrap(w, "conserving")), o, 0) == doctest::Approx(0.5).epsilon(1e-8));
    // 2 int of clamp(x + w) / (1 + w) and of (x + w) / (1 + w) from -w to 1
    CHECK(albedo(build(wrap(w, "printed")), o, 0) == doctest::Approx(0.5 * 2 * (0.5 + w) / (1 + w)).epsilon(1e-8));
    CHECK(albedo(build(wrap(w, "ratio")), o, 0) == doctest::Approx(0.5 * (1 + w)).epsilon(1e-8));
    const Material tinted = build(wrap(w, "printed", Rgb{0.2, 0.5, 0.9}));
    for (std::size_t c = 0; c < 3; ++c) {
      const double truth =
          over_lights(std::acos(-w), [&](const Direction& i) { return rho(tinted, o, i, "", Quantity::brdf_cos)[c]; });
      CHECK(albedo(tinted, o, c) == doctest::Approx(truth).epsilon(1e-5));
    }
  }
}

TEST_CASE("turquin: with F = 1 all light comes back; with F it is the first bounce times f0 (1 - E) / E") {
  for (const std::string masking : {"smith", "v_cavity"}) {
    const TermDescription mirror = describe("ggx", 0.6, masking);
    TermDescription further;
    further.type = "turquin";
    further.of = {mirror};
    const Material m = build(MaterialDescription{"sum", {mirror, further}, true});
    for (const double theta : {0.0, 0.7, 1.3, 1.55}) {
      const Direction o = from_angles(theta, 0);
      CHECK(std::fabs(albedo(m, o, 0) - 1) < 1e-6);
    }
  }
  TermDescription metal = gold(), further;
  further.type = "turquin";
  further.of = {metal};
  const Material alone = build(further), first = build(metal);
  TermDescription white = metal;
  white.fresnel = {.type = "none"};
  const Direction o = from_angles(1.0, 0.2), i = from_angles(0.9, 3.2);
  const double e = albedo(build(white), o, 0);
  const Rgb f0{1, 0.7, 0.3};
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(rho(alone, o, i)[c] == doctest::Approx(rho(first, o, i)[c] * f0[c] * (1 - e) / e).epsilon(1e-6));
  TermDescription flat;
  flat.type = "turquin";
  flat.of = {matte()};
  CHECK(error_of(flat).find("/of/type: found \"lambert\"; accepted: mirror") != std::string::npos);
}

TEST_CASE("mean_fresnel: F over the visible normals by Eq. 105, and under light from everywhere by Eqs. 9.58 to 9.60") {
  const Material metal = build(gold());
  const Direction o = from_angles(1.1, 0);
  const Microsurface& surface = metal.surface();
  for (std::size_t c = 0; c < 3; ++c) {
    const double truth = over_lights(pi / 2, [&](const Direction& m) {
      const double om = dot(o, m);
      return om > 0 ? evaluate(surface, Quantity::d_visible, o, std::nullopt, m) *
                          schlick_reflectance(om, std::array{1.0, 0.7, 0.3}[c], 1, 5)
                    : 0;
    });
    const Estimate e = compute(Integral::mean_fresnel, metal, o, 1e-9, static_cast<int>(c));
    CHECK(e.value == doctest::Approx(truth).epsilon(1e-4));
    CHECK(e.error < 1e-9);
    CHECK(compute(Integral::average_fresnel, metal, o, 1e-9, static_cast<int>(c)).value ==
          doctest::Approx((20 * std::array{1.0, 0.7, 0.3}[c] + 1) / 21).epsilon(1e-14));
  }
  // F = 1 everywhere: the norm of visible normals, for facets seen one by one as well
  CHECK(compute(Integral::mean_fresnel, build(describe("ggx", 0.5, "v_cavity")), o, 1e-9).value ==
        doctest::Approx(1).epsilon(1e-9));
  CHECK_THROWS_AS(compute(Integral::mean_fresnel, build(matte()), o, 1e-9), InputError);
}
