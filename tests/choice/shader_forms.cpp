#include "choice/advise/shader/forms.hpp"

#include "brdf/evaluate.hpp"
#include "choice/advise/shader/cost.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace brdfplot;
using namespace brdfplot::choice;

namespace {

Material material_of(const std::string& type, double alpha_x, double alpha_y, const std::string& masking = "smith") {
  TermDescription term;
  term.distribution = {.type = type};
  term.distribution.values.set("alpha_x", alpha_x);
  term.distribution.values.set("alpha_y", alpha_y);
  term.masking = {.type = masking};
  return build(term);
}

const std::vector<Direction> directions = {from_angles(0.2, 1), from_angles(0.9, -2), from_angles(1.4, 0.4)};

forms::Vector<double> as_vector(const Direction& d) { return {d.x, d.y, d.z}; }

} // namespace

// What is counted is what is evaluated.
TEST_CASE("forms of D and Lambda give what the program evaluates") {
  constexpr double ax = 0.3, ay = 0.5;
  const forms::Stretch<double> s{1 / ax, 1 / ay, 0, 1, 0, 0, 1 / (std::numbers::pi * ax * ay), false};
  const forms::Roughness<double> a{ax, ay, 0, 1, false};
  const Material ggx = material_of("ggx", ax, ay), beckmann = material_of("beckmann", ax, ay),
                 walter = material_of("beckmann", ax, ay, "smith_rational");
  for (const Direction& d : directions) {
    const auto v = as_vector(d);
    CHECK(forms::d_ggx(v, s) == doctest::Approx(evaluate(ggx, Quantity::d, d, {}, d)));
    CHECK(forms::d_beckmann(v, s) == doctest::Approx(evaluate(beckmann, Quantity::d, d, {}, d)));
    const double s2 = forms::projected2(v, a);
    CHECK(forms::masked_ggx(v.z, s2) / v.z == doctest::Approx(evaluate(ggx, Quantity::lambda, d, {}, {})));
    CHECK(forms::masked_beckmann(v.z, s2) / v.z == doctest::Approx(evaluate(beckmann, Quantity::lambda, d, {}, {})));
    CHECK(forms::masked_walter(v.z, s2) / v.z == doctest::Approx(evaluate(walter, Quantity::lambda, d, {}, {})));
  }
}

TEST_CASE("a mirror's rho by forms") {
  const Material ggx = material_of("ggx", 0.4, 0.4);
  const forms::Stretch<double> s{2.5, 2.5, 0, 1, 0, 0, 1 / (std::numbers::pi * 0.16)};
  const forms::Roughness<double> a{0.4, 0.4, 0, 1};
  for (const Direction& o : directions)
    for (const Direction& i : directions) {
      const auto u = as_vector(o), v = as_vector(i);
      const double t_o = forms::masked_ggx(u.z, forms::projected2(u, a));
      const double t_i = forms::masked_ggx(v.z, forms::projected2(v, a));
      const double rho = forms::d_ggx(forms::half_vector(u, v), s) * forms::visibility_height(u.z, t_o, v.z, t_i) / 4;
      CHECK(rho == doctest::Approx(evaluate(ggx, Quantity::brdf, o, i, {})));
    }
}

TEST_CASE("forms of F") {
  for (const double c : {0.05, 0.4, 1.0}) {
    CHECK(forms::dielectric(c, 1.25) == doctest::Approx(dielectric_reflectance(c, 1.5)));
    const double eta = 1.44, k = 1.6;
    CHECK(forms::conductor(c, eta * eta - k * k, 4 * eta * eta * k * k) ==
          doctest::Approx(conductor_reflectance(c, eta, k)));
    CHECK(forms::schlick(forms::fifth_power(c), 0.04, 0.96) == doctest::Approx(schlick_reflectance(c, 0.04, 1, 5)));
  }
}

TEST_CASE("what is simpler costs less") {
  const auto cost_with = [](const std::string& fresnel, const char* key) {
    TermDescription term;
    term.name = "m";
    term.distribution = {.type = "ggx"};
    term.distribution.values.set("alpha", 0.3);
    term.fresnel = {.type = fresnel};
    term.fresnel.values.set(key, Rgb{0.5, 0.6, 0.7});
    const MaterialDescription material("m", {term}, true);
    return shader_cost(material, {{0.5, 0, 0, {}}, {1, 0, 0.1, {}}}, {LightModel::Kind::points, 2});
  };
  CHECK(cost_with("conductor", "eta") > cost_with("f82", "f0"));
  CHECK(cost_with("f82", "f0") > cost_with("schlick", "f0"));
}
