#include "microfacet/slopes.hpp"

namespace brdfplot {

namespace {

constexpr const char* roughness_doc = "r of alpha = r^2 (Burley 2012)";

} // namespace

std::vector<ParameterSpec> SlopeMap::parameters() {
  const Bounds positive{.min = 0, .open_min = true};
  return {{.key = "alpha", .bounds = positive, .doc = "roughness of an isotropic surface"},
          {.key = "alpha_x", .bounds = positive, .doc = "roughness along x"},
          {.key = "alpha_y", .bounds = positive, .doc = "roughness along y"},
          {.key = "roughness", .bounds = positive, .doc = roughness_doc},
          {.key = "disney_anisotropy",
           .bounds = {.min = 0, .max = 1},
           .doc = "k of alpha_x = roughness^2 / q, alpha_y = roughness^2 q, q = sqrt(1 - 0.9 k) (Burley 2012; "
                  "Akenine-Moller et al. 2018, Eq. 9.54)"},
          {.key = "imageworks_anisotropy",
           .bounds = {.min = -1, .max = 1, .open_min = true, .open_max = true},
           .doc = "k of alpha_x = roughness^2 (1 + k), alpha_y = roughness^2 (1 - k) (Kulla and Conty 2017; "
                  "Akenine-Moller et al. 2018, Eq. 9.55)"},
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
  if (values.has("alpha_x")) {
    map.alpha_x = values.number("alpha_x");
    map.alpha_y = values.number("alpha_y");
  } else {
    const double alpha = alpha_from(values);
    const double k = values.has("imageworks_anisotropy") ? values.number("imageworks_anisotropy") : 0;
    const double q = values.has("disney_anisotropy") ? std::sqrt(1 - 0.9 * values.number("disney_anisotropy")) : 1;
    map.alpha_x = alpha * (1 + k) / q;
    map.alpha_y = alpha * (1 - k) * q;
  }
  map.correlation = values.number("correlation");
  const Vec2 mean = values.vec2("mean_slope");
  map.mean_x = mean[0];
  map.mean_y = mean[1];
  return map;
}

std::vector<ParameterSpec> isotropic_roughness(const Bounds& bounds, const std::string& doc) {
  Bounds roots = bounds;
  roots.min = std::sqrt(bounds.min);
  roots.max = std::sqrt(bounds.max);
  return {{.key = "alpha", .bounds = bounds, .doc = doc}, {.key = "roughness", .bounds = roots, .doc = roughness_doc}};
}

double alpha_from(const Values& values) {
  if (values.has("alpha")) return values.number("alpha");
  const double roughness = values.number("roughness");
  return roughness * roughness;
}

} // namespace brdfplot
