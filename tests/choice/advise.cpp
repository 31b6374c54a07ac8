#include "choice/advise/advise.hpp"
#include "base/errors.hpp"
#include "choice/advise/options/options.hpp"
#include "choice/advise/text.hpp"
#include "config/load.hpp"
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

TermDescription mirror(double alpha, ModelChoice fresnel) {
  TermDescription term;
  term.distribution = {.type = "ggx"};
  term.distribution.values.set("alpha", alpha);
  term.fresnel = std::move(fresnel);
  return term;
}

ModelChoice conductor(const Rgb& eta, const Rgb& k) {
  ModelChoice choice{.type = "conductor"};
  choice.values.set("eta", eta);
  choice.values.set("k", k);
  return choice;
}

AdviceScene scene_of(const TermDescription& term, double delta_e) {
  AdviceScene scene;
  scene.name = "a scene";
  scene.materials = {{MaterialDescription(term), {}, {}}};
  scene.materials[0].material.name = "a material";
  scene.lights = {{0.8, 1, 0, {{2, 2, 2}, false}}, {2.3, -1, 0, {{1, 1, 1}, false}}};
  scene.view = {{0, pi / 2}, {}};
  scene.tolerance = {Metric::delta_e, delta_e};
  return scene;
}

MaterialAdvice advise_first(const AdviceScene& scene, int threads = 1) {
  return advise(scene, scene.materials[0], {threads, {}});
}

/// The middles of square pixels of the sphere's picture, by angles of the normal.
Places pixels(const ViewRange& view, int side) {
  Places out;
  double sum = 0;
  std::vector<std::size_t> bins;
  std::vector<double> counts(view.edges.size());
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double x = (column + 0.5) * 2 / side - 1, y = (row + 0.5) * 2 / side - 1;
      if (!(x * x + y * y < 1)) continue;
      const double theta = std::asin(std::sqrt(x * x + y * y));
      const auto bin = static_cast<std::size_t>(std::ranges::upper_bound(view.edges, theta) - view.edges.begin());
      if (bin == 0 || bin == view.edges.size()) continue;
      out.at.push_back({x, y});
      bins.push_back(bin - 1);
      ++counts[bin - 1];
    }
  for (const std::size_t bin : bins) {
    out.share.push_back(view.shares.empty() ? 1 : view.shares[bin] / counts[bin]);
    sum += out.share.back();
  }
  for (double& share : out.share) share /= sum;
  return out;
}

/// A punctual light for each of many points of a disc, on a golden spiral: another rule than that of the program.
std::vector<AdviceLight> spiral(const std::vector<AdviceLight>& lights, int points) {
  std::vector<AdviceLight> out;
  for (const AdviceLight& light : lights) {
    if (light.radius == 0) {
      out.push_back(light);
      continue;
    }
    const Direction middle = from_angles(light.theta, light.phi), down = from_angles(light.theta + pi / 2, light.phi);
    const Direction side{-std::sin(light.phi), std::cos(light.phi), 0};
    const double height = 1 - std::cos(light.radius);
    for (int k = 0; k < points; ++k) {
      const double drop = height * (k + 0.5) / points, sine = std::sqrt(drop * (2 - drop)),
                   azimuth = 2.399963229728653 * k;
      const Direction d = (1 - drop) * middle + (sine * std::cos(azimuth)) * down + (sine * std::sin(azimuth)) * side;
      AdviceLight one{std::acos(std::clamp(d.z, -1.0, 1.0)), std::atan2(d.y, d.x), 0, light.irradiance};
      // Irradiance of a part of the disc: radiance E / (pi sin^2 r) times its solid angle.
      for (double& e : one.irradiance.value) e *= 2 * pi * height / points / (pi * std::pow(std::sin(light.radius), 2));
      out.push_back(one);
    }
  }
  return out;
}

/// The decisive error of a model by pixels and the spiral: statistics by sorting, written anew.
double independent_error(const AdviceScene& scene, const MaterialAdvice& advice, const Model& model, int side) {
  const Places places = pixels(scene.view, side);
  double most = 0;
  for (std::size_t v = 0; v < model.materials.size(); ++v) {
    Renderer many(spiral(scene.lights, 700), places, 1), own(scene.lights, places, 1);
    const Picture reference = many.picture(advice.ladder.variants[v], {LightModel::Kind::punctual, 0}, false);
    const Picture picture = own.picture(model.materials[v], advice.ladder.lights[model.light], false);
    std::vector<std::pair<double, double>> errors;
    double lit = 0;
    const std::size_t n = places.at.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Rgb a = colour_at(reference, n, k), b = colour_at(picture, n, k);
      if (a[0] + a[1] + a[2] <= 0) continue;
      errors.emplace_back(difference(scene.tolerance.metric, a, b, scene.exposure), places.share[k]);
      lit += places.share[k];
    }
    std::ranges::sort(errors, std::greater<>());
    double area = 0, p95 = 0, worst = 0, worst_area = 0;
    for (const auto& [error, share] : errors) {
      area += share;
      if (area <= 0.05 * lit) p95 = error;
      if (area <= 0.01 * lit) {
        worst += share * error;
        worst_area += share;
      }
    }
    most = std::max({most, p95, 0.5 * worst / worst_area});
  }
  return most;
}

} // namespace

TEST_CASE("the ladder has every combination, and each model once") {
  const AdviceScene scene = scene_of(mirror(0.3, conductor({0.1, 0.4, 1.4}, {4, 2.4, 1.6})), 1);
  const Ladder ladder = ladder_of(scene.materials[0], scene.lights, scene.target);
  // V: given, separable, Hammon, constant; F: conductor, F82, Schlick, constant.
  CHECK(ladder.options.size() == 2);
  CHECK(ladder.rungs.size() == 16);
  CHECK(ladder.lights.size() == 1);
  CHECK(ladder.rungs[0].levels == std::vector<std::size_t>{0, 0});
}

TEST_CASE("one lobe in the place of a mixture lies where the mixture does, and is as wide") {
  const auto part = [](double alpha, const Vec2& mean) {
    ModelChoice one{.type = "beckmann"};
    one.values.set("alpha", alpha);
    one.values.set("mean_slope", mean);
    return one;
  };
  TermDescription term;
  term.name = "normals";
  term.distribution = {.type = "mixture"};
  term.distribution.values.set("components", WeightedChoices{{1, part(0.2, {0.5, 0.1})}, {3, part(0.2, {0.1, 0.1})}});
  Draft draft{canonical(MaterialDescription(term)), {}, {}};
  const std::vector<Option> options = SingleLobe::of(draft.material);
  REQUIRE(options.size() == 1);
  REQUIRE(options[0].steps[0].apply(draft));
  const Values& ggx = draft.material.terms[0].distribution.values;
  // The mean of 0.5 and thrice 0.1 is 0.2, and they vary by (0.3^2 + 3 0.1^2) / 4 about it.
  CHECK(ggx.vec2("mean_slope")[0] == doctest::Approx(0.2));
  CHECK(ggx.vec2("mean_slope")[1] == doctest::Approx(0.1));
  CHECK(ggx.number("alpha_x") == doctest::Approx(std::sqrt(0.04 + 2 * 0.03)));
  CHECK(ggx.number("alpha_y") == doctest::Approx(0.2));
}

TEST_CASE("a mean slope that is left out is left out of the parts of a mixture too") {
  TermDescription term;
  ModelChoice sheared{.type = "ggx"}, level = sheared;
  sheared.values.set("alpha", 0.3);
  level.values.set("alpha", 0.3);
  sheared.values.set("mean_slope", Vec2{0.2, 0});
  term.distribution = {.type = "mixture"};
  term.distribution.values.set("components", WeightedChoices{{1, sheared}, {1, level}});
  Draft draft{canonical(MaterialDescription(term)), {}, {}};
  const std::vector<Option> options = Level::of(draft.material);
  REQUIRE(options.size() == 1);
  CHECK(options[0].steps[0].apply(draft));
  CHECK(build(draft.material).mesosurface().centred());
  CHECK(Level::of(draft.material).empty());
}

TEST_CASE("the answer is the cheapest of all that are within the tolerance") {
  AdviceScene scene = scene_of(mirror(0.3, conductor({0.1, 0.4, 1.4}, {4, 2.4, 1.6})), 1e-9);
  // With no tolerance to speak of the material in full is the answer, so that every model is evaluated.
  const MaterialAdvice all = advise_first(scene);
  REQUIRE(all.answer == all.full);
  CHECK(all.models.size() == all.ladder_size);
  CHECK(all.models.size() == 16);
  for (const double tolerance : {0.3, 1.0, 3.0, 8.0, 30.0, 200.0}) {
    scene.tolerance.value = tolerance;
    const MaterialAdvice advice = advise_first(scene);
    REQUIRE(advice.answer);
    const Model& answer = advice.models[*advice.answer];
    CHECK(answer.dense->decisive() <= tolerance);
    for (const Model& model : all.models)
      if (model.cost < answer.cost) CHECK(model.errors.decisive() > 0.9 * tolerance);
    if (advice.next_cheaper) CHECK(decisive(advice.models[*advice.next_cheaper]) > tolerance);
  }
}

TEST_CASE("a scene without a rim light does not tell Fresnel terms apart; one with does") {
  AdviceScene scene = scene_of(mirror(0.3, conductor({0.143, 0.374, 1.442}, {3.983, 2.385, 1.603})), 4);
  scene.lights = {{0.79, 1, 0, {{2, 2, 2}, false}}, {1.05, -1, 0, {{1, 1, 1}, false}}};
  const auto says_constant = [&] {
    const MaterialAdvice advice = advise_first(scene);
    const auto labels = simplifications(advice, advice.models[*advice.answer]);
    return std::ranges::find(labels, "F of mirror: constant (was conductor)") != labels.end();
  };
  CHECK(says_constant());
  scene.lights.push_back({140 * pi / 180, 0.3, 0, {{1.5, 1.5, 1.5}, false}});
  CHECK(!says_constant());
}

TEST_CASE("a smaller tolerance is never cheaper, in random scenes") {
  std::mt19937 random(7);
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  const std::size_t count = test::random_inputs("BRDFPLOT_ADVISE_SCENES", 200, 4);
  for (std::size_t k = 0; k < count; ++k) {
    const bool metal = k % 2 == 0;
    ModelChoice fresnel{.type = "dielectric"};
    fresnel.values.set("eta", uniform(1.2, 2.5));
    if (metal) fresnel = conductor({uniform(0.1, 3), uniform(0.1, 3), uniform(0.1, 3)}, {uniform(1, 5), 3, 2});
    AdviceScene scene = scene_of(mirror(std::exp(uniform(-2, 0)), fresnel), 1);
    scene.lights = {{uniform(0, pi), uniform(0, 6), 0, {{2, 2, 2}, false}},
                    {uniform(0, 2.5), uniform(0, 6), 0, {{uniform(0, 1), 1, 1}, true}}};
    scene.view.edges = {uniform(0, 0.5), uniform(1, 1.5)};
    double before = 0;
    double tolerance = uniform(5, 40);
    for (int step = 0; step < 3; ++step) {
      scene.tolerance.value = tolerance;
      const MaterialAdvice advice = advise_first(scene);
      REQUIRE(advice.answer); // the material in full is exact under punctual lights
      CHECK(advice.models[*advice.answer].cost >= before);
      before = advice.models[*advice.answer].cost;
      tolerance *= uniform(0.1, 0.6);
    }
  }
}

TEST_CASE("a model has to stand for every value of a range, and the worst counts") {
  AdviceScene scene = scene_of(mirror(0.3, conductor({0.1, 0.4, 1.4}, {4, 2.4, 1.6})), 6);
  const MaterialAdvice one = advise_first(scene);
  scene.materials[0].ranges = {{"alpha", {0.6, 0.9}}};
  const MaterialAdvice three = advise_first(scene);
  REQUIRE(one.answer);
  REQUIRE(three.answer);
  CHECK(three.models[*three.answer].materials.size() == 3);
  CHECK(three.models[*three.answer].cost >= one.models[*one.answer].cost);
}

TEST_CASE("what is lit from behind alone is refused") {
  AdviceScene scene = scene_of(mirror(0.3, conductor({0.1, 0.4, 1.4}, {4, 2.4, 1.6})), 6);
  scene.lights = {{pi, 0, 0, {{1, 1, 1}, false}}};
  CHECK_THROWS_WITH_AS(advise_first(scene), doctest::Contains("no light reaches"), InputError);
}

TEST_CASE("any number of threads gives the same answer") {
  const AdviceScene scene = scene_of(mirror(0.2, conductor({0.1, 0.4, 1.4}, {4, 2.4, 1.6})), 2);
  const std::string one = advice_text(scene, advise_first(scene, 1));
  CHECK(one == advice_text(scene, advise_first(scene, 3)));
}

TEST_CASE("the shipped scenes: the answer is within the tolerance and the next cheaper is not, seen otherwise") {
  std::vector<std::string> names = {"mobile_gold", "brushed_steel", "cloth_sofa"};
  if (!test::sampled()) names.insert(names.end(), {"matte_wall", "car_paint"});
  for (const std::string& name : names) {
    CAPTURE(name);
    const AdviceScene scene =
        config::load_advice(std::string(BRDFPLOT_SOURCE_DIR) + "/configs/scenes/" + name + ".json");
    for (const AdvisedMaterial& material : scene.materials) {
      const MaterialAdvice advice = advise(scene, material, {2, {}});
      REQUIRE(advice.answer);
      REQUIRE(advice.next_cheaper);
      CHECK(advice.within_budget(scene));
      const int side = test::inputs(110, 40);
      CHECK(independent_error(scene, advice, advice.models[*advice.answer], side) <= scene.tolerance.value);
      CHECK(independent_error(scene, advice, advice.models[*advice.next_cheaper], side) > scene.tolerance.value);
    }
  }
}
