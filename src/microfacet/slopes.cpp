#include "microfacet/slopes.hpp"

namespace brdfplot {

std::vector<ParameterSpec> SlopeMap::parameters() {
  const Bounds positive{.min = 0, .open_min = true};
  return {{.key = "alpha", .bounds = positive, .doc = "roughness of an isotropic surface"},
          {.key = "alpha_x", .bounds = positive, .doc = "roughness along x"},
          {.key = "alpha_y", .bounds = positive, .doc = "roughness along y"},
          {.key = "correlation",
           .bounds = {.min = -1, .max = 1, .open_min = true, .open_max = true},
           .fallback = 0.0,
           .doc = "correlation r_xy of the slopes (Heitz 2014, Eq. 88)"},
          {.key = "mean_slope",
           .kind = ParameterKind::vec2,
           .fallback = Vec2{0, 0},
           .doc = "[x, y] slope of the mesosurface (Heitz 2014, Eq. 94)"}};
}

SlopeMap SlopeMap::from(const Values& values) {
  SlopeMap map;
  map.alpha_x = values.number(values.has("alpha") ? "alpha" : "alpha_x");
  map.alpha_y = values.number(values.has("alpha") ? "alpha" : "alpha_y");
  map.correlation = values.number("correlation");
  const Vec2 mean = values.vec2("mean_slope");
  map.mean_x = mean[0];
  map.mean_y = mean[1];
  return map;
}

} // namespace brdfplot
