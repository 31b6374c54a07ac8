#include "analysis/fit/fit.hpp"

#include "../sample.hpp"
#include "analysis/fit/code.hpp"
#include "analysis/fit/minimax/maximin.hpp"
#include "analysis/fit/rounding.hpp"
#include "base/errors.hpp"
#include "brdf/evaluate.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace brdfplot;
using test::inputs;
using test::sampled;

namespace {

TermDescription material(const std::string& type, const std::vector<std::pair<std::string, double>>& values) {
  TermDescription description;
  description.name = type;
  description.distribution.type = type;
  for (const auto& [key, value] : values) description.distribution.values.set(key, value);
  return description;
}

double g1(const Material& m, double theta) {
  return evaluate(m, Quantity::g1, Direction{std::sin(theta), 0, std::cos(theta)}, std::nullopt, std::nullopt);
}

/// The largest relative error of G1 over a grid of theta that is none of the fit's, and whether G1 stays in [0, 1] and
/// never falls from grazing to the normal.
struct Seen {
  double error = 0;
  bool in_range = true;
  bool increasing = true;
  double fall = 0; ///< by how much of itself it falls at most
};

Seen look(const FitResult& result, const TermDescription& description, double alpha, double y) {
  const Material m = build(description);
  Seen seen;
  double last = 0;
  for (int k = 1; k < 9000; k += inputs(1, 17)) {
    const double theta = std::numbers::pi / 2 * (1 - k / 9000.0);
    const double a = std::cos(theta) / std::sin(theta) / alpha;
    const double fit = 1 / (1 + result.fit.lambda(a, y));
    seen.error = std::max(seen.error, std::fabs(fit / g1(m, theta) - 1));
    seen.in_range = seen.in_range && fit > 0 && fit <= 1;
    seen.increasing = seen.increasing && fit >= last * (1 - 1e-15);
    last = fit;
  }
  return seen;
}

/// The same of the code in one precision, at cosines that it is given as they are.
template <class Real>
Seen look_at_code(const FitResult& fit, const Material& m, double parameter) {
  Seen seen;
  double highest = 0;
  const auto alpha = static_cast<Real>(0.3f);
  const Real y = fit.target.parameter ? code_y(*fit.target.parameter, static_cast<Real>(parameter)) : Real(0);
  for (int k = 1; k < 60000; k += inputs(1, 97)) {
    const float cosine = static_cast<float>(std::pow(std::sin(std::numbers::pi / 2 * k / 60000), 3));
    const auto c = static_cast<Real>(cosine);
    const FitTerms<Real> terms =
        code_terms(fit.code, c, code_scaled(fit.code, code_roughness(fit.target, c, alpha, y)), y);
    const auto g1_of_code = static_cast<double>(terms.d / (terms.d + terms.n));
    const double z = cosine, sine = std::sqrt((1 - z) * (1 + z));
    // The material's alpha is 0.3, and float's is not.
    const double a_of_float = fit.target.alpha == FitAlpha::argument ? 0.3 / static_cast<double>(0.3f) : 1;
    const double truth = evaluate(m, Quantity::g1, Direction{sine, 0, z * a_of_float}, std::nullopt, std::nullopt);
    seen.error = std::max(seen.error, std::fabs(g1_of_code / truth - 1));
    seen.in_range = seen.in_range && g1_of_code > 0 && g1_of_code <= 1;
    seen.fall = std::max(seen.fall, 1 - g1_of_code / std::max(highest, g1_of_code));
    highest = std::max(highest, g1_of_code);
  }
  return seen;
}

void check(const Seen& seen, double tolerance) {
  CHECK(seen.error <= tolerance);
  CHECK(seen.in_range);
  CHECK(seen.increasing);
}

/// Maxima of |error| above 90 % of the largest, with alternating signs.
int alternations(const FitResult& result) {
  const FitSamples samples = sample(result.target, 4001, 1, 1);
  int count = 0;
  double last = 0;
  for (const FitSample& s : samples.samples) {
    const double error = result.fit.relative_error(s.a, s.y, s.lambda);
    if (std::fabs(error) < 0.9 * result.in_double.relative.error || error * last > 0) continue;
    ++count;
    last = error;
  }
  return count;
}

} // namespace

TEST_CASE("fit: the linear program") {
  // The rows (3, 1), (-1, 1), (0, 2): the smallest entry is largest at v = (0, 1), and is 1.
  const Maximin solved = maximin({2, {3, 1, -1, 1, 0, 2}});
  CHECK(solved.value <= 1);
  CHECK(solved.value > 0.89);
  CHECK(solved.bound >= 1);
  CHECK(solved.bound < 1.12);
  CHECK(std::fabs(solved.v[0]) <= 1);
  // v > 0 and -v > 0 exclude each other.
  CHECK(maximin({1, {1, -1}}).bound < 1e-10);
}

TEST_CASE("fit: positivity is proved, and only where it holds") {
  const auto square = [](double floor) { return Polynomial{2, 0, {0.25 + floor, -1, 1}}; }; // (x - 1/2)^2 + floor
  CHECK(proved_positive(square(1e-4)));
  CHECK(!proved_positive(square(0)));
  CHECK(!proved_positive(square(-1e-4)));
  // (x - y)^2 + floor
  const auto valley = [](double floor) { return Polynomial{2, 2, {floor, 0, 1, 0, -2, 0, 1, 0, 0}}; };
  CHECK(proved_positive(valley(1e-2)));
  CHECK(!proved_positive(valley(-1e-2)));
  CHECK(!proved_positive(Polynomial{1, 0, {0, 1}})); // 0 at an end
}

TEST_CASE("fit: Bernstein polynomials, products and derivatives") {
  double b[4];
  bernstein(3, 0.3, b);
  const Polynomial p = from_bernstein(3, 0, {1, -2, 0.5, 4});
  CHECK(p(0.3, 0) == doctest::Approx(b[0] - 2 * b[1] + 0.5 * b[2] + 4 * b[3]));
  CHECK(derivative_x(p)(0.3, 0) == doctest::Approx((p(0.3 + 1e-6, 0) - p(0.3 - 1e-6, 0)) / 2e-6));
  const Polynomial q = from_bernstein(1, 2, {1, 2, 3, 4, 5, 7});
  CHECK((p * q)(0.3, 0.6) == doctest::Approx(p(0.3, 0.6) * q(0.3, 0.6)));
  CHECK(add(p, q, -2)(0.3, 0.6) == doctest::Approx(p(0.3, 0.6) - 2 * q(0.3, 0.6)));
}

TEST_CASE("fit: a polynomial in 1 - x") {
  const Polynomial p{3, 1, {1, -2, 0.5, 4, 0.25, 3, -1, 2}};
  CHECK(mirrored_x(p)(0.3, 0.6) == doctest::Approx(p(0.7, 0.6)));
  CHECK(mirrored_x(mirrored_x(p)).c == p.c);
}

TEST_CASE("fit: rounding stays within its bound") {
  // Sums, products, a quotient and a root that cancel to various degrees, in float and as float is said to round.
  const auto expression = [](const auto& a, const auto& b) {
    using std::sqrt;
    return sqrt(a * a + b) - (a - b) * (a + b) / (b + a * a * a);
  };
  double worst = 0;
  for (int k = 1; k < 4000; ++k) {
    const float a = 1.37f * static_cast<float>(k) / 1999, b = 1 / (1 + 3 * a) + 0.001f * static_cast<float>(k % 17);
    const auto bound = expression(Rounded<SingleArithmetic>::exact(a), Rounded<SingleArithmetic>::exact(b));
    const double error = std::fabs(static_cast<double>(expression(a, b)) - bound.value);
    CHECK(error <= bound.error);
    worst = std::max(worst, error / bound.error);
  }
  CHECK(worst > 0.05); // and is none that says nothing
}

TEST_CASE("fit: what the code computes in float and double is within what is said of it") {
  for (const auto& [description, tolerance] : test::sample_of<std::pair<TermDescription, double>>(
           {{material("phong", {{"exponent", 10}}), 1e-3},
            {material("beckmann", {{"alpha", 0.3}}), 1e-6},
            {material("ggx", {{"alpha", 0.3}}), 1e-5},
            {material("student_t", {{"alpha", 0.3}, {"gamma", 3}}), 1e-4}},
           2)) {
    const std::string& name = description.name; // clang 14 captures no structured binding
    INFO(name);
    const FitResult fit = fit_lambda(description, {.tolerance = tolerance, .threads = 2});
    CHECK(fit.in_double.relative.error <= tolerance);
    if (tolerance >= 1e-5) CHECK(fit.in_float.relative.error <= tolerance);
    const auto& parameter = fit.target.parameter;
    for (const double value :
         parameter ? std::vector<double>{parameter->from, 1.75, 2.125, 5, 300} : std::vector{0.0}) {
      if (parameter && !parameter->contains(value)) continue;
      TermDescription changed = description;
      if (parameter) set_parameter(changed, parameter->key, value);
      const Material m = build(changed);
      const Seen in_float = look_at_code<float>(fit, m, value), in_double = look_at_code<double>(fit, m, value);
      CHECK(in_float.error <= fit.in_float.relative.error);
      CHECK(in_float.fall <= 2 * fit.in_float.rounding);
      CHECK(in_float.in_range);
      CHECK(in_double.error <= fit.in_double.relative.error);
      CHECK(in_double.fall <= 2 * fit.in_double.rounding);
      CHECK(in_double.in_range);
    }
  }
}

TEST_CASE("fit: at Walter's degree it beats Walter") {
  const FitTarget target = fit_target(material("beckmann", {{"alpha", 0.3}}), false);
  const FitSamples samples = sample(target, 3001, 1, 1);
  double walter = 0;
  for (const FitSample& s : samples.samples) {
    const double lambda = s.a < 1.6 ? (1 - 1.259 * s.a + 0.396 * s.a * s.a) / (s.a * (3.535 + 2.181 * s.a)) : 0;
    walter = std::max(walter, std::fabs((1 + s.lambda) / (1 + lambda) - 1));
  }
  CHECK(walter == doctest::Approx(0.00313).epsilon(0.003));
  // A quadratic over a (c3 + c4 a) up to a cut: (1 - x) n over x m, n and m linear.
  const auto fit = fit_form({.cut = true, .power = 1, .nx = 1, .mx = 1}, 0.01, samples);
  REQUIRE(fit);
  CHECK(fit->proved_sound());
  CHECK(largest_error(*fit, samples).error < 0.00305);
  // (1 - x)^4 over one coefficient is half as far off, at a third of his coefficients.
  const auto cheapest = fit_form({.cut = true, .power = 4}, 0.01, samples);
  REQUIRE(cheapest);
  CHECK(largest_error(*cheapest, samples).error < 0.0017);
}

TEST_CASE("fit: shape-invariant distributions, one variable") {
  struct Row {
    TermDescription description;
    double alpha;
    double tolerance;
  };
  for (const Row& row : {Row{material("beckmann", {{"alpha", 0.3}}), 0.3, 1e-4},
                         {material("beckmann", {{"alpha", 0.3}}), 0.3, 1e-2},
                         {material("beckmann", {{"alpha", 2}}), 2, 1e-6},
                         {material("ggx", {{"alpha", 0.3}}), 0.3, 1e-4},
                         {material("ggx", {{"alpha", 0.05}}), 0.05, 1e-5},
                         {material("exponential_power", {{"alpha", 0.4}, {"p", 0.5}}), 0.4, 1e-4}}) {
    INFO(row.description.name << " " << row.tolerance);
    const FitResult result = fit_lambda(row.description, {.tolerance = row.tolerance, .threads = 2});
    CHECK(result.target.alpha == FitAlpha::argument);
    CHECK(result.in_double.relative.error <= row.tolerance);
    check(look(result, row.description, row.alpha, 0), row.tolerance);
    CHECK(result.in_double.absolute <= result.in_double.relative.error);
  }
}

TEST_CASE("fit: the error alternates as often as there are coefficients") {
  const FitResult result = fit_lambda(material("beckmann", {{"alpha", 0.3}}), {});
  CHECK(alternations(result) >= static_cast<int>(result.fit.form.coefficients()));
}

TEST_CASE("fit: parameters held fixed") {
  const std::vector<TermDescription> all = {material("phong", {{"exponent", 10}}),
                                            material("gtr", {{"alpha", 0.3}, {"gamma", 1.5}}),
                                            material("velvet", {{"alpha", 0.5}}), material("sheen", {{"alpha", 0.5}})};
  for (const TermDescription& description : all) {
    INFO(description.name);
    const FitResult result = fit_lambda(description, {.fixed = true, .threads = 2});
    CHECK(result.target.alpha == FitAlpha::constant);
    check(look(result, description, result.target.alpha_value, 0), 1e-4);
  }
}

TEST_CASE("fit: two variables") {
  const FitOptions options{.tolerance = 1e-3, .threads = 2};
  const FitResult phong = fit_lambda(material("phong", {{"exponent", 10}}), options);
  REQUIRE(phong.target.parameter);
  for (const double exponent : {0.0, 1.0, 33.0, 1e4})
    check(look(phong, material("phong", {{"exponent", exponent}}), std::sqrt(2 / (exponent + 2)),
               phong.target.parameter->y(exponent)),
          1e-3);
  if (sampled()) return;
  const FitResult gtr = fit_lambda(material("gtr", {{"alpha", 0.3}, {"gamma", 1.5}}), options);
  REQUIRE(gtr.target.parameter);
  for (const double alpha : {0.05, 0.123, 0.7, 1.0})
    check(look(gtr, material("gtr", {{"alpha", alpha}, {"gamma", 1.5}}), alpha, gtr.target.parameter->y(alpha)), 1e-3);
  const FitResult student = fit_lambda(material("student_t", {{"alpha", 0.3}, {"gamma", 3}}), options);
  REQUIRE(student.target.parameter);
  for (const double gamma : {1.75, 2.0, 4.4, 40.0})
    check(look(student, material("student_t", {{"alpha", 0.3}, {"gamma", gamma}}), 0.3,
               student.target.parameter->y(gamma)),
          1e-3);
}

TEST_CASE("fit: the same on any number of threads") {
  const TermDescription description = material("ggx", {{"alpha", 0.3}});
  const std::string one = fit_code(fit_lambda(description, {.threads = 1}), 1e-4, FitLanguage::glsl);
  CHECK(one == fit_code(fit_lambda(description, {.threads = 3}), 1e-4, FitLanguage::glsl));
}

TEST_CASE("fit: what cannot be fitted") {
  TermDescription cavity = material("ggx", {{"alpha", 0.3}});
  cavity.masking.type = "v_cavity";
  CHECK_THROWS_AS(fit_lambda(cavity, {}), InputError);
  try {
    fit_lambda(material("beckmann", {{"alpha", 0.3}}), {.tolerance = 1e-14});
    FAIL("a tolerance below rounding was reached");
  } catch (const AccuracyError& error) {
    const std::string what = error.what();
    CHECK(what.find("relative error of G1 of ") != std::string::npos);
    CHECK(what.find("(asked: 1e-14)") != std::string::npos);
  }
}

TEST_CASE("fit: names") {
  CHECK(fit_identifier("rough gold") == "rough_gold");
  CHECK(fit_identifier("GGX, α = 0.5") == "ggx_0_5");
  CHECK(fit_identifier("3M (velvet)") == "material_3m_velvet");
  CHECK(fit_identifier("—") == "material_");
}
