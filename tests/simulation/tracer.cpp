#include "simulation/scenes.hpp"
#include "simulation/tiles.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace test;

namespace {

/// Whether the straight way from a point to above the surface is free, in small steps.
bool free_way(const HeightField& field, const SurfacePoint& from, const Direction& d) {
  const double step = 0.01;
  for (double t = 0.02; from.z + t * d.z <= field.highest(); t += step) {
    const double x = from.x + t * d.x, y = from.y + t * d.y;
    const double wx = x - std::floor(x / field.nx()) * field.nx(), wy = y - std::floor(y / field.ny()) * field.ny();
    if (field.at(wx, wy).z > from.z + t * d.z) return false;
  }
  return true;
}

HeightField small_surface() {
  const Surface made = build_surface(mesh("gaussian", 1, 32, 4));
  Realisation realisation = std::get<GaussianSurface>(made).realise(3, 0);
  return std::move(realisation.fields[0]);
}

} // namespace

TEST_CASE("points of a mesh lie on its facets") {
  const HeightField field(3, 2, {0, 1, 3, 2, 5, 4});
  CHECK(field.at(0, 0).z == 0);
  CHECK(field.at(1, 1).z == 5);
  CHECK(field.at(3, 2).z == 0); // the next period
  CHECK(field.at(0.5, 0.5).z == 1.5F);
  CHECK(field.facet_slope(0, 0, false).x == 1);
  CHECK(field.facet_slope(0, 0, false).y == 2);
  CHECK(field.facet_slope(0, 0, true).x == 3);
  CHECK(field.facet_slope(0, 0, true).y == 4);
  CHECK(field.at(0.25, 0.25).z == 0.75F);
  CHECK(field.at(0.75, 0.75).z == 3.25F);
}

TEST_CASE("shadow rays see what a march along the ray sees, across the border of the period too") {
  const HeightField field = small_surface();
  const Tracer tracer(field);
  Random random(5, 0);
  std::size_t different = 0, seen = 0, all = 0;
  for (const double theta : {30.0, 75.0, 86.0})
    for (const double phi : {0.0, 47.0, 200.0}) {
      const Direction d = from_angles(theta * degree, phi * degree);
      std::vector<SurfacePoint> points;
      while (points.size() < 61) { // not a multiple of the packets
        const SurfacePoint point = field.at(32 * random.uniform(), 32 * random.uniform());
        if (projected_area(point.slope, d) > 0.05) points.push_back(point);
      }
      std::vector<unsigned char> visible(points.size());
      tracer.visible(points, d, visible.data());
      for (std::size_t k = 0; k < points.size(); ++k) {
        different += (visible[k] != 0) != free_way(field, points[k], d) ? 1 : 0;
        seen += visible[k];
        ++all;
      }
    }
  CHECK(different <= 3); // grazing contacts that the steps miss
  CHECK(seen > all / 5);
  CHECK(seen < all * 4 / 5);
}

TEST_CASE("first hits and shadow rays agree") {
  const HeightField field = small_surface();
  const Tracer tracer(field);
  Random random(6, 0);
  for (const double theta : {10.0, 60.0, 85.0}) {
    const Direction d = from_angles(theta * degree, 1);
    std::vector<SurfacePoint> points;
    for (int k = 0; k < 100; ++k)
      points.push_back({static_cast<float>(32 * random.uniform()), static_cast<float>(32 * random.uniform()), 0, {}});
    std::vector<unsigned char> hit(points.size()), visible(points.size());
    tracer.first_hits(points, d, hit.data());
    tracer.visible(points, d, visible.data());
    for (std::size_t k = 0; k < points.size(); ++k) {
      CHECK(hit[k] == 1);
      CHECK(visible[k] == 1);
      CHECK(projected_area(points[k].slope, d) > 0);
    }
  }
}

TEST_CASE("a ray from facet to facet, or away") {
  // A ridge along y: from the middle of one side to the opposite one, and up.
  const HeightField field(2, 2, {0, 1, 0, 1});
  const Tracer tracer(field);
  SurfacePoint point = field.at(0.5, 1);
  CHECK(point.z == 0.5F);
  const Direction across = normalized({-1, 0, 0.25});
  CHECK(tracer.next_hit(point, across) == Tracer::Fate::hit);
  // 0.5 + s / 4 = s - 0.5 after a way s along x: on the side z = -x of the period before, 2 further left.
  CHECK(point.x == doctest::Approx(2 - 5.0 / 6).epsilon(1e-3));
  CHECK(point.z == doctest::Approx(5.0 / 6).epsilon(1e-3));
  CHECK(point.slope.x == -1);
  SurfacePoint top = field.at(0.9, 0.3);
  CHECK(tracer.next_hit(top, {0, 0, 1}) == Tracer::Fate::escaped);
}
