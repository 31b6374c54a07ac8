#include "materials.hpp"

#include "base/errors.hpp"
#include "choice/advise/shader/cost.hpp"
#include "choice/advise/shader/sampling_cost.hpp"
#include "choice/advise/shader/sampling_forms.hpp"
#include "choice/methods/newton_slope.hpp"
#include "microfacet/distributions/beckmann.hpp"
#include "microfacet/distributions/ggx.hpp"
#include "sampling/cosine.hpp"
#include "sampling/sampler.hpp"

#include <doctest/doctest.h>

using namespace test;
namespace forms = brdfplot::choice::forms;

namespace {

constexpr double numbers[] = {0.01, 0.3, 0.62, 0.97};

double apart(const Direction& a, const forms::Vector<double>& b) {
  return std::fmax(std::fabs(a.x - b.x), std::fmax(std::fabs(a.y - b.y), std::fabs(a.z - b.z)));
}

} // namespace

TEST_CASE("the formulas whose operations are counted draw what the program draws") {
  for (const double u1 : numbers)
    for (const double u2 : numbers) {
      CAPTURE(u1);
      CAPTURE(u2);
      CHECK(apart(sample_cosine({0, 0, 1}, u1, u2), forms::cosine_lobe(u1, u2)) < 1e-14);
      CHECK(forms::ground_slope_ggx(u1) == doctest::Approx(GgxShape::slope_within(u1)).epsilon(1e-14));
      CHECK(forms::ground_slope_beckmann(u1) == doctest::Approx(BeckmannShape::slope_within(u1)).epsilon(1e-14));
      for (const double theta : {0.2, 0.9, 1.5}) {
        const double c = std::cos(theta), s = std::sin(theta);
        const UnitSlope cap = GgxShape::visible_slope(c, s, u1, u2), disc = GgxShape::visible_slope_2018(c, s, u1, u2);
        const auto of_cap = forms::visible_slopes_ggx(c, s, u1, u2),
                   of_disc = forms::visible_slopes_ggx_2018(c, s, u1, u2);
        CHECK(of_cap.facing == doctest::Approx(cap.facing).epsilon(1e-10));
        CHECK(of_cap.across == doctest::Approx(cap.across).epsilon(1e-10));
        CHECK(of_disc.facing == doctest::Approx(disc.facing).epsilon(1e-10));
        CHECK(of_disc.across == doctest::Approx(disc.across).epsilon(1e-10));
        const UnitSlope beckmann = BeckmannShape::visible_slope(c, s, u1, u2);
        CHECK(choice::NewtonSlope{8}(std::array{theta, u1}) == doctest::Approx(beckmann.facing).epsilon(1e-6));
        CHECK(choice::erf_inverse(2 * u2 - 1) == doctest::Approx(beckmann.across).epsilon(1e-9));
      }
    }
}

TEST_CASE("directions that are mirrored at stretched slopes are the program's") {
  const Material material = build(general("ggx", 0.3, 0.6, 0));
  const Sampler sampler(material, "visible_normals");
  for (const double theta : {0.3, 1.4}) {
    const Direction o = from_angles(theta, 0.7);
    const Sampler::Viewer viewer(sampler, o);
    const forms::Vector<double> seen_from{o.x, o.y, o.z};
    const forms::StretchedViewer<double> v(seen_from, 0.3, 0.6);
    for (const double u1 : numbers) {
      const auto m = forms::stretched_normal(forms::visible_slopes_ggx(v.c, v.s, u1, 0.4), v.x, v.y, 0.3, 0.6);
      CHECK(apart(viewer.sample({u1, 0.4, 0.5}), forms::mirrored(seen_from, m)) < 1e-13);
    }
  }
}

TEST_CASE("a sample costs more than the BRDF, the more the better its strategy, and most where Newton finds Beckmann's "
          "slopes") {
  const auto cost = [](const std::string& type, const std::string& strategy) {
    return choice::cost(choice::sampling_operations(describe(type, 0.5), strategy));
  };
  const choice::ShaderOperations brdf = choice::shader_operations(describe("ggx", 0.5));
  const double of_brdf = choice::cost(brdf.view) + choice::cost(brdf.light);
  double cheaper = of_brdf;
  for (const auto* strategy : {"cosine", "half_vector", "visible_normals", "heitz_2018"}) {
    CAPTURE(strategy);
    CHECK(cost("ggx", strategy) > cheaper);
    cheaper = cost("ggx", strategy);
  }
  CHECK(cost("ggx", "default") == cost("ggx", "visible_normals"));
  CHECK(cost("beckmann", "visible_normals") > 2 * cost("beckmann", "half_vector"));
  CHECK_THROWS_WITH_AS(cost("velvet", "visible_normals"), doctest::Contains("mirror of ggx or beckmann"), InputError);
  CHECK_THROWS_AS(cost("beckmann", "heitz_2018"), InputError);
}
