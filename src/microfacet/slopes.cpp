#include "microfacet/slopes.hpp"

#include "base/number.hpp"

#include <algorithm>

namespace brdfplot {

namespace {

/// Of one axis. Kernels hold their bounds from 1e-6 on; beyond 1e6 all facets stand upright to 1e-6 rad.
const Bounds roughnesses{.min = 1e-6, .max = 1e6};
constexpr double largest_ratio = 1e6; ///< of the two axes

constexpr const char* roughness_doc = "r of alpha = r^2 (Burley 2012)";

/// How renderers make alpha of the roughness r that their users set, by name.
struct RoughnessConvention {
  const char* name;
  double (*alpha)(double r);
};

double squared(double r) { return r * r; }

constexpr RoughnessConvention conventions[] = {
    {"gltf", squared},
    {"openpbr", squared},
    {"unreal", squared},
    {"cycles", squared},
    {"disney", [](double r) { return std::max(1e-3, r * r); }},
    {"pbrt", [](double r) { return std::sqrt(r); }},
    {"pbrt_v3", [](double r) {
       const double x = std::log(std::max(r, 1e-3));
       return 1.62142 + x * (0.819955 + x * (0.1734 + x * (0.0171201 + x * 0.000640711)));
     }}};

std::vector<std::string> convention_names() {
  std::vector<std::string> names;
  for (const RoughnessConvention& one : conventions) names.emplace_back(one.name);
  return names;
}

double alpha_by_convention(const std::string& name, double r) {
  return std::ranges::find_if(conventions, [&](const auto& one) { return one.name == name; })->alpha(r);
}

/// The covariance of slopes, from their second moments and their mean.
struct Covariance {
  double xx, yy, xy;
};
Covariance covariance(const Values& values) {
  const Rgb moments = values.rgb("slope_moments");
  const Vec2 mean = values.vec2("mean_slope");
  return {std::fma(-mean[0], mean[0], moments[0]), std::fma(-mean[1], mean[1], moments[1]),
          std::fma(-mean[0], mean[1], moments[2])};
}

/// Moments of single precision, whose covariance may have a negative variance along some axis, are accepted.
std::optional<ParameterError> problem_with_moments(const Values& values) {
  if (values.number("correlation") != 0)
    return ParameterError{"correlation", "found " + format_number(values.number("correlation")) +
                                             " beside \"slope_moments\", which say it; accepted: 0"};
  const Rgb moments = values.rgb("slope_moments");
  const auto [xx, yy, xy] = covariance(values);
  const double least = 0.5 * (xx + yy - std::hypot(xx - yy, 2 * xy));
  if (least >= -1e-6 * (std::fabs(moments[0]) + std::fabs(moments[1]))) return std::nullopt;
  return ParameterError{"slope_moments", "found a variance of " + format_number(least) +
                                             " along some axis; accepted: [E[xx], E[yy], E[xy]] of slopes whose mean "
                                             "is mean_slope"};
}

} // namespace

double toksvig_exponent(double exponent, double length) {
  return length * exponent / (length + exponent * (1 - length));
}

double toksvig_alpha(double alpha, double length) {
  // With alpha^2 = 2 / (n + 2), q = 1 / n = alpha^2 / (2 (1 - alpha^2)), and q' = q + (1 - |N|) / |N|.
  const double wider = (1 - length) / length, rest = (1 - alpha) * (1 + alpha);
  const double numerator = alpha * alpha + 2 * rest * wider; // 2 (1 - alpha^2) q'
  return std::sqrt(numerator / (rest + numerator));
}

ParameterSpec mean_normal_length() {
  return {.key = "mean_normal_length",
          .bounds = {.min = 1e-6, .max = 1},
          .doc = "length of the mean of the normals of a filtered map, which widens the lobe (Toksvig 2005; "
                 "Akenine-Moller et al. 2018, Eq. 9.76)"};
}

std::vector<ParameterSpec> SlopeMap::parameters() {
  const Bounds roots{.min = std::sqrt(roughnesses.min), .max = std::sqrt(roughnesses.max)};
  return {{.key = "alpha", .bounds = roughnesses, .doc = "roughness of an isotropic surface"},
          {.key = "alpha_x", .bounds = roughnesses, .doc = "roughness along x"},
          {.key = "alpha_y", .bounds = roughnesses, .doc = "roughness along y"},
          {.key = "roughness", .bounds = roots, .doc = roughness_doc},
          {.key = "disney_anisotropy",
           .bounds = {.min = 0, .max = 1},
           .doc = "k of alpha_x = roughness^2 / q, alpha_y = roughness^2 q, q = sqrt(1 - 0.9 k) (Burley 2012; "
                  "Akenine-Moller et al. 2018, Eq. 9.54)"},
          {.key = "imageworks_anisotropy",
           .bounds = {.min = -1, .max = 1, .open_min = true, .open_max = true},
           .doc = "k of alpha_x = roughness^2 (1 + k), alpha_y = roughness^2 (1 - k) (Kulla and Conty 2017; "
                  "Akenine-Moller et al. 2018, Eq. 9.55)"},
          {.key = "roughness_convention",
           .kind = ParameterKind::choice,
           .doc =
               "whose roughness it is, in [0.001, 1]: alpha is its square, but for disney at least 0.001, for pbrt its "
               "root, and for pbrt_v3 a polynomial of its logarithm",
           .choices = convention_names()},
          mean_normal_length(),
          {.key = "correlation",
           .bounds = {.min = -1, .max = 1, .open_min = true, .open_max = true},
           .fallback = 0.0,
           .doc = "correlation r_xy of the slopes (Heitz 2014, Eq. 88)"},
          {.key = "mean_slope",
           .kind = ParameterKind::vec2,
           .bounds = {.min = -1e3, .max = 1e3},
           .fallback = Vec2{0, 0},
           .doc = "[x, y] slope of the mesosurface (Heitz 2014, Eq. 94)"}};
}

std::vector<ParameterSpec> SlopeMap::moments() {
  const Bounds bounds{.min = -1e6, .max = 1e6};
  return {{.key = "slope_moments",
           .kind = ParameterKind::vec3,
           .bounds = bounds,
           .doc =
               "[E[xx], E[yy], E[xy]], second moments of the slopes of a filtered normal map whose mean is mean_slope; "
               "alpha is that of the base (LEAN: Olano and Baker 2010; Akenine-Moller et al. 2018, section 9.13.1)"},
          {.key = "slope_variance",
           .bounds = {.min = 0, .max = 1e6},
           .doc = "variance along an axis of the slopes of a filtered normal map, added to alpha^2 / 2 (variance "
                  "mapping: Akenine-Moller et al. 2018, section 9.13.1)"}};
}

SlopeMap SlopeMap::from(const Values& values) {
  SlopeMap map;
  if (values.has("alpha_x")) {
    map.alpha_x = values.number("alpha_x");
    map.alpha_y = values.number("alpha_y");
  } else {
    const double alpha = values.has("roughness_convention")
                             ? alpha_by_convention(values.text("roughness_convention"), values.number("roughness"))
                         : values.has("mean_normal_length")
                             ? toksvig_alpha(values.number("alpha"), values.number("mean_normal_length"))
                         : values.has("slope_variance")
                             ? std::hypot(values.number("alpha"), std::sqrt(2 * values.number("slope_variance")))
                             : alpha_from(values);
    const double k = values.has("imageworks_anisotropy") ? values.number("imageworks_anisotropy") : 0;
    const double q = values.has("disney_anisotropy") ? std::sqrt(1 - 0.9 * values.number("disney_anisotropy")) : 1;
    map.alpha_x = alpha * (1 + k) / q;
    map.alpha_y = alpha * (1 - k) * q;
  }
  map.correlation = values.number("correlation");
  if (values.has("slope_moments")) {
    const auto [xx, yy, xy] = covariance(values);
    const double base = 0.5 * map.alpha_x * map.alpha_x;
    map.alpha_x = std::sqrt(2 * (xx + base));
    map.alpha_y = std::sqrt(2 * (yy + base));
    map.correlation = xy / (std::sqrt(xx + base) * std::sqrt(yy + base));
  }
  const Vec2 mean = values.vec2("mean_slope");
  map.mean_x = mean[0];
  map.mean_y = mean[1];
  return map;
}

std::optional<ParameterError> SlopeMap::problem(const Values& values) {
  const auto outside = [&](const char* key, const Bounds& accepted,
                           const char* beside) -> std::optional<ParameterError> {
    if (accepted.contains(values.number(key))) return std::nullopt;
    return ParameterError{key, "found " + format_number(values.number(key)) + ", accepted beside \"" + beside +
                                   "\": " + accepted.describe()};
  };
  if (values.has("roughness_convention")) return outside("roughness", {.min = 1e-3, .max = 1}, "roughness_convention");
  if (values.has("slope_moments")) return problem_with_moments(values);
  if (values.has("mean_normal_length"))
    return outside("alpha", {.min = roughnesses.min, .max = 1}, "mean_normal_length");
  return std::nullopt;
}

std::optional<ParameterError> SlopeMap::problem() const {
  const auto of_both = [&](const std::string& what) {
    return ParameterError{"", "alpha_x = " + format_number(alpha_x) + " with alpha_y = " + format_number(alpha_y) +
                                  ": found " + what};
  };
  if (!(std::fabs(correlation) < 1))
    return ParameterError{"slope_moments", "found a covariance of correlation " + format_number(correlation) +
                                               "; accepted: in (-1, 1), which a larger alpha of the base makes it"};
  for (const double alpha : {alpha_x, alpha_y})
    if (!roughnesses.contains(alpha)) return of_both(format_number(alpha) + ", accepted: " + roughnesses.describe());
  const double ratio = std::max(alpha_x / alpha_y, alpha_y / alpha_x);
  if (ratio <= largest_ratio * (1 + 1e-12)) return std::nullopt;
  return of_both("a ratio of " + format_number(ratio) + ", accepted: a number in [1, " + format_number(largest_ratio) +
                 "]");
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
