#include "choice/advise/advise.hpp"
#include "choice/advise/examine.hpp"
#include "choice/advise/images/against_walk.hpp"
#include "choice/advise/single.hpp"
#include "choice/advise/target.hpp"

#include "base/errors.hpp"
#include "sample.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace brdfplot;
using namespace brdfplot::choice;

namespace {

constexpr double pi = std::numbers::pi;

TermDescription mirror(const std::string& distribution, double alpha, const std::string& fresnel = "none") {
  TermDescription term;
  term.name = "mirror";
  term.distribution = {.type = distribution};
  term.distribution.values.set("alpha", alpha);
  term.fresnel = {.type = fresnel};
  if (fresnel == "schlick") term.fresnel.values.set("f0", Rgb{0.9, 0.6, 0.3});
  if (fresnel == "dielectric") term.fresnel.values.set("eta", 1.5);
  if (fresnel != "conductor") return term;
  term.fresnel.values.set("eta", Rgb{0.143, 0.374, 1.442});
  term.fresnel.values.set("k", Rgb{3.983, 2.385, 1.603});
  return term;
}

AdviceScene scene_of(std::vector<TermDescription> terms, Target target, double delta_e) {
  AdviceScene scene;
  scene.name = "a scene";
  scene.materials = {{MaterialDescription("a material", std::move(terms), true), {}, "here"}};
  scene.lights = {{0.8, 1, 0, {{2, 2, 2}, false}}, {2.3, -1, 0, {{1, 1, 1}, false}}};
  scene.view = {{0, pi / 2}, {}};
  scene.tolerance = {Metric::delta_e, delta_e};
  scene.target = target;
  return scene;
}

MaterialAdvice advise_first(const AdviceScene& scene) { return advise(scene, scene.materials[0], {1, {}}); }

bool says(const MaterialAdvice& advice, const std::string& label) {
  const auto labels = simplifications(advice, advice.models[*advice.answer]);
  return std::ranges::find(labels, label) != labels.end();
}

const std::string single = "numbers: single precision (was double)";

/// The largest relative change by single precision over directions within `cone` of the normal.
double largest_rounding(const TermDescription& term, double cone) {
  const SingleForm form(term);
  double most = 0;
  for (int k = 0; k < 400; ++k) {
    const double t = (k + 0.5) / 400;
    const Direction o = from_angles(cone * t, 2.4 * k), i = from_angles(cone * std::fmod(t * 37, 1.0), 1.7 * k);
    std::array<double, 3> values = {1, 1, 1};
    form.round(o, i, values);
    for (const double value : values) most = std::max(most, std::fabs(value - 1));
  }
  return most;
}

} // namespace

TEST_CASE("targets: nothing costs more in single precision, and the shader's costs are those of operations.hpp") {
  const Operations each[] = {{1, 0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0, 0}, {0, 0, 0, 1, 0, 0, 0},
                             {0, 0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 0, 1}};
  for (const Operations& one : each) {
    CHECK(cost(one, Target::shader, Precision::full) == cost(one));
    for (const Target target : {Target::double_one, Target::double_lanes})
      CHECK(cost(one, target, Precision::single) <= cost(one, target, Precision::full));
  }
  CHECK(target_names().size() == 5);
  CHECK(target_of("double_simd") == Target::double_lanes);
  CHECK(cost({2, 1, 1, 0, 0, 0, 0}, Target::double_one, Precision::full) == 10);
}

TEST_CASE("single precision is good where no formula cancels, and bad in a narrow highlight written by its cosine") {
  for (const char* fresnel : {"none", "schlick", "dielectric", "conductor"})
    for (const char* distribution : {"ggx", "beckmann"})
      CHECK(largest_rounding(mirror(distribution, 0.3, fresnel), 1.2) < 2e-5);
  // The sheen's 1 - z^2 loses digits about the normal, where it vanishes: half vectors here come within 0.01 of it.
  CHECK(largest_rounding(mirror("sheen", 0.5), 1.2) < 1e-3);
  // 1 - z^2 has an absolute error of 2^-24 or so, over alpha^2 = 1e-6: some percent of D.
  CHECK(largest_rounding(mirror("ggx", 1e-3), 2e-3) > 0.02);
  // As sums of squares nothing cancels.
  TermDescription stretched = mirror("ggx", 1e-3);
  stretched.distribution.values = {};
  stretched.distribution.values.set("alpha_x", 1e-3);
  stretched.distribution.values.set("alpha_y", 1.0001e-3);
  CHECK(largest_rounding(stretched, 2e-3) < 1e-5);
}

TEST_CASE("double to float is a rung, taken where the scene does not tell and refused where it does") {
  for (const Target target : {Target::double_one, Target::double_lanes}) {
    const MaterialAdvice rough = advise_first(scene_of({mirror("ggx", 0.3, "conductor")}, target, 1));
    REQUIRE(rough.answer);
    CHECK(says(rough, single));
  }
  // A polished mirror seen from close: nothing but its highlight.
  AdviceScene polished = scene_of({mirror("ggx", 1e-3)}, Target::double_one, 1);
  polished.lights = {{0, 0, 0, {{1e-6, 1e-6, 1e-6}, false}}};
  polished.view.edges = {0, 0.003};
  polished.tolerance = {Metric::relative, 0.005};
  const MaterialAdvice advice = advise_first(polished);
  REQUIRE(advice.answer);
  CHECK(!says(advice, single));
  polished.tolerance.value = 0.5;
  CHECK(says(advise_first(polished), single));
}

TEST_CASE("single precision of what has no form in it is no rung, and as a target is refused") {
  TermDescription kelemen = mirror("ggx", 0.3, "schlick");
  kelemen.type = "kelemen";
  const AdviceScene scene = scene_of({kelemen}, Target::double_one, 1);
  for (const Rung& rung : ladder_of(scene.materials[0], scene.lights, scene.target).rungs)
    CHECK(rung.drafts[0].precision == Precision::full);
  CHECK_THROWS_WITH_AS(ladder_of(scene.materials[0], scene.lights, Target::float_lanes),
                       "here: the term \"mirror\" has no form in single precision; accepted: the target shader, double "
                       "or double_simd",
                       InputError);
}

TEST_CASE("processors: a smaller tolerance is never cheaper, in random scenes") {
  std::mt19937 random(11);
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  const std::size_t count = test::random_inputs("BRDFPLOT_ADVISE_SCENES", 12, 2);
  for (std::size_t k = 0; k < count; ++k) {
    const Target target = std::array{Target::double_one, Target::double_lanes, Target::float_lanes}[k % 3];
    AdviceScene scene = scene_of({mirror("ggx", std::exp(uniform(-4, 0)), "dielectric")}, target, 1);
    scene.view.edges = {uniform(0, 0.5), uniform(1, 1.5)};
    double before = 0;
    for (double tolerance = uniform(5, 40); tolerance > 1e-7; tolerance *= uniform(1e-4, 0.1)) {
      scene.tolerance.value = tolerance;
      const MaterialAdvice advice = advise_first(scene);
      const double cost = advice.answer ? advice.models[*advice.answer].cost : infinity;
      CHECK(cost >= before);
      before = cost;
    }
  }
}

TEST_CASE("a constant F beside further bounces is one that they know of") {
  TermDescription further;
  further.name = "further";
  further.type = "multiple_bounce";
  further.of_name = "mirror";
  const AdviceScene scene = scene_of({mirror("ggx", 0.5, "conductor"), further}, Target::shader, 4);
  std::size_t constants = 0;
  for (const Rung& rung : ladder_of(scene.materials[0], scene.lights, scene.target).rungs) {
    const std::vector<TermDescription>& terms = rung.drafts[0].material.terms;
    const bool constant = rung.levels.back() == 3;
    if (!constant || terms.size() < 2) continue;
    ++constants;
    CHECK(terms[0].fresnel.type == "schlick");
    CHECK(terms[0].fresnel.values.rgb("f0") == terms[0].fresnel.values.rgb("f90"));
    CHECK(terms[0].fresnel.values.rgb("f0")[0] > 0.8);
  }
  CHECK(constants > 0);
}

TEST_CASE("an answer is looked at once more") {
  TermDescription further;
  further.name = "further";
  further.type = "multiple_bounce";
  further.of_name = "mirror";
  AdviceScene scene = scene_of({mirror("ggx", 0.1, "conductor"), further}, Target::shader, 4);
  scene.lights[0].radius = 0.2;
  const MaterialAdvice advice = advise_first(scene);
  REQUIRE(advice.answer);
  const Examination found = examine(scene, advice, 1);
  const Model& answer = advice.models[*advice.answer];
  // More directions change less than the rule of rings accepts, a tenth of what is noticed.
  REQUIRE(found.finer);
  CHECK(found.finer->directions >= 5 * 4 * advice.rings * advice.rings);
  CHECK(std::fabs(found.finer->answer - answer.errors.decisive()) < 0.1);
  REQUIRE(found.single);
  CHECK(std::fabs(found.single->decisive() - answer.errors.decisive()) < 0.1);
  // A smooth surface has hardly any further bounces: the walk and the material are the same but for its noise.
  REQUIRE(found.walk);
  CHECK(std::fabs(found.walk->light.value) < 4 * found.walk->light.standard_error + 0.002);
  REQUIRE(found.breaks.size() == 1);
  CHECK(found.breaks[0].theta_o <= pi / 2);
}

TEST_CASE("from the worst place to a worse one, with other roughness where no table is made of it") {
  const AdviceScene scene = scene_of({mirror("ggx", 0.3, "conductor")}, Target::shader, 4);
  const MaterialAdvice advice = advise_first(scene);
  REQUIRE(advice.answer);
  const Examination found = examine(scene, advice, 1);
  REQUIRE(found.breaks.size() == 3);
  CHECK(!found.finer);
  CHECK(!found.walk);
  CHECK(found.breaks[0].alpha_factor == 1);
  CHECK(found.breaks[0].difference > advice.models[*advice.answer].errors.decisive());
  CHECK(found.breaks[1].alpha_factor == 0.5);
}
