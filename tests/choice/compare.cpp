#include "choice/compare/compare.hpp"

#include "base/errors.hpp"
#include "brdf/evaluate.hpp"
#include "sample.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace brdfplot;
using namespace brdfplot::choice;
using test::sampled;

namespace {

MaterialDescription lambert(double albedo) {
  TermDescription term;
  term.type = "lambert";
  term.values.set("albedo", albedo);
  return {"lambert", {term}, true};
}

MaterialDescription rough(const std::string& distribution, double alpha, double weight = 1) {
  TermDescription term;
  term.distribution.type = distribution;
  term.distribution.values.set("alpha", alpha);
  term.weight = weight;
  return {distribution, {term}, true};
}

} // namespace

TEST_CASE("compare: a material does not differ from itself") {
  const MaterialDifference same = difference_of(rough("ggx", 0.3), rough("ggx", 0.3), {.points = 512});
  CHECK(same.rms == 0);
  CHECK(same.light == 0);
  CHECK(same.relative == 0);
  CHECK(same.sphere.p95 == 0);
  for (const AlbedoPair& pair : same.albedo) CHECK(pair.a == pair.b);
}

TEST_CASE("compare: half of a BRDF is half of it by every measure") {
  for (const auto& [a, b, share] :
       {std::tuple(lambert(0.5), lambert(0.25), 0.5), std::tuple(rough("ggx", 0.3), rough("ggx", 0.3, 0.9), 0.1),
        std::tuple(rough("beckmann", 0.05), rough("beckmann", 0.05, 0.75), 0.25)}) {
    const double part = share; // clang 14 captures no structured binding
    const MaterialDifference half = difference_of(a, b, {.points = 512});
    CHECK(half.rms == doctest::Approx(part).epsilon(1e-9));
    CHECK(half.light == doctest::Approx(part).epsilon(1e-9));
    CHECK(half.relative == doctest::Approx(part).epsilon(1e-9));
    CHECK(half.sphere.energy == doctest::Approx(-part).epsilon(1e-6));
    for (const AlbedoPair& pair : half.albedo)
      CHECK(pair.b[0] == doctest::Approx((1 - part) * pair.a[0]).epsilon(1e-5));
  }
  const MaterialDifference grey = difference_of(lambert(0.5), lambert(0.25), {.points = 512});
  CHECK(std::abs(grey.largest.a - grey.largest.b) ==
        doctest::Approx(0.25 / std::numbers::pi).epsilon(1e-6)); // at the normal
}

TEST_CASE("compare: light that goes elsewhere, against a sum over a grid") {
  const Material a = build(rough("ggx", 0.5)), b = build(rough("beckmann", 0.5));
  const std::size_t n = sampled() ? 60 : 240, viewers = sampled() ? 8 : 24;
  double different = 0, all = 0, square = 0, square_of_a = 0;
  for (std::size_t v = 0; v < viewers; ++v) {
    const double mu = (static_cast<double>(v) + 0.5) / static_cast<double>(viewers);
    const Direction o = from_angles(std::acos(mu), 0);
    std::vector<double> ox(n * n, o.x), oy(n * n, o.y), oz(n * n, o.z), x, y, z;
    std::vector<double> weight;
    for (std::size_t t = 0; t < n; ++t)
      for (std::size_t p = 0; p < n; ++p) {
        // The middle of a cell of equal solid angle, finer towards the mirror direction's azimuth.
        const double c = (static_cast<double>(t) + 0.5) / static_cast<double>(n);
        const double phi = std::numbers::pi * (static_cast<double>(p) + 0.5) / static_cast<double>(n);
        const Direction i = from_angles(std::acos(c), phi);
        x.push_back(i.x);
        y.push_back(i.y);
        z.push_back(i.z);
      }
    const Batch batch{n * n, {ox.data(), oy.data(), oz.data()}, {x.data(), y.data(), z.data()}, {}};
    std::vector<double> of_a(n * n), of_b(n * n);
    evaluate(a, Quantity::brdf_cos, batch, of_a.data());
    evaluate(b, Quantity::brdf_cos, batch, of_b.data());
    for (std::size_t k = 0; k < n * n; ++k) {
      const double d = std::abs(of_a[k] - of_b[k]);
      different += mu * d;
      all += mu * of_a[k];
      square += mu * d * d;
      square_of_a += mu * of_a[k] * of_a[k];
    }
  }
  const MaterialDifference found = difference_of(rough("ggx", 0.5), rough("beckmann", 0.5), {.points = 4096});
  CHECK(found.light == doctest::Approx(different / all).epsilon(sampled() ? 0.1 : 0.01));
  CHECK(found.light_error < 0.01 * found.light);
  CHECK(found.rms == doctest::Approx(std::sqrt(square / square_of_a)).epsilon(sampled() ? 0.2 : 0.03));
}

TEST_CASE("compare: a fit finds what was changed") {
  const MaterialDescription fitted = refitted_to(rough("ggx", 0.45), rough("ggx", 0.3), {"alpha"}, 1);
  CHECK(fitted.terms[0].distribution.values.number("alpha") == doctest::Approx(0.45).epsilon(0.01));
  const MaterialDescription grey = refitted_to(lambert(0.4), lambert(0.7), {"albedo"}, 1);
  CHECK(grey.terms[0].values.rgb("albedo")[0] == doctest::Approx(0.4).epsilon(0.01));
  CHECK_THROWS_WITH_AS(refitted_to(lambert(0.4), lambert(0.7), {"alpha"}, 1), doctest::Contains("--refit"), InputError);
}

TEST_CASE("compare: the same numbers on any number of threads") {
  const auto text = [](int threads) {
    return comparison_csv(
        {difference_of(rough("ggx", 0.2), rough("beckmann", 0.3), {.points = 512, .threads = threads})});
  };
  CHECK(text(1) == text(3));
}
