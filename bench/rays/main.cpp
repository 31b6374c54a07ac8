/// \file
/// Rays a second on a Gaussian surface of 2048 by 2048 cells with alpha = 0.6 (correlation length 16 cells), by all
/// threads, each the median of five measurements; by the clock, and by the time of the processors, which other programs
/// disturb less:
///
/// - coherent shadow rays: from points at random in the cells, row by row, all towards one direction at 60 degrees; as
///   the measures of masking and shadowing trace them, without the making of the points;
/// - incoherent rays: from points at random over the whole surface, in directions with a cosine distribution about the
///   vertical; to the next facet, which costs more than to know whether there is one;
/// - paths: a lobe of Heitz 2014, Fig. 11, from 10^7 paths to their end, seconds in all.
#include "base/threads/parallel.hpp"
#include "simulation/measures/measure.hpp"
#include "simulation/surface.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numbers>
#include <vector>

namespace {

using namespace brdfplot;
using namespace brdfplot::simulation;

constexpr int side = 2048;

ModelChoice gaussian() {
  ModelChoice choice{.type = "gaussian", .values = {}};
  choice.values.set("alpha", 0.6);
  choice.values.set("samples", static_cast<double>(side));
  return choice;
}

struct Seconds {
  double clock = 0;
  double processor = 0; ///< of all threads, over their number
};

Seconds seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t used = std::clock(); // of the whole process
  work();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC / hardware_threads()};
}

/// Work on many rows by all threads: millions of rays a second.
void print_rate(const char* name, std::size_t rows, std::size_t rays_a_row,
                const std::function<void(std::size_t)>& row) {
  std::array<double, 5> by_clock{}, by_processor{};
  for (std::size_t k = 0; k < by_clock.size(); ++k) {
    const Seconds seconds = seconds_of([&] { parallel_for(rows, hardware_threads(), row); });
    const double millions = static_cast<double>(rows * rays_a_row) / 1e6;
    by_clock[k] = millions / seconds.clock;
    by_processor[k] = millions / seconds.processor;
  }
  std::ranges::sort(by_clock);
  std::ranges::sort(by_processor);
  std::printf("%-22s %8.2f M/s by the clock (%.2f to %.2f) %8.2f by processor time\n", name, by_clock[2], by_clock[0],
              by_clock[4], by_processor[2]);
}

void coherent(const HeightField& field, const Tracer& tracer) {
  const Direction direction = from_angles(std::numbers::pi / 3, 0.7);
  // Blocks of 4 by 2, as for_random_places() makes them.
  std::vector<SurfacePoint> points;
  Random random(1, 1);
  for (int y = 0; y < side; y += 2)
    for (int x = 0; x < side; x += 4)
      for (int lane = 0; lane < 8; ++lane) {
        const SurfacePoint point = field.at(x + lane % 4 + random.uniform(), y + lane / 4 + random.uniform());
        if (projected_area(point.slope, direction) > 0) points.push_back(point);
      }
  constexpr std::size_t bunch = 4096;
  const std::size_t rows = points.size() / bunch;
  std::vector<unsigned char> visible(points.size());
  print_rate("coherent shadow rays", rows, bunch, [&](std::size_t row) {
    tracer.visible(std::span(points).subspan(row * bunch, bunch), direction, visible.data() + row * bunch);
  });
}

void incoherent(const HeightField& field, const Tracer& tracer) {
  constexpr std::size_t rows = 256, bunch = 8192;
  struct Ray {
    SurfacePoint point;
    Direction direction;
  };
  std::vector<Ray> rays;
  Random random(1, 2);
  while (rays.size() < rows * bunch) {
    const SurfacePoint point = field.at(side * random.uniform(), side * random.uniform());
    const Direction direction =
        from_angles(std::acos(std::sqrt(random.uniform())), 2 * std::numbers::pi * random.uniform());
    if (projected_area(point.slope, direction) > 0) rays.push_back({point, direction});
  }
  print_rate("incoherent rays", rows, bunch, [&](std::size_t row) {
    for (std::size_t k = row * bunch; k < (row + 1) * bunch; ++k) {
      SurfacePoint point = rays[k].point;
      (void)tracer.next_hit(point, rays[k].direction);
    }
  });
}

void paths() {
  SceneDescription scene{"", gaussian(), 1, 1, {}};
  MeasureDescription lobe;
  lobe.id = lobe.type = "lobe";
  lobe.theta_o = {1.0};
  lobe.rays = 1e7;
  scene.measures = {lobe};
  TraceCounts counts;
  const Seconds seconds = seconds_of([&] { counts = simulate(scene, {hardware_threads(), {}, false}).counts; });
  std::printf("%-22s %8.1f s by the clock %26.1f by processor time; %llu rays, the surface made\n", "10^7 paths",
              seconds.clock, seconds.processor, static_cast<unsigned long long>(counts.coherent + counts.incoherent));
}

} // namespace

int main() {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  start_embree();
  std::printf("%d threads\n", hardware_threads());
  const Realisation surface = std::visit([](const auto& s) { return s.realise(1, 0); }, build_surface(gaussian()));
  const HeightField& field = surface.fields[0];
  const Tracer tracer(field);
  coherent(field, tracer);
  incoherent(field, tracer);
  paths();
  return 0;
}
