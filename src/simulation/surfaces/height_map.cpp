#include "simulation/surfaces/height_map.hpp"

#include "base/memory.hpp"
#include "base/threads/interrupt.hpp"
#include "simulation/surfaces/image.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace brdfplot::simulation {

ModelSpec HeightMapSurface::spec() {
  const Bounds positive{.min = 0, .open_min = true};
  return {.type = "height_map",
          .doc = "heights from a file",
          .source = "measured or made elsewhere",
          .parameters = {{.key = "file", .kind = ParameterKind::text, .doc = "greyscale PNG (8 or 16 bits) or PFM"},
                         {.key = "height",
                          .bounds = positive,
                          .doc = "PNG: height of white over black; PFM: height of the value 1; in the unit of pitch"},
                         {.key = "pitch", .bounds = positive, .fallback = 1.0, .doc = "distance of two pixels"},
                         {.key = "border",
                          .kind = ParameterKind::choice,
                          .fallback = std::string("periodic"),
                          .doc = "how the surface goes on beyond the file",
                          .choices = {"periodic", "mirror"}}}};
}

HeightMapSurface HeightMapSurface::from(const Values& values) {
  return {values.text("file"), values.number("height"), values.number("pitch"), values.text("border") == "mirror"};
}

Realisation HeightMapSurface::realise(std::uint64_t /*seed*/, std::uint64_t /*realisation*/) const {
  const Image image = read_image(file);
  const int nx = mirror ? 2 * image.width : image.width;
  const int ny = mirror ? 2 * image.height : image.height;
  require_memory(120.0 * nx * ny, "a height map of " + std::to_string(nx) + " by " + std::to_string(ny) +
                                      " heights with what traces it");
  std::vector<float> heights;
  heights.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  double sum = 0, squares = 0;
  for (int iy = 0; iy < ny; ++iy) {
    throw_if_interrupted();
    for (int ix = 0; ix < nx; ++ix) {
      const double value = image.at(std::min(ix, 2 * image.width - 1 - ix), std::min(iy, 2 * image.height - 1 - iy));
      const double h = value * height / pitch;
      heights.push_back(static_cast<float>(h));
      sum += h;
      squares += h * h;
    }
  }
  const auto n = static_cast<double>(heights.size());
  const double mean = sum / n;
  Realisation out{{}, std::sqrt(std::max(squares / n - mean * mean, 0.0)), 0};
  out.fields.emplace_back(nx, ny, std::move(heights));
  return out;
}

} // namespace brdfplot::simulation
