// Roughness as renderers and filtered normal maps have it.
#include "../materials.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace test;

namespace {

TermDescription with(const std::string& type, std::initializer_list<std::pair<std::string, Value>> values) {
  TermDescription term;
  term.distribution.type = type;
  for (const auto& [key, value] : values) term.distribution.values.set(key, value);
  return term;
}

double alpha_of(const TermDescription& term) { return build(term).surface().slopes().alpha_x; }

} // namespace

TEST_CASE("roughness_convention: alpha as each renderer makes it") {
  for (const double r : {0.001, 0.02, 0.3, 1.0}) {
    CAPTURE(r);
    const auto alpha = [&](const std::string& convention) {
      return alpha_of(with("ggx", {{"roughness", r}, {"roughness_convention", convention}}));
    };
    for (const std::string squared : {"gltf", "openpbr", "unreal", "cycles"}) CHECK(alpha(squared) == r * r);
    CHECK(alpha("disney") == std::max(r * r, 0.001));
    CHECK(alpha("pbrt") == std::sqrt(r));
    const double x = std::log(r);
    CHECK(alpha("pbrt_v3") == doctest::Approx(1.62142 + 0.819955 * x + 0.1734 * x * x + 0.0171201 * x * x * x +
                                              0.000640711 * x * x * x * x));
  }
  CHECK_THROWS_WITH(build(with("ggx", {{"roughness", 1.5}, {"roughness_convention", std::string("pbrt")}})),
                    doctest::Contains("/distribution/roughness: found 1.5, accepted beside \"roughness_convention\""));
  CHECK_THROWS_WITH(build(with("ggx", {{"alpha", 0.5}, {"roughness_convention", std::string("pbrt")}})),
                    doctest::Contains("cannot stand beside"));
}

TEST_CASE("mean_normal_length: Toksvig's exponent, and alpha by n = 2 / alpha^2 - 2") {
  for (const double n : {1e-3, 1.0, 50.0, 1e5})
    for (const double length : {1e-3, 0.5, 0.9, 0.9999, 1.0}) {
      CAPTURE(n);
      CAPTURE(length);
      const double expected = length * n / (length + n * (1 - length));
      CHECK(std::get<Phong>(
                build(with("phong", {{"exponent", n}, {"mean_normal_length", length}})).surface().distribution)
                .profile.exponent == doctest::Approx(expected).epsilon(1e-14));
      const double alpha = std::sqrt(2 / (n + 2));
      for (const std::string type : {"ggx", "beckmann"})
        CHECK(alpha_of(with(type, {{"alpha", alpha}, {"mean_normal_length", length}})) ==
              doctest::Approx(std::sqrt(2 / (expected + 2))).epsilon(1e-13));
    }
  CHECK(alpha_of(with("ggx", {{"alpha", 1.0}, {"mean_normal_length", 0.3}})) == 1);
  CHECK_THROWS_WITH(build(with("phong", {{"exponent", -0.5}, {"mean_normal_length", 0.5}})),
                    doctest::Contains("/distribution/exponent: found -0.5, accepted beside \"mean_normal_length\""));
  CHECK_THROWS_WITH(build(with("ggx", {{"alpha", 1.5}, {"mean_normal_length", 0.5}})),
                    doctest::Contains("/distribution/alpha: found 1.5, accepted beside \"mean_normal_length\""));
}

TEST_CASE("slope_moments: LEAN's covariance and the base's roughness, against multiprecision") {
  struct Case {
    Rgb moments;
    Vec2 mean;
    double alpha, alpha_x, alpha_y, correlation;
  };
  // By mpmath with 40 digits: alpha_x = sqrt(2 (E[xx] - mean_x^2) + alpha^2), and so on.
  for (const Case& one : std::initializer_list<Case>{
           {{0.155, 0.01, 0.02}, {0.1, -0.05}, 0.2, 0.57445626465380287, 0.23452078799117149, 0.37113480951260274},
           {{100.0001, 0.04, -0.5},
            {-10.0, 0.05},
            0.01,
            0.017320508075880433,
            0.27404379212089443,
            1.1694984169500729e-14},
           {{0.02, 0.02, 0.02}, {0.0, 0.0}, 0.001, 0.2000024999843752, 0.2000024999843752, 0.99997500062498438},
           {{1e-08, 4e-08, -1e-08}, {0.0, 0.0}, 0.0001, 0.00017320508075688773, 0.0003, -0.3849001794597505},
           {{0.25, 0.09, 0.15}, {0.5, 0.3}, 0.3, 0.29999999999999999, 0.3, 0.0}}) {
    CAPTURE(one.alpha);
    const Material m =
        build(with("beckmann", {{"alpha", one.alpha}, {"slope_moments", one.moments}, {"mean_slope", one.mean}}));
    const SlopeMap& map = m.surface().slopes();
    // E[xx] - mean^2 has one rounding, however much of it cancels.
    constexpr double bound = 4e-15;
    CHECK(relative(map.alpha_x, one.alpha_x) < bound);
    CHECK(relative(map.alpha_y, one.alpha_y) < bound);
    CHECK(std::fabs(map.correlation - one.correlation) < bound);
    CHECK(Vec2{map.mean_x, map.mean_y} == one.mean);
  }
}

TEST_CASE("slope_moments: the second moments are those of the ideal average, a mixture of the facets") {
  // Four texels of one base: mean and covariance of the mixture's slopes by a midpoint rule.
  const std::vector<Vec2> texels = {{0.4, 0.1}, {-0.6, 0.3}, {0.1, -0.2}, {0.3, 0.2}};
  const double alpha = 0.3;
  WeightedChoices parts;
  Vec2 mean{0, 0};
  Rgb moments{0, 0, 0};
  for (const Vec2& texel : texels) {
    parts.push_back({1, general("beckmann", alpha, alpha, 0, texel).distribution});
    for (std::size_t k = 0; k < 2; ++k) mean[k] += texel[k] / 4;
    moments = {moments[0] + texel[0] * texel[0] / 4, moments[1] + texel[1] * texel[1] / 4,
               moments[2] + texel[0] * texel[1] / 4};
  }
  const Material ideal = build(mixture(parts));
  const Distribution& d = ideal.surface().distribution;
  const SlopeMap lean =
      build(with("beckmann", {{"alpha", alpha}, {"slope_moments", moments}, {"mean_slope", mean}})).surface().slopes();
  double xx = 0, yy = 0, xy = 0;
  constexpr int n = 160;
  constexpr double step = 4.0 / n; // to 5 sigma and more beyond the texels; a midpoint rule converges exponentially
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j) {
      const double x = (k + 0.5) * step - 2, y = (j + 0.5) * step - 2;
      const double p = std::visit([&](const auto& of) { return of.p22(x, y); }, d) * step * step;
      xx += p * (x - mean[0]) * (x - mean[0]);
      yy += p * (y - mean[1]) * (y - mean[1]);
      xy += p * (x - mean[0]) * (y - mean[1]);
    }
  CHECK(relative(0.5 * lean.alpha_x * lean.alpha_x, xx) < 1e-6);
  CHECK(relative(0.5 * lean.alpha_y * lean.alpha_y, yy) < 1e-6);
  CHECK(relative(0.5 * lean.alpha_x * lean.alpha_y * lean.correlation, xy) < 1e-6);
  CHECK(ideal.surface().slopes().mean_x == doctest::Approx(lean.mean_x));
}

TEST_CASE("slope_moments of no slopes, beside a correlation, or of slopes without variance are refused") {
  const auto moments = [](const std::string& type, const Rgb& of, double correlation = 0) {
    return with(type,
                {{"alpha", 0.1}, {"slope_moments", of}, {"mean_slope", Vec2{0.5, 0}}, {"correlation", correlation}});
  };
  CHECK_THROWS_WITH(build(moments("beckmann", {0.2, 0.1, 0})),
                    doctest::Contains("/distribution/slope_moments: found a variance of -0.0"));
  CHECK_THROWS_WITH(build(moments("beckmann", {0.35, 0.1, 0.2})), doctest::Contains("along some axis"));
  CHECK_NOTHROW(build(moments("beckmann", {0.25f, 0.1f, 0})));
  CHECK_THROWS_WITH(build(moments("beckmann", {0.3, 0.1, 0}, 0.5)),
                    doctest::Contains("/distribution/correlation: found 0.5 beside \"slope_moments\""));
  CHECK_THROWS_WITH(build(moments("ggx", {0.3, 0.1, 0})),
                    doctest::Contains("/distribution/slope_moments: the slopes of \"ggx\" have no finite variance"));
  CHECK_THROWS_WITH(build(with("student_t", {{"alpha", 0.1}, {"gamma", 4.0}, {"slope_variance", 0.1}})),
                    doctest::Contains("/distribution/slope_variance: the slopes of \"student_t\" are not Gaussian"));
}

TEST_CASE("slope_variance: roughness to variance, the map's added, and back") {
  for (const double alpha : {1e-6, 0.1, 2.0})
    for (const double v : {0.0, 1e-14, 0.02, 1e3}) {
      CAPTURE(alpha);
      CAPTURE(v);
      const SlopeMap map = build(with("beckmann", {{"alpha", alpha}, {"slope_variance", v}})).surface().slopes();
      CHECK(relative(map.alpha_x, std::sqrt(alpha * alpha + 2 * v)) < 4e-16);
      CHECK(map.alpha_y == map.alpha_x);
      // The moments of a map that varies alike along all axes say the same.
      const Rgb moments{v, v, 0};
      CHECK(relative(alpha_of(with("beckmann", {{"alpha", alpha}, {"slope_moments", moments}})), map.alpha_x) < 1e-15);
    }
}
