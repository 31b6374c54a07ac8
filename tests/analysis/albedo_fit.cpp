// The rational fit of an albedo, against the integrals at random places.
#include "../materials.hpp"
#include "analysis/fit/albedo.hpp"
#include "base/errors.hpp"
#include "base/threads/parallel.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace brdfplot;

namespace {

MaterialDescription ggx(double alpha) { return test::describe("ggx", alpha); }

double albedo(const MaterialDescription& material, double cosine) {
  return compute_or_throw(Integral::albedo, build(material), {std::sqrt((1 - cosine) * (1 + cosine)), 0, cosine}, 1e-7);
}

} // namespace

TEST_CASE("a fit of the albedo is within its tolerance and within [0, 1]") {
  const AlbedoFit fit = fit_albedo(ggx(0.5), {.tolerance = 0.01, .threads = hardware_threads()});
  CHECK(fit.form.by_alpha);
  CHECK(std::max(fit.in_double, fit.in_float) < 0.01);
  for (const float c : fit.form.n) CHECK(c >= 0);
  for (const float c : fit.form.m) CHECK(c >= 0);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (int k = 0; k < 300; ++k) {
    const double cosine = std::pow(share(random), 3), alpha = 0.01 + 0.99 * std::pow(share(random), 2);
    const double exact = albedo(ggx(alpha), std::max(cosine, 1e-6));
    CHECK(std::fabs(fit.form.value(cosine, alpha) - exact) < 0.01);
    CHECK(std::fabs(static_cast<double>(fit.form.value(static_cast<float>(cosine), static_cast<float>(alpha))) -
                    exact) < 0.0101);
  }
  for (const float cosine : {-1.0F, 0.0F, 1e-38F, 1e-6F, 1.0F, 2.0F})
    for (const float alpha : {-1.0F, 0.0F, 0.01F, 0.5F, 1.0F, 1e30F}) {
      const float value = fit.form.value(cosine, alpha);
      CHECK(value >= 0);
      CHECK(value <= 1);
    }
  CHECK(fit.form.value(0.5, 1e-3) == fit.form.value(0.5, 0.01)); // beyond its domain, as at its end
}

TEST_CASE("with alpha fixed the fit is one of the cosine alone") {
  const AlbedoFit fit = fit_albedo(ggx(0.3), {.tolerance = 1e-3, .fixed = true, .threads = hardware_threads()});
  CHECK(!fit.form.by_alpha);
  CHECK(fit.form.dy == 0);
  for (const double cosine : {1e-3, 0.03, 0.2, 0.77, 1.0})
    CHECK(std::fabs(fit.form.value(cosine, 0.0) - albedo(ggx(0.3), cosine)) < 1e-3);
}

TEST_CASE("what has no such fit is refused") {
  MaterialDescription brushed = ggx(0.5);
  brushed.terms[0].distribution.values = {};
  brushed.terms[0].distribution.values.set("alpha_x", 0.1);
  brushed.terms[0].distribution.values.set("alpha_y", 0.5);
  CHECK_THROWS_AS(fit_albedo(brushed, {}), InputError);
  MaterialDescription gold = ggx(0.5);
  gold.terms[0].weight = Rgb{1, 0.8, 0.3};
  CHECK_THROWS_AS(fit_albedo(gold, {}), InputError);
  MaterialDescription bright = ggx(0.5);
  bright.terms[0].weight = 2.0;
  CHECK_THROWS_AS(fit_albedo(bright, {}), InputError); // above 1
}
