#include "choice/pareto/pareto.hpp"

#include "base/random.hpp"
#include "choice/methods/problems.hpp"
#include "choice/pareto/tables.hpp"

#include "sample.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace brdfplot;
using namespace brdfplot::choice;

namespace {

const Method& method_named(const Problem& problem, const std::string& name) {
  const auto found = std::ranges::find(problem.methods, name, &Method::name);
  INFO(problem.name << " has no " << name);
  REQUIRE(found != problem.methods.end());
  return *found;
}

Errors errors_of(const Problem& problem, const Method& method) {
  return choice::errors_of(problem, method, sample(problem, method.is_single(), 1));
}

Errors errors_of(const Problem& problem, const std::string& name) {
  return errors_of(problem, method_named(problem, name));
}

/// The same in G1 = 1 / (1 + Lambda).
Problem as_g1(const Problem& lambda) {
  Problem p = lambda;
  p.seen = {};
  p.exact = [exact = lambda.exact](std::span<const double> x) { return Exact{1 / (1 + exact(x).high), 0}; };
  for (auto& method : p.methods)
    if (const auto* run = std::get_if<Run<double>>(&method.run))
      method.run = Run<double>([run = *run](std::size_t n, const double* const* in, double* out) {
        run(n, in, out);
        for (std::size_t i = 0; i < n; ++i) out[i] = 1 / (1 + out[i]);
      });
  return p;
}

Problem with_input(Problem p, std::size_t k, double low, double high) {
  p.inputs[k].low = low;
  p.inputs[k].high = high;
  return p;
}

Problem few_samples(Problem p) {
  p.samples = 1024;
  return p;
}

double degrees(double cosine) { return std::acos(cosine) * 180 / std::numbers::pi; }

/// Within half of the last digit that is given.
bool agrees(double value, double expected, double last_digit) {
  return std::fabs(std::fabs(value) - expected) <= 0.5 * last_digit * (1 + 1e-9);
}

} // namespace

TEST_CASE("pareto: errors of published approximations of masking") {
  SUBCASE("Walter's rational: 0.313 % of G1 at a = 1.336") {
    const Problem p = as_g1(lambda_beckmann());
    const Errors errors = errors_of(p, "walter_2007");
    CHECK(agrees(errors.relative.error, 0.00313, 1e-5));
    CHECK(agrees(errors.relative.input.at(0), 1.336, 1e-3));
    // With the misprint of another program, 2.267 for 2.276, it is 0.45 %: the same search sees it.
    const Method wrong =
        method_of<double, 1>("misprint", "", "", Kind::approximation,
                             [](const auto& x) {
                               using T = std::remove_cvref_t<decltype(x[0])>;
                               const T a = x[0];
                               if (!(a < T(1.6))) return T(1);
                               return (T(3.535) * a + T(2.181) * a * a) / (T(1) + T(2.267) * a + T(2.577) * a * a);
                             },
                             {{1.0}});
    CHECK(agrees(errors_of(p, wrong).relative.error, 0.0045, 1e-4));
  }
  SUBCASE("Karis's G1: 0.1632 at cos = 1.149 alpha, for small alpha") {
    const Errors errors = errors_of(lambda_ggx(), "karis_2013");
    CHECK(agrees(errors.absolute().error, 0.1632, 1e-4));
    CHECK(agrees(errors.absolute().input.at(0), 1.149, 1e-3));
  }
  SUBCASE("Hammon's G2: 0.2326 at cos = 1.611 alpha, for small alpha") {
    const Errors errors = errors_of(g2(), "hammon_2017");
    CHECK(agrees(errors.absolute().error, 0.2326, 1e-4));
    const auto& at = errors.absolute().input;
    CHECK(at.at(1) / at.at(0) == doctest::Approx(1.611).epsilon(2e-3));
    CHECK(at.at(2) / at.at(0) == doctest::Approx(1.611).epsilon(2e-3));
  }
  SUBCASE("the fit of Student's t, of G1") {
    const Problem p = as_g1(lambda_student_t());
    struct Case {
      double gamma, percent;
    };
    const std::vector<Case> cases = {{2, 0.70}, {2.5, 0.66}, {4, 0.26}, {5, 0.13}, {40, 0.51}};
    for (const Case& c : test::sample_of(cases, 3)) {
      CAPTURE(c.gamma);
      Problem of_gamma = with_input(p, 1, c.gamma, c.gamma);
      of_gamma.inputs[1].scale = Scale::linear;
      CHECK(agrees(100 * errors_of(of_gamma, "ribardiere_2017").relative.error, c.percent, 0.01));
    }
  }
  SUBCASE("the fit of sheen, of G1") {
    const Problem p = lambda_sheen();
    struct Case {
      double r, error, digit;
    };
    const std::vector<Case> cases = {{0.01, 0.33, 0.01}, {0.02, 0.23, 0.01}, {0.05, 0.091, 1e-3},
                                     {0.1, 0.013, 1e-3}, {0.2, 0.042, 1e-3}, {0.3, 0.043, 1e-3},
                                     {0.5, 0.023, 1e-3}, {0.7, 0.007, 1e-3}, {1, 0.008, 1e-3}};
    for (const Case& c : test::sample_of(cases, 5)) {
      CAPTURE(c.r);
      Problem of_r = with_input(p, 0, c.r, c.r);
      of_r.inputs[0].scale = Scale::linear;
      of_r.samples = 1024;
      CHECK(agrees(errors_of(of_r, "imageworks_2017").absolute().error, c.error, c.digit));
    }
  }
}

TEST_CASE("pareto: errors of Schlick's reflectance") {
  const Errors glass = errors_of(fresnel_dielectric(), "schlick_1994");
  CHECK(agrees(glass.above.error, 0.0357, 1e-4));
  CHECK(agrees(degrees(glass.above.input.at(0)), 85.0, 0.1));
  CHECK(agrees(glass.below.error, 0.0196, 1e-4));
  CHECK(agrees(degrees(glass.below.input.at(0)), 62.3, 0.1));
  const Errors chromium = errors_of(fresnel_conductor(), "schlick_1994");
  CHECK(agrees(chromium.above.error, 0.212, 1e-3));
  CHECK(agrees(degrees(chromium.above.input.at(0)), 83.3, 0.1));
}

TEST_CASE("pareto: rationals of Fresnel's reflectance, and Schlick's with a fitted exponent") {
  const auto relative = [](const Problem& p, const std::string& name) { return errors_of(p, name).relative.error; };
  // Computed by a program of its own at 20001 cosines from the coefficients with nine digits.
  const Problem glass = fresnel_dielectric(), chromium = fresnel_conductor();
  CHECK(agrees(relative(glass, "rational_2"), 3.78e-3, 1e-5));
  CHECK(agrees(relative(glass, "rational_3"), 4.25e-5, 1e-7));
  CHECK(relative(glass, "rational_4") < 1.2e-7);
  CHECK(agrees(relative(chromium, "rational_2"), 6.82e-3, 1e-5));
  CHECK(agrees(relative(chromium, "rational_3"), 2.85e-6, 1e-8));
  CHECK(relative(chromium, "rational_4") < 5e-9);
  CHECK(agrees(errors_of(chromium, "generalized_schlick").absolute().error, 0.0693, 1e-4));
}

TEST_CASE("pareto: Lazarov's albedo") {
  // Gloss 1/2 is Blinn's exponent sqrt(8192), so alpha^2 = 2 / (sqrt(8192) + 2); by hand from the code of the notes.
  const double alpha = std::sqrt(2 / (std::sqrt(8192.0) + 2)), cosine = 1;
  const auto value = [&](const Problem& p) {
    const auto method = std::ranges::find(p.methods, "lazarov_2013", &Method::name);
    const std::array<const double*, 2> in = {&alpha, &cosine};
    double out = 0;
    std::get<Run<double>>(method->run)(1, in.data(), &out);
    return out;
  };
  CHECK(value(albedo_ggx()) == doctest::Approx(0.875));
  CHECK(value(albedo_ggx_b()) == doctest::Approx(0.5 * std::exp2(-9.28) / 0.96 - 0.00625 / 0.96));
}

TEST_CASE("pareto: errors of fits of the albedo") {
  const auto largest = [](const Problem& p, const std::string& name) { return errors_of(p, name).absolute().error; };
  // A and B of MaterialX as in its notes. Those of the other three are 0.065, 0.062 and 0.051 on a grid of alpha =
  // 0.01, 0.02, ...; between its points they are larger.
  CHECK(agrees(largest(albedo_ggx_a(), "materialx"), 0.064, 1e-3));
  if (test::sampled()) return;
  CHECK(agrees(largest(albedo_ggx_b(), "materialx"), 0.024, 1e-3));
  CHECK(agrees(largest(albedo_ggx(), "materialx"), 0.068, 1e-3));
  const double unreal = largest(albedo_ggx(), "unreal"); // 0.0641 on a finer grid, by a program of its own
  CHECK(unreal > 0.0641);
  CHECK(unreal < 0.065);
  CHECK(agrees(largest(albedo_ggx_b(), "unreal"), 0.0556, 1e-4));
}

namespace {

/// Few values, so that many are equal; two points are none.
std::vector<CostError> random_points(Random& random) {
  std::vector<CostError> points;
  for (int k = 0; k < 12; ++k) points.push_back({std::floor(6 * random.uniform()), std::floor(6 * random.uniform())});
  points[3].error = std::numeric_limits<double>::infinity();
  points[4].cost = std::numeric_limits<double>::quiet_NaN();
  return points;
}

bool is_beaten(const std::vector<CostError>& points, std::size_t k) {
  const CostError& p = points[k];
  if (!std::isfinite(p.cost) || !std::isfinite(p.error)) return true;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const CostError& q = points[j];
    const bool better = q.cost < p.cost || q.error < p.error || j < k;
    if (j != k && q.cost <= p.cost && q.error <= p.error && better) return true;
  }
  return false;
}

} // namespace

TEST_CASE("pareto: the front is what a search through all pairs finds") {
  Random random(5, 0);
  for (int trial = 0; trial < 500; ++trial) {
    const auto points = random_points(random);
    const Dominated found = dominated(points);
    const Slack slack{.cost = 1.5, .error = 1.3};
    const Dominated with_slack = dominated(points, slack);
    for (std::size_t k = 0; k < points.size(); ++k) {
      CHECK(found.on_front[k] == !is_beaten(points, k));
      if (with_slack.on_front[k]) CHECK(found.on_front[k]);
      CHECK((with_slack.on_front[k] || with_slack.by[k].has_value()) ==
            (std::isfinite(points[k].cost) && std::isfinite(points[k].error)));
      if (!with_slack.by[k]) continue;
      const std::size_t by = *with_slack.by[k];
      CHECK(with_slack.on_front[by]);
      CHECK(points[by].cost <= slack.cost * points[k].cost);
      CHECK(points[by].error <= slack.error * points[k].error);
    }
  }
}

TEST_CASE("pareto: errors and fronts by cost are the same bytes for any number of threads") {
  const auto csv = [](int threads) {
    return pareto_csv(pareto({lambda_ggx(), fresnel_conductor()}, {.threads = threads, .times = false},
                             [](double, const std::string&) {}));
  };
  const std::string once = csv(1);
  CHECK(once == csv(3));
  CHECK(std::ranges::count(once, '\n') > 40);
}

TEST_CASE("pareto: the exact kernel is on the front of Lambda, and keeps what it states") {
  const auto results = pareto({few_samples(lambda_beckmann()), few_samples(lambda_ggx())},
                              {.threads = 2, .times = false}, [](double, const std::string&) {});
  for (const auto& result : results) {
    CAPTURE(result.problem.name);
    const MethodResult& kernel = result.methods.at(result.reference);
    CHECK(kernel.method.name == "kernel");
    for (const auto& m : result.methods)
      if (m.method.bound > 0) CHECK(m.errors.relative.error <= m.method.bound);
  }
  const auto& beckmann = results.at(0);
  CHECK(beckmann.front(CostKind::counted, ErrorKind::relative).on_front[beckmann.reference]);
  // Only methods that compute in float are cheaper and on the front with it.
  for (std::size_t k = 0; k < beckmann.methods.size(); ++k) {
    if (!beckmann.front(CostKind::counted, ErrorKind::relative).on_front[k] || k == beckmann.reference) continue;
    CHECK(beckmann.methods[k].method.is_single());
  }
}

TEST_CASE("pareto: a visible slope by few steps of Newton's rule is off, by five steps it is not") {
  Problem p = sample_beckmann();
  p.samples = 256;
  CHECK(errors_of(p, "newton_1").absolute().error > 1e-3);
  CHECK(errors_of(p, "newton_5").absolute().error < 1e-12);
  CHECK(errors_of(p, "program").absolute().error < 1e-12);
}

TEST_CASE("pareto: times are positive, in order, and of every method") {
  auto problem = fresnel_dielectric();
  const auto times = times_of(problem, [](double) {});
  REQUIRE(times.size() == problem.methods.size());
  for (const Time& time : times) {
    CHECK(time.least > 0);
    CHECK(time.least <= time.lower_quartile);
    CHECK(time.lower_quartile <= time.median);
    CHECK(time.median <= time.upper_quartile);
  }
}
