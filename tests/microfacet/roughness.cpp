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
  CHECK_THROWS_WITH(build(with("ggx", {{"alpha", 1.5}, {"mean_normal_length", 0.5}})),
                    doctest::Contains("/distribution/alpha: found 1.5, accepted beside \"mean_normal_length\""));
}
