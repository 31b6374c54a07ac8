#include "materials.hpp"

#include "math/kernels/sampling.hpp"
#include "microfacet/distributions/beckmann.hpp"
#include "microfacet/distributions/ggx.hpp"
#include "sampling/points.hpp"
#include "sampling/weights.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

using namespace test;

namespace {

constexpr double below_1 = 1 - 0x1p-53;

/// Points that go to the ends of the square, and all over it.
std::vector<SamplePoint> square() {
  std::vector<SamplePoint> all;
  const double ends[] = {0, 0x1p-53, 1e-12, 1e-8, 1e-4, 0.5, 1 - 1e-4, 1 - 1e-8, 1 - 1e-12, below_1};
  for (const double u1 : ends)
    for (const double u2 : ends) all.push_back({u1, u2, 0.5});
  for (const SamplePoint& point : points(PointKind::sobol, 3, 0, 0, 300)) all.push_back(point);
  return all;
}

/// Under every instruction set.
template <class Function>
void on_every_isa(const Function& run) {
  const kernels::Isa before = kernels::active_isa();
  for (const kernels::Isa isa : kernels::available_isas()) {
    REQUIRE(kernels::use_isa(isa));
    run();
  }
  kernels::use_isa(before);
}

/// c + s x against e^(-x^2), from where facets are seen up to x, and over all.
struct SeenShares {
  long double c, s, low, whole;
  SeenShares(double cosine, double sine)
      : c(cosine), s(sine), low(sine > 0 ? -std::fmin(9.0, cosine / sine) : -9), whole(above(low)) {}
  long double above(long double x) const {
    const long double root_pi = std::sqrt(std::numbers::pi_v<long double>);
    return 0.5L * (c * root_pi * std::erfc(x) + s * std::exp(-x * x));
  }
  double below(double x) const { return static_cast<double>(1 - above(x) / whole); }
};

Direction at(const DirectionArrays& arrays, std::size_t k) { return arrays.view()[k]; }

double apart(const Direction& a, const Direction& b) {
  return std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)});
}

} // namespace

TEST_CASE("Beckmann in batches: the shares below both slopes are the numbers, at any angle, up to the ends") {
  const std::vector<SamplePoint> all = square();
  std::vector<double> u1, u2, x(all.size()), y(all.size()), z(all.size()), pdf(all.size());
  for (const SamplePoint& point : all) u1.push_back(point[0]), u2.push_back(point[1]);
  on_every_isa([&] {
    for (const double a : {0.0, 1e-12, 1e-6, 1e-3, 0.1, 0.5, 1.0, 1.6, 2.5, 4.0, 6.0, 8.99, 9.01, 30.0, 1e4, 1e12}) {
      const double s = 1 / std::hypot(1, a), c = a * s;
      const SeenShares shares(c, s);
      kernels::mirror_at_visible_normals(kernels::Distribution::beckmann, {}, {s, 0, c, 1, c, s, 1, 0}, u1.data(),
                                         u2.data(), {x.data(), y.data(), z.data(), pdf.data()}, all.size());
      double worst = 0, worst_across = 0;
      for (std::size_t k = 0; k < all.size(); ++k) {
        const Direction h{x[k] + s, y[k], z[k] + c};
        if (!(h.z > 1e-3)) continue; // where o + i has no digits left
        const double facing = h.x / h.z, across = h.y / h.z;
        worst = std::fmax(worst, std::fabs(shares.below(facing) - u1[k]));
        worst_across = std::fmax(worst_across, std::fabs(0.5 * std::erfc(-across) - u2[k]));
      }
      CAPTURE(a);
      CHECK(worst < 1e-13);
      CHECK(worst_across < 1e-13);
    }
  });
}

TEST_CASE("directions in batches are those that are drawn one by one") {
  const std::vector<SamplePoint> all = square();
  const std::pair<double, double> alphas[] = {{1e-4, 1e-4}, {1e-3, 1.0}, {1.0, 1e-3}, {0.3, 0.3}, {1e-3, 1e-6}};
  on_every_isa([&] {
    for (const auto* type : {"ggx", "beckmann"})
      for (const auto& alpha : alphas)
        for (const double correlation : {0.0, 0.9})
          for (const double slope : {0.0, 0.3}) {
            const Material m = build(general(type, alpha.first, alpha.second, correlation, {slope, -slope}));
            const Sampler sampler(m, "visible_normals");
            for (const double theta : {0.0, 1e-9, 0.8, 80 * degree, 89.9 * degree, 0.5 * std::numbers::pi - 1e-9}) {
              const Direction o = from_angles(theta, 2.5);
              if (!(m.mesosurface().project(o).c > 0)) continue;
              const Sampler::Viewer viewer(sampler, o);
              DirectionArrays lights;
              std::vector<double> pdf;
              sampler.sample(o, all, lights, pdf);
              double worst = 0;
              for (std::size_t k = 0; k < all.size(); ++k) {
                // Where the density of Beckmann's share is small, rounding of the share moves the slope far; the ends
                // are looked at above.
                if (std::string(type) == "beckmann" && std::fabs(all[k][0] - 0.5) > 0.49999) continue;
                if (std::string(type) == "beckmann" && std::fabs(all[k][1] - 0.5) > 0.49999) continue;
                // At the rim of GGX's cap slopes are a quotient by 1 - u2, and as sensitive to u1.
                const double sensitivity = std::string(type) == "ggx" ? 1 / (1 - all[k][1]) : 100;
                worst = std::fmax(worst, apart(at(lights, k), viewer.sample(all[k])) / sensitivity);
                CHECK(std::fabs(dot(at(lights, k), at(lights, k)) - 1) < 1e-14);
                CHECK((pdf[k] >= 0 && std::isfinite(pdf[k])));
              }
              CAPTURE(m.name);
              CAPTURE(theta);
              CHECK(worst < 1e-14);
            }
          }
  });
}

TEST_CASE("densities of a batch are those of the pairs, but for the rounding of o + i") {
  const std::vector<SamplePoint> all = points(PointKind::sobol, 3, 0, 0, 500);
  for (const auto* type : {"ggx", "beckmann"})
    for (const double alpha : {1e-4, 0.03, 0.5, 1.0}) {
      const Material m = build(general(type, alpha, 2 * alpha, 0.3, {0.1, 0}));
      const Sampler sampler(m, "visible_normals");
      for (const double theta : {0.0, 0.8, 1.5}) {
        const Direction o = from_angles(theta, 0.3);
        DirectionArrays lights;
        std::vector<double> pdf, again(all.size());
        sampler.sample(o, all, lights, pdf);
        ViewerRows rows(o);
        const Batch batch = rows.with_lights(all.size(), [&](std::size_t k) { return at(lights, k); });
        sampler.densities(batch.n, batch.o, batch.i, again.data());
        double worst = 0;
        for (std::size_t k = 0; k < all.size(); ++k) worst = std::fmax(worst, std::fabs(again[k] / pdf[k] - 1));
        CAPTURE(type);
        CAPTURE(alpha);
        CAPTURE(theta);
        CHECK(worst < 1e-12 / alpha);
      }
    }
}

TEST_CASE("a sample depends on its point alone, in whatever batch it is") {
  const std::vector<SamplePoint> all = points(PointKind::random, 5, 0, 0, 1000);
  for (const auto* type : {"ggx", "beckmann"}) {
    const Material m = build(describe(type, 0.3));
    const Sampler sampler(m, "visible_normals");
    const Direction o = from_angles(1.1, 0.4);
    WeightedSamples whole, part;
    draw(m, sampler, o, all, whole);
    for (const std::size_t first : {0U, 1U, 3U, 517U, 999U}) {
      draw(m, sampler, o, {all.begin() + static_cast<std::ptrdiff_t>(first), all.end()}, part);
      for (std::size_t k = first; k < all.size(); ++k) {
        CHECK(at(part.lights, k - first).x == at(whole.lights, k).x);
        CHECK(part.pdf[k - first] == whole.pdf[k]);
        CHECK(part.weights[k - first] == whole.weights[k]);
      }
    }
  }
}

TEST_CASE("batches of several terms and of mixtures are those of their parts, one by one") {
  TermDescription lambert;
  lambert.type = lambert.name = "lambert";
  TermDescription tail = test::distribution("student_t", {{"alpha", 0.2}, {"gamma", 2.5}});
  tail.name = "tail";
  const Material m = build(
      MaterialDescription("all", {describe("ggx", 0.3), lambert, describe("beckmann", 0.1, "smith"), tail}, true));
  const Sampler sampler(m, "default");
  const std::vector<SamplePoint> all = points(PointKind::random, 5, 0, 0, 2000);
  const Direction o = from_angles(0.9, 0.4);
  const Sampler::Viewer viewer(sampler, o);
  WeightedSamples drawn;
  draw(m, sampler, o, all, drawn);
  for (std::size_t k = 0; k < all.size(); ++k) CHECK(apart(at(drawn.lights, k), viewer.sample(all[k])) < 1e-11);
}
