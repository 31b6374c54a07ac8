#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "figure/profile/surface.hpp"
#include "microfacet/beckmann_lambda.hpp"

namespace {

using namespace brdfplot;
using namespace brdfplot::plot;

constexpr double degree = std::numbers::pi / 180;
const std::vector<double> angles = {-89, -75, -40, -1e-3, 0, 1e-3, 20, 60, 80, 89.9};

/// Heights without any order: every profile is as good as another.
std::vector<double> random_heights(std::size_t count, double size, std::uint64_t seed) {
  Random random(seed, 7);
  std::vector<double> out;
  for (std::size_t k = 0; k < count; ++k) out.push_back(size * (random.uniform() - 0.5));
  return out;
}

/// Whether a point of a joined profile is visible, by looking at every corner in front of it.
bool sees(const Profile& profile, std::size_t k, double fraction, double theta) {
  const Segment s = profile.facets[k].part(fraction, 1);
  if (projected_area(profile.facets[k], theta) <= 0) return false;
  const auto count = static_cast<std::ptrdiff_t>(profile.facets.size());
  for (std::ptrdiff_t j = -20 * count; j < 20 * count; ++j) {
    const Segment corner = profile.facet(j);
    const double ahead = (corner.x0 - s.x0) * std::sin(theta);
    if (ahead <= 0) continue;
    const double ray = s.h0 + (corner.x0 - s.x0) * std::cos(theta) / std::sin(theta);
    if (corner.h0 > ray) return false;
  }
  return true;
}

ModelChoice surface(const std::string& type, double alpha) {
  ModelChoice choice{.type = type, .values = {}};
  choice.values.set("alpha", alpha);
  return choice;
}

} // namespace

TEST_CASE("profiles: what is visible has the projected area of the mesosurface, whatever the heights") {
  for (const double size : {1e-3, 1.0, 30.0})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Profile level = joined(random_heights(97, size, seed));
      for (const Distortion distortion : {Distortion{1, 0}, Distortion{0.3, 0}, Distortion{2, 0.7}}) {
        const Profile profile = distortion.of(level);
        for (const double angle : angles) {
          const double theta = distortion.of(angle * degree);
          CAPTURE(size);
          CAPTURE(angle);
          const Visibility v = measure(profile, theta);
          CHECK(v.seen_area == doctest::Approx(v.mesosurface).epsilon(1e-12 * (1 + size) / v.mesosurface));
          CHECK(v.shares.seen <= v.shares.facing);
          CHECK(v.shares.facing <= 1 + 1e-12);
        }
      }
    }
}

TEST_CASE("profiles: a point is visible if no corner in front of it stands above its ray") {
  const Profile profile = joined(random_heights(41, 3, 11));
  Random random(3, 0);
  int seen = 0, hidden = 0;
  for (const double angle : {-80.0, -50.0, 15.0, 70.0, 86.0}) {
    const auto spans = visible(profile, angle * degree);
    for (std::size_t k = 0; k < spans.size(); ++k) {
      const double fraction = random.uniform();
      const bool expected = sees(profile, k, fraction, angle * degree);
      CAPTURE(angle);
      CAPTURE(k);
      CHECK((fraction >= spans[k].from && fraction < spans[k].to) == expected);
      (expected ? seen : hidden) += 1;
    }
  }
  CHECK(seen > 20);
  CHECK(hidden > 20);
}

TEST_CASE("profiles: stretching and shearing surface and direction together changes nothing that is visible") {
  const Profile profile = joined(random_heights(64, 4, 5));
  for (const double angle : angles)
    for (const Distortion distortion : {Distortion{2, 0}, Distortion{0.25, 0}, Distortion{1, 0.8}, Distortion{3, -2}}) {
      const auto before = visible(profile, angle * degree);
      const auto after = visible(distortion.of(profile), distortion.of(angle * degree));
      for (std::size_t k = 0; k < before.size(); ++k) {
        CAPTURE(angle);
        CAPTURE(k);
        CHECK(after[k].length() == doctest::Approx(before[k].length()).epsilon(1e-9));
        CHECK(after[k].from == doctest::Approx(before[k].from).epsilon(1e-9));
      }
    }
}

TEST_CASE("profiles: rays stop where they meet the surface again, and only those of what is masked") {
  const Profile profile = joined(random_heights(50, 5, 2));
  for (const double angle : {-70.0, 45.0, 82.0}) {
    const double theta = angle * degree;
    const auto spans = visible(profile, theta);
    for (std::size_t k = 0; k < spans.size(); ++k) {
      if (projected_area(profile.facets[k], theta) <= 0) continue;
      const double fraction = 0.37;
      for (const std::ptrdiff_t period : {-1, 0, 2}) {
        const auto index = static_cast<std::ptrdiff_t>(k) + 50 * period;
        const auto met = meeting(profile, index, fraction, theta);
        CAPTURE(angle);
        CAPTURE(k);
        const bool seen = fraction >= spans[k].from && fraction < spans[k].to;
        REQUIRE(met.has_value() == !seen);
        if (!met) continue;
        const Segment from = profile.facet(index).part(fraction, 1);
        // On the ray, and on the surface.
        CHECK((met->x - from.x0) * std::cos(theta) == doctest::Approx((met->h - from.h0) * std::sin(theta)));
        const auto facet = static_cast<std::ptrdiff_t>(std::floor(met->x));
        const Segment there = profile.facet(facet);
        CHECK(met->h == doctest::Approx(there.part(met->x - there.x0, 1).h0).epsilon(1e-9));
        CHECK((met->x - from.x0) * theta > 0);
      }
    }
  }
}

TEST_CASE("profiles: V-cavities are visible as Eq. 49 says") {
  ModelChoice choice = surface("v_cavity", 0.7);
  choice.values.set("pairs", 16.0);
  const Cuts cuts(choice, 3, false);
  REQUIRE(cuts.count() == 16);
  int partly = 0;
  for (const std::size_t k : {1U, 5U, 9U, 15U}) {
    const Profile profile = cuts.profile(k);
    const double tan_m = std::fabs(profile.facets[0].h1 - profile.facets[0].h0);
    CHECK(profile.facets[0].h0 == doctest::Approx(-profile.facets[0].h1));
    CHECK(std::tan(cuts.theta_m(k)) == doctest::Approx(tan_m));
    for (const double angle : angles) {
      const Visibility v = measure(profile, angle * degree);
      const double cos_o = std::cos(angle * degree), sin_o = std::sin(std::fabs(angle * degree));
      // 2 cos_m cos_o / (o.m), with o.m = cos_m (cos_o + sin_o tan_m)
      const double expected = std::fmin(1, 2 * cos_o / (cos_o + sin_o * tan_m));
      CHECK(v.shares.seen / v.shares.facing == doctest::Approx(expected));
      CHECK(cuts.g1(k, angle * degree, {}).value() == doctest::Approx(expected));
      if (expected < 1) ++partly;
    }
    CHECK(cuts.surface_of(k) == std::vector<std::size_t>{k});
  }
  CHECK(partly >= 8);
}

TEST_CASE("profiles: independent facets are visible as Smith says, and do not know their neighbours") {
  ModelChoice choice = surface("uncorrelated", 0.8);
  choice.values.set("samples", 200000.0);
  const Cuts cuts(choice, 1, false);
  const Profile profile = cuts.profile(0);
  CHECK(std::fabs(autocorrelation(cuts, {cuts.correlation_length()}).front()) < 0.01);
  for (const Distortion distortion : {Distortion{1, 0}, Distortion{2, 0.4}})
    for (const double angle : {-75.0, 0.0, 40.0, 80.0}) {
      const double theta = angle * degree;
      const Visibility v = measure(distortion.of(profile), distortion.of(theta));
      const double expected =
          angle == 0
              ? 1
              : 1 / (1 + beckmann_a_lambda(1 / (0.8 * std::tan(std::fabs(theta)))) * 0.8 * std::tan(std::fabs(theta)));
      CAPTURE(angle);
      CHECK(cuts.g1(0, theta, distortion).value() == doctest::Approx(expected));
      CHECK(v.shares.seen / v.shares.facing == doctest::Approx(expected).epsilon(0.01));
      CHECK(v.seen_area == doctest::Approx(v.mesosurface).epsilon(0.015));
    }
  // Smith's height-correlated form (Heitz 2014, Eq. 99), and what it is where viewer and light are one.
  for (const double angle : {-70.0, 50.0, 75.0}) {
    const Shares both = measure(profile, 60 * degree, angle * degree);
    const double o = cuts.g1(0, 60 * degree, {}).value(), i = cuts.g1(0, angle * degree, {}).value();
    CHECK(both.seen / both.facing == doctest::Approx(1 / (1 / o + 1 / i - 1)).epsilon(0.01));
  }
}

TEST_CASE("profiles: generated surfaces have the autocorrelation and the slopes that are asked") {
  for (const bool along_y : {false, true}) {
    ModelChoice choice{.type = "gaussian", .values = {}};
    choice.values.set("alpha_x", 0.6);
    choice.values.set("alpha_y", 0.3);
    choice.values.set("samples", 256.0);
    choice.values.set("correlation_length", 8.0);
    const Cuts cuts(choice, 1, along_y);
    REQUIRE(cuts.count() == 256);
    double squares = 0;
    for (std::size_t k = 0; k < cuts.count(); ++k)
      for (const Segment& s : cuts.profile(k).facets) squares += (s.h1 - s.h0) * (s.h1 - s.h0) / 65536;
    CHECK(2 * squares == doctest::Approx(along_y ? 0.09 : 0.36).epsilon(1e-3));
    // Heights are less steep along y, over twice the distance.
    const auto measured = autocorrelation(cuts, {0, 4, along_y ? 16u : 8u, 40});
    CHECK(measured[0] == 1);
    CHECK(measured[2] == doctest::Approx(std::exp(-1)).epsilon(0.05));
    // As the law has it, but for facets that are chords; far apart what is left is chance.
    REQUIRE(cuts.law());
    CHECK(cuts.law()->length == doctest::Approx(along_y ? 16 : 8));
    CHECK(measured[1] == doctest::Approx(cuts.law()->at(4)).epsilon(0.02));
    CHECK(std::fabs(measured[3] - cuts.law()->at(40)) < 0.05);
  }
}

TEST_CASE("profiles: what viewer and light see together is at most what one of them sees") {
  const Profile profile = joined(random_heights(80, 4, 9));
  for (const double angle : {-75.0, -30.0, 0.0, 70.0}) {
    const Shares both = measure(profile, 70 * degree, angle * degree);
    const Shares light = measure(profile, angle * degree).shares, viewer = measure(profile, 70 * degree).shares;
    CHECK(both.seen <= std::fmin(light.seen, viewer.seen) + 1e-12);
    CHECK(both.facing <= std::fmin(light.facing, viewer.facing) + 1e-12);
    CHECK(both.seen <= both.facing + 1e-12);
    if (angle == 0) CHECK(both.seen == doctest::Approx(viewer.seen));
    if (angle == 70) CHECK(both.seen == doctest::Approx(viewer.seen));
  }
}

TEST_CASE("profiles: below the horizon there is nothing to see") {
  const Profile profile = joined({0, 1});
  CHECK_THROWS_AS(visible(profile, 91 * degree), InputError);
  CHECK_THROWS_AS(visible(profile, -90.5 * degree), InputError);
  const Distortion sheared{1, 2};
  CHECK_THROWS_AS(visible(sheared.of(profile), 60 * degree), InputError);
  CHECK_NOTHROW(visible(sheared.of(profile), sheared.of(60 * degree)));
}
