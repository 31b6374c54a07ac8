/// \file
/// Milliseconds of a lit sphere of 300 x 300 pixels on one thread, of a material of one term: as a picture in sRGB, and
/// with its PNG.
#include "draw/png.hpp"
#include "figure/spheres/panel.hpp"

#include <benchmark/benchmark.h>

#include <numbers>
#include <string>

namespace {

using namespace brdfplot;
using namespace brdfplot::plot;

PanelDescription sphere(const std::string& distribution, const Value& f0, const Light& light) {
  TermDescription term;
  term.name = distribution;
  term.distribution.type = distribution;
  term.distribution.values.set("alpha", 0.3);
  term.fresnel.type = "schlick";
  term.fresnel.values.set("f0", f0);
  PanelDescription out;
  out.sphere = SphereDescription{term, {}, {light}, 1, 300};
  return out;
}

void render(benchmark::State& state, const PanelDescription& description, bool packed) {
  for (auto _ : state) {
    const Panel panel = sphere_panel(description, 1);
    if (packed) benchmark::DoNotOptimize(to_png(*panel.picture));
    benchmark::DoNotOptimize(panel.picture->bytes.data());
  }
}

void add(const std::string& name, const PanelDescription& description) {
  for (const bool packed : {false, true})
    benchmark::RegisterBenchmark((name + (packed ? ", with PNG" : "")).c_str(), [=](benchmark::State& state) {
      render(state, description, packed);
    })->Unit(benchmark::kMillisecond);
}

} // namespace

int main(int argc, char** argv) {
  const Colour white{{1, 1, 1}, false};
  const Light sun{Light::Type::directional, 0.8, 2, 0, white}, ball{Light::Type::sphere, 0.8, 2, 0.2, white},
      furnace{Light::Type::environment, 0, 0, 0, white};
  const Rgb gold{1, 0.7, 0.3};
  for (const char* distribution : {"beckmann", "ggx"}) {
    add(std::string(distribution) + ", grey, directional", sphere(distribution, 0.04, sun));
    add(std::string(distribution) + ", coloured, directional", sphere(distribution, gold, sun));
  }
  add("ggx, coloured, sphere light of 11 degrees", sphere("ggx", gold, ball));
  add("ggx, coloured, environment", sphere("ggx", gold, furnace));
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
