#include "figure/profile/paths.hpp"

#include "base/random.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace brdfplot;
using namespace brdfplot::plot;

constexpr double degree = std::numbers::pi / 180;

} // namespace

TEST_CASE("paths: one facet reflects once, into the mirror direction") {
  const std::vector<Segment> flat = {{0, 0, 1, 0}, {1, 0, 2, 0}};
  const MirrorPath path = mirror_path(flat, 0, 0.25, 40 * degree, 4);
  REQUIRE(path.points.size() == 1);
  CHECK(path.points[0].x == 0.25);
  CHECK(path.theta == doctest::Approx(-40 * degree));
  CHECK_FALSE(path.ended);
}

TEST_CASE("paths: a right angle sends light back from where it came, after two reflections") {
  // A V of facets at 45 degrees.
  const std::vector<Segment> groove = {{0, 1, 1, 0}, {1, 0, 2, 1}};
  for (const double angle : {-20.0, 0.0, 10.0, 20.0}) {
    CAPTURE(angle);
    const MirrorPath path = mirror_path(groove, 0, 0.6, angle * degree, 4);
    REQUIRE(path.points.size() == 2);
    CHECK(std::remainder(path.theta - angle * degree, 2 * std::numbers::pi) == doctest::Approx(0).epsilon(1e-12));
    // The second point lies on the other facet, in the mirror direction of the first.
    CHECK(path.points[1].h == doctest::Approx(path.points[1].x - 1));
  }
  const MirrorPath cut = mirror_path(groove, 0, 0.6, 0, 1);
  CHECK(cut.ended);
  CHECK(cut.points.size() == 1);
}

TEST_CASE("paths: each reflection is that of a mirror, and the way back is the way there") {
  Random random(3, 1);
  std::vector<double> heights;
  for (int k = 0; k < 40; ++k) heights.push_back(3 * random.uniform());
  const auto facets = joined(heights).facets;
  int longer = 0;
  for (std::size_t k = 0; k < facets.size(); ++k) {
    const double theta = (random.uniform() - 0.5) * 100 * degree;
    if (projected_area(facets[k], theta) <= 0) continue;
    const MirrorPath path = mirror_path(facets, k, 0.37, theta, 16);
    if (path.ended || path.points.size() < 2) continue;
    ++longer;
    // From the last point backwards.
    const Meeting& last = path.points.back();
    std::size_t at = 0;
    while (last.x > facets[at].x1) ++at;
    const double fraction = (last.x - facets[at].x0) / (facets[at].x1 - facets[at].x0);
    const MirrorPath back = mirror_path(facets, at, fraction, path.theta, 16);
    // Beyond the first point it goes on where that light would have been stopped on its way in.
    REQUIRE(back.points.size() >= path.points.size());
    for (std::size_t n = 0; n < path.points.size(); ++n) {
      CHECK(back.points[n].x == doctest::Approx(path.points[path.points.size() - 1 - n].x).epsilon(1e-6));
      CHECK(back.points[n].h == doctest::Approx(path.points[path.points.size() - 1 - n].h).epsilon(1e-6));
    }
  }
  CHECK(longer >= 3);
}
