// Mixtures whose parts are inclined each in a way of its own, as the facets of averaged normals are.
#include "../materials.hpp"
#include "analysis/properties.hpp"
#include "sampling/sampler.hpp"

#include <doctest/doctest.h>

using namespace test;

namespace {

/// Three parts, of which at grazing two are seen from below.
TermDescription three() {
  return mixture({{0.5, general("beckmann", 0.3, 0.1, 0.2, {0.7, -0.2}).distribution},
                  {0.3, general("ggx", 0.15, 0.4, -0.5, {-0.9, 0.4}).distribution},
                  {0.2, general("beckmann", 0.02, 0.03, 0, {0.1, 1.1}).distribution}});
}

} // namespace

TEST_CASE("the mesosurface of a mixture has the mean of its parts' slopes") {
  const SlopeMap map = build(three()).surface().slopes();
  CHECK(map.mean_x == doctest::Approx(0.5 * 0.7 - 0.3 * 0.9 + 0.2 * 0.1).epsilon(1e-15));
  CHECK(map.mean_y == doctest::Approx(-0.5 * 0.2 + 0.3 * 0.4 + 0.2 * 1.1).epsilon(1e-15));
}

TEST_CASE("c and Lambda of a mixture of inclined parts, some of them seen from below") {
  // By mpmath with 50 digits: c = sum w_k c_k, sigma_k of Beckmann c (1 + erf a) / 2 + s exp(-a^2) / (2 sqrt pi), of
  // GGX (c + sqrt(c^2 + s^2)) / 2, at any sign of c.
  const Material m = build(three());
  for (const auto& [theta, phi, c, of_smith] :
       std::initializer_list<std::array<double, 4>>{{0.3, 1, 0.8796882611774428, 0.00068823996597204737},
                                                    {0.9, 0.2, 0.50748918800263881, 0.024568669414059637},
                                                    {0.9, 3.3, 0.72861786322296692, 0.026570401653086301},
                                                    {1.2, 0.1, 0.24728780206662336, 0.56260146060298448},
                                                    {1.2, 1.6, 0.14148526392372567, 1.3684331720202984},
                                                    {1.45, 4, 0.36569986125942469, 0.194883882757857},
                                                    {1.5, 2.9, 0.11031379031616244, 2.6428635431416597},
                                                    {0.7, 1.6, 0.61217695341096795, 0.015730772222320732}}) {
    const double shown = theta; // Clang 14 has no structured binding in the lambda of CAPTURE
    CAPTURE(shown);
    const Direction o = from_angles(theta, phi);
    CHECK(relative(m.surface().slopes().project(o).c, c) < 1e-14);
    CHECK(relative(lambda(m, o), of_smith) < 1e-13);
    CHECK(relative(g1(m, o), 1 / (1 + of_smith)) < 1e-14);
  }
  CHECK(lambda(m, {0, 0, 1}) == 0);
}

TEST_CASE("masked areas of whatever masks go on through the horizon of a part") {
  // A part of which nothing else is at its mesosurface: c_1 = 0 where tan theta = 1 / 0.8.
  for (const std::string masking : {"smith", "smith_rational", "karis", "schlick_smith", "schlick_smith_rational"}) {
    TermDescription two = mixture({{1, general("beckmann", 0.4, 0.4, 0, {0.8, 0}).distribution},
                                   {3, general("beckmann", 0.4, 0.4, 0, {-0.2, 0}).distribution}});
    two.masking.type = masking;
    const Material m = build(two);
    INFO(masking);
    const double at = std::atan(1 / 0.8);
    const double before = lambda(m, from_angles(at - 1e-9, 0)), after = lambda(m, from_angles(at + 1e-9, 0));
    CHECK(before > 0.01);
    CHECK(relative(after, before) < 1e-7);
    for (const double theta : {0.2, 0.8, 1.2, 1.5}) CHECK(lambda(m, from_angles(theta, 0)) >= 0);
  }
}

TEST_CASE("a mixture of inclined parts has all that Smith's masking says, and V-cavities do not") {
  const PropertySearch search{{0.0, 0.9, 1.4}, 1e-6};
  for (const auto& info : properties()) {
    const Residual residual = measure(info.property, {three()}, search);
    INFO(info.name << ": " << residual.max_residual << " at " << residual.theta_o << ", " << residual.phi_o);
    CHECK(residual.verdict ==
          (info.property == Property::stretch_invariance ? Verdict::not_applicable : Verdict::holds));
  }
  // Their cavities have a mirror image of each normal about the mean, which this distribution has not.
  TermDescription cavities = three();
  cavities.masking.type = "v_cavity";
  const Residual residual = measure(Property::eq14, {cavities}, search);
  CHECK(residual.verdict == Verdict::fails);
  CHECK(residual.max_residual > 0.01);
}

TEST_CASE("visible normals are not drawn of parts that may be seen from below; the default draws others") {
  const Material m = build(three());
  CHECK_THROWS_WITH(Sampler(m, "visible_normals"),
                    doctest::Contains("has no strategy \"visible_normals\"; accepted: default, or what each term has"));
  CHECK(default_strategy(m.terms[0]) == Strategy::half_vector);
}
