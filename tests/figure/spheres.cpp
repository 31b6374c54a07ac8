/// Lit spheres: their pixels against the scalar BRDF, and against what is known of Lambert's and of a furnace.
#include "figure/spheres/panel.hpp"

#include "analysis/integrals.hpp"
#include "base/errors.hpp"
#include "figure/spheres/radiance.hpp"
#include "figure/spheres/srgb.hpp"
#include "materials.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace brdfplot;
using namespace brdfplot::plot;
using test::degree;

constexpr double pi = std::numbers::pi;

Colour grey(double value) { return {{value, value, value}, false}; }

Light directional(double theta, double phi, double irradiance) {
  return {Light::Type::directional, theta, phi, 0, grey(irradiance)};
}
Light sphere_light(double theta, double phi, double radius, double radiance) {
  return {Light::Type::sphere, theta, phi, radius, grey(radiance)};
}
Light environment(double radiance) { return {Light::Type::environment, 0, 0, 0, grey(radiance)}; }

TermDescription lambert(const Value& albedo) {
  TermDescription term;
  term.name = "base";
  term.type = "lambert";
  term.values.set("albedo", albedo);
  return term;
}

TermDescription anisotropic() {
  TermDescription term = test::general("ggx", 0.15, 0.4, 0.3);
  term.fresnel = {.type = "schlick", .values = {}};
  term.fresnel.values.set("f0", Rgb{0.9, 0.6, 0.3});
  return term;
}

/// GGX with F = 1 and all of its bounces: reflects all.
MaterialDescription conserving(double alpha) {
  TermDescription further;
  further.name = "further";
  further.type = "multiple_bounce";
  TermDescription single = test::describe("ggx", alpha);
  further.of = {single};
  return {"conserving", {single, further}, true};
}

Panel panel_of(const MaterialDescription& material, std::vector<Light> lights, int pixels = 32, double exposure = 1,
               int threads = 1) {
  PanelDescription description;
  description.sphere = SphereDescription{material, {}, std::move(lights), exposure, pixels};
  return sphere_panel(description, threads);
}

/// Places all over the sphere, near its edge too.
std::vector<Place> places() {
  std::vector<Place> out;
  for (const double r : {0.0, 0.1, 0.5, 0.8, 0.97, 0.9999})
    for (int k = 0; k < 12; ++k) out.push_back({r * std::cos(0.3 + k * pi / 6), r * std::sin(0.3 + k * pi / 6)});
  return out;
}

/// What a place is lit by: the cosine of its normal and a direction.
double cosine(const Place& place, double theta, double phi) {
  return dot(frame_at(place).normal, from_angles(theta, phi));
}

double steps(double a, double b) { return 255 * std::fabs(srgb(a) - srgb(b)); }

} // namespace

TEST_CASE("spheres: the curve of sRGB") {
  CHECK(srgb(0) == 0);
  CHECK(srgb(-1) == 0);
  CHECK(srgb(1) == doctest::Approx(1).epsilon(1e-15));
  CHECK(srgb(0.002) == doctest::Approx(0.02584).epsilon(1e-14));
  CHECK(srgb(0.5) == doctest::Approx(0.7353569830524495).epsilon(1e-14));
  // The pieces of the standard meet to three hundred-thousandths of a step.
  CHECK(std::fabs(srgb(0.0031308) - srgb(std::nextafter(0.0031308, 1))) < 4e-8);
  CHECK(srgb_byte(0.5) == 188);
  CHECK(srgb_byte(0.25) == 137);
  CHECK(srgb_byte(7) == 255);
}

TEST_CASE("spheres: frames are right-handed, with the tangent along the circle of latitude") {
  for (const Place& place : places()) {
    const Frame f = frame_at(place);
    CHECK(f.normal.x == place.x);
    CHECK(f.normal.y == place.y);
    CHECK(f.normal.z > 0);
    CHECK(f.tangent.y == 0);
    CHECK(f.tangent.x > 0);
    CHECK(f.bitangent.y > 0);
    for (const auto& [u, v, value] : {std::tuple{f.normal, f.normal, 1.0},
                                      {f.tangent, f.tangent, 1.0},
                                      {f.bitangent, f.bitangent, 1.0},
                                      {f.normal, f.tangent, 0.0},
                                      {f.normal, f.bitangent, 0.0},
                                      {f.tangent, f.bitangent, 0.0}})
      CHECK(std::fabs(dot(u, v) - value) < 1e-14);
    const Direction across{f.tangent.y * f.bitangent.z - f.tangent.z * f.bitangent.y,
                           f.tangent.z * f.bitangent.x - f.tangent.x * f.bitangent.z,
                           f.tangent.x * f.bitangent.y - f.tangent.y * f.bitangent.x};
    CHECK(dot(across, f.normal) == doctest::Approx(1).epsilon(1e-14));
  }
  const Frame middle = frame_at({0, 0});
  CHECK(middle.tangent.x == 1);
  CHECK(middle.bitangent.y == 1);
}

TEST_CASE("spheres: pixels are the scalar BRDF times cosine and irradiance") {
  const MaterialDescription description(anisotropic());
  const Material material = build(description);
  const double theta = 40 * degree, phi = 120 * degree;
  constexpr int side = 48;
  const Panel panel = panel_of(description, {directional(theta, phi, 1.5)}, side, 0.7);
  const Picture& picture = panel.picture.value();
  REQUIRE(picture.channels == 3);
  REQUIRE(!picture.opaque);
  REQUIRE(picture.bytes.size() == std::size_t{4} * side * side);
  const Direction light = from_angles(theta, phi);
  for (const auto& at : {std::pair{24, 24}, {10, 20}, {15, 12}, {30, 30}, {20, 40}, {40, 18}}) {
    const int row = at.first, column = at.second;
    CAPTURE(row);
    CAPTURE(column);
    const double radius = radius_in_picture * side;
    const Frame f = frame_at({(column + 0.5 - side / 2) / radius, (side / 2 - row - 0.5) / radius});
    const Direction o{f.tangent.z, f.bitangent.z, f.normal.z};
    const Direction i{dot(f.tangent, light), dot(f.bitangent, light), dot(f.normal, light)};
    const Columns at_o{&o.x, &o.y, &o.z}, at_i{&i.x, &i.y, &i.z};
    std::array<double, 3> rho{};
    evaluate(material, Quantity::brdf_cos, {1, at_o, at_i, {}}, rho.data());
    const unsigned char* pixel = &picture.bytes[std::size_t(4 * (row * side + column))];
    for (std::size_t c = 0; c < 3; ++c) CHECK(int(pixel[c]) == int(srgb_byte(0.7 * 1.5 * rho[c])));
    CHECK(int(pixel[3]) == 255);
  }
}

TEST_CASE("spheres: Lambert's under each light") {
  const Material material = build(MaterialDescription(lambert(0.6)));
  const double theta = 65 * degree, phi = 200 * degree;
  const auto all = places();
  const auto lit = radiance(material, {directional(theta, phi, 2)}, all, 1, 1);
  const auto ball = radiance(material, {sphere_light(theta, phi, 25 * degree, 2)}, all, 1, 1);
  const auto half = radiance(material, {sphere_light(theta, phi, 90 * degree, 2)}, all, 1, 1);
  const auto around = radiance(material, {environment(0.5)}, all, 1, 1);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double c = cosine(all[k], theta, phi);
    CHECK(lit[k] == doctest::Approx(0.6 / pi * 2 * std::max(0.0, c)).epsilon(1e-13));
    // The irradiance of a cap above the horizon: pi L sin^2 r cos gamma; of half of the sky: pi L (1 + cos gamma) / 2.
    if (c > std::sin(25 * degree))
      CHECK(ball[k] == doctest::Approx(0.6 * 2 * std::pow(std::sin(25 * degree), 2) * c).epsilon(1e-9));
    if (c < -std::sin(25 * degree)) CHECK(ball[k] == 0);
    CHECK(steps(half[k], 0.6 * (1 + c)) < 0.25);
    CHECK(steps(around[k], 0.3) < 0.05);
  }
}

TEST_CASE("spheres: the points of a light have its solid angle and its irradiance") {
  for (const double radius : {1e-6, 0.1, 1.0, pi / 2}) {
    const Light light = sphere_light(0.7, 2.5, radius, 1);
    const Direction middle = from_angles(0.7, 2.5);
    double solid = 0, irradiance = 0;
    for (const LightPoint& point : points_of(light, 8)) {
      CHECK(dot(point.direction, point.direction) == doctest::Approx(1).epsilon(1e-14));
      CHECK(dot(point.direction, middle) > std::cos(radius) - 1e-15);
      solid += point.weight;
      irradiance += point.weight * dot(point.direction, middle);
    }
    CHECK(solid == doctest::Approx(4 * pi * std::pow(std::sin(radius / 2), 2)).epsilon(1e-13));
    CHECK(irradiance == doctest::Approx(pi * std::pow(std::sin(radius), 2)).epsilon(1e-13));
  }
}

TEST_CASE("spheres: a small sphere light is a directional one") {
  const Material material = build(anisotropic());
  const auto all = places();
  const double radius = 1e-4, radiance_of_it = 1 / (pi * std::pow(std::sin(radius), 2));
  const auto small = radiance(material, {sphere_light(0.6, 2, radius, radiance_of_it)}, all, 1, 1);
  const auto point = radiance(material, {directional(0.6, 2, 1)}, all, 1, 1);
  for (std::size_t k = 0; k < small.size(); ++k)
    CHECK(std::fabs(small[k] - point[k]) < 1e-6 * std::max(point[k], 1e-3));
}

TEST_CASE("spheres: with twice the points a sphere light is the same to half a step of sRGB") {
  // Against 64 rings, of which the error is far below: a sharp lobe, a light that sets at the terminator.
  for (const double alpha : {0.1, 0.6}) {
    const Material material = test::material("ggx", alpha);
    const Light light = sphere_light(70 * degree, 1, 20 * degree, 1);
    const auto all = places();
    const auto found = radiance(material, {light}, all, 1, 1);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Frame f = frame_at(all[k]);
      const Direction o{f.tangent.z, f.bitangent.z, f.normal.z};
      double sum = 0;
      for (const LightPoint& p : points_of(light, 64)) {
        const Direction i{dot(f.tangent, p.direction), dot(f.bitangent, p.direction), dot(f.normal, p.direction)};
        if (i.z > 0) sum += p.weight * evaluate(material, Quantity::brdf_cos, o, i, std::nullopt);
      }
      CHECK(steps(found[k], sum) < 0.5);
    }
  }
}

TEST_CASE("spheres: in a furnace what reflects all is not seen") {
  for (const MaterialDescription& material : {MaterialDescription(lambert(1.0)), conserving(0.5), conserving(1)}) {
    const Panel panel = panel_of(material, {environment(0.5)});
    const Picture& picture = panel.picture.value();
    CHECK(picture.opaque);
    CHECK(picture.channels == 1);
    const auto [low, high] = std::ranges::minmax_element(picture.bytes);
    CHECK(int(*low) >= 187);
    CHECK(int(*high) <= 189);
  }
  // And what does not is: single scattering of GGX loses light.
  const Panel panel = panel_of(test::describe("ggx", 1), {environment(0.5)});
  CHECK(*std::ranges::min_element(panel.picture->bytes) < 150);
}

TEST_CASE("spheres: an anisotropic material in a furnace has the albedo of its azimuth") {
  TermDescription term = test::describe("ggx", 0.5);
  term.distribution.values = {};
  term.distribution.values.set("alpha_x", 0.3);
  term.distribution.values.set("alpha_y", 0.6);
  const Material material = build(term);
  const auto all = places();
  const auto found = radiance(material, {environment(1)}, all, 1, 1);
  for (std::size_t k = 0; k < all.size(); k += 5) {
    const Frame f = frame_at(all[k]);
    const Direction o{f.tangent.z, f.bitangent.z, f.normal.z};
    CHECK(std::fabs(found[k] - compute(Integral::albedo, material, o).value) < 0.05 * finest_step);
  }
}

TEST_CASE("spheres: coverage at the edge sums up to the disc") {
  for (const int side : {16, 33, 200}) {
    const Panel panel = panel_of(lambert(0.5), {directional(0.3, 0, 1)}, side);
    const Picture& picture = panel.picture.value();
    double area = 0;
    const auto at = [&](int row, int column) { return int(picture.bytes[std::size_t(2 * (row * side + column) + 1)]); };
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column) {
        area += at(row, column) / 255.0;
        REQUIRE(at(row, column) == at(column, row));
        REQUIRE(at(row, column) == at(side - 1 - row, column));
      }
    CHECK(area == doctest::Approx(pi * std::pow(radius_in_picture * side, 2)).epsilon(0.01));
    CHECK(at(side / 2, side / 2) == 255);
    CHECK(at(0, 0) == 0);
  }
}

TEST_CASE("spheres: what is cut at white is told") {
  const Panel dark = panel_of(lambert(1.0), {directional(0.5, 1, pi)});
  CHECK(dark.notes.empty());
  const Panel bright = panel_of(lambert(1.0), {directional(0, 0, 2 * pi)}, 200);
  REQUIRE(bright.notes.size() == 1);
  CHECK(bright.notes[0].label == "above_white");
  // 2 cos > 1 on 3/4 of the disc.
  CHECK(bright.notes[0].value == doctest::Approx(0.75).epsilon(0.01));
  CHECK(bright.notes[0].text == "74.1\u00a0% above white");
}

TEST_CASE("spheres: the series is the radiance along the diameter towards the light") {
  const double phi = 130 * degree;
  const Panel panel = panel_of(lambert(Rgb{0.8, 0.4, 0.2}), {environment(0.1), directional(0.9, phi, 2)}, 16);
  REQUIRE(panel.series.size() == 3);
  CHECK(panel.series[1].label == "g");
  CHECK(panel.series[0].x.front() == -0.99);
  CHECK(panel.series[0].x.back() == 0.99);
  for (std::size_t k = 0; k < panel.series[0].x.size(); ++k) {
    const double t = panel.series[0].x[k];
    const double c = std::max(0.0, t * std::sin(0.9) + std::sqrt(1 - t * t) * std::cos(0.9));
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double albedo = Rgb{0.8, 0.4, 0.2}[channel];
      CHECK(panel.series[channel].y[k] == doctest::Approx(albedo * (2 / pi * c + 0.1)).epsilon(1e-4));
    }
  }
}

TEST_CASE("spheres: a coloured light colours a grey material") {
  Light light = directional(0, 0, 1);
  light.colour = {{1, 0.5, 0}, true};
  const auto found = radiance(build(MaterialDescription(lambert(1.0))), {light}, {{0, 0}}, 1, 1);
  REQUIRE(found.size() == 3);
  CHECK(found[0] == doctest::Approx(1 / pi));
  CHECK(found[1] == doctest::Approx(0.5 / pi));
  CHECK(found[2] == 0);
}

TEST_CASE("spheres: the same on any number of threads") {
  const std::vector<Light> lights = {sphere_light(0.8, 2, 0.2, 1), directional(1, 0, 1)};
  const Panel one = panel_of(anisotropic(), lights, 64, 1, 1), four = panel_of(anisotropic(), lights, 64, 1, 4);
  CHECK(one.picture->bytes == four.picture->bytes);
  CHECK(one.series[0].y == four.series[0].y);
}

TEST_CASE("spheres: a light that no number of points resolves is an error") {
  CHECK_THROWS_AS(panel_of(test::describe("ggx", 0.001), {sphere_light(0.5, 0, 1.2, 1)}, 16), AccuracyError);
}
