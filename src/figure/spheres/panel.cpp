#include "figure/spheres/panel.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "brdf/integrals/reflected_light.hpp"
#include "brdf/integrals/term_albedo.hpp"
#include "draw/number_text.hpp"
#include "figure/series/configuration.hpp"
#include "figure/spheres/radiance.hpp"
#include "figure/spheres/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::plot {

namespace {

/// Points of the diameter in the CSV: the middles of so many equal parts.
constexpr int diameter_points = 100;

Material material_of(const SphereDescription& sphere) {
  Configuration configuration(sphere.material);
  for (const Setting& setting : sphere.at) configuration.set(setting);
  return configuration.surface().material;
}

/// Pixels that the sphere covers, whole or in part.
struct Pixels {
  std::vector<std::size_t> index; ///< in the picture, row by row from the top
  std::vector<double> coverage;
  std::vector<Place> places;
};

Pixels pixels_of(int side) {
  Pixels out;
  const double radius = radius_in_picture * side;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double x = column + 0.5 - 0.5 * side, y = 0.5 * side - row - 0.5;
      const double away = std::hypot(x, y);
      const double coverage = std::clamp(radius - away + 0.5, 0.0, 1.0);
      if (coverage == 0) continue;
      const double shown = coverage < 1 ? 0.5 * (away - 0.5 + radius) : away;
      const double scale = away > 0 ? shown / (away * radius) : 0;
      out.index.push_back(static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
                          static_cast<std::size_t>(column));
      out.coverage.push_back(coverage);
      out.places.push_back({scale * x, scale * y});
    }
  return out;
}

/// -1 + 1 / n ... 1 - 1 / n in units of the radius.
double position_of(int k) { return (2 * k + 1 - diameter_points) / static_cast<double>(diameter_points); }

/// Towards the first light that has a direction; else to the right.
std::vector<Place> diameter(const std::vector<Light>& lights) {
  const auto aimed =
      std::ranges::find_if(lights, [](const Light& light) { return light.type != Light::Type::environment; });
  const double phi = aimed == lights.end() ? 0 : aimed->phi;
  std::vector<Place> out;
  for (int k = 0; k < diameter_points; ++k)
    out.push_back({position_of(k) * std::cos(phi), position_of(k) * std::sin(phi)});
  return out;
}

/// What has been computed of a sphere: radiance of pixels and then of the diameter, channel by channel.
struct Shaded {
  Pixels pixels;
  std::size_t channels = 1, stride = 0;
  std::vector<double> value;

  double operator()(std::size_t channel, std::size_t k) const { return value[channel * stride + k]; }
};

Shaded shade(const SphereDescription& sphere, int threads) {
  const Material material = material_of(sphere);
  Shaded out{pixels_of(sphere.pixels), channels_of(material, sphere.lights), 0, {}};
  std::vector<Place> places = out.pixels.places;
  for (const Place& place : diameter(sphere.lights)) places.push_back(place);
  out.stride = places.size();
  out.value = radiance(material, sphere.lights, places, sphere.exposure, threads);
  return out;
}

Picture picture_of(const SphereDescription& sphere, const Shaded& shaded) {
  const Rgb ground = ground_of(sphere.lights);
  const bool opaque =
      std::ranges::any_of(sphere.lights, [](const Light& light) { return light.type == Light::Type::environment; });
  const std::size_t bytes = shaded.channels + (opaque ? 0 : 1);
  const auto side = static_cast<std::size_t>(sphere.pixels);
  Picture out{sphere.pixels, sphere.pixels, static_cast<int>(shaded.channels), opaque, {}};
  out.bytes.resize(bytes * side * side);
  if (opaque)
    for (std::size_t k = 0; k < out.bytes.size(); ++k) out.bytes[k] = srgb_byte(sphere.exposure * ground[k % bytes]);
  for (std::size_t k = 0; k < shaded.pixels.index.size(); ++k) {
    unsigned char* pixel = &out.bytes[bytes * shaded.pixels.index[k]];
    const double coverage = shaded.pixels.coverage[k];
    for (std::size_t c = 0; c < shaded.channels; ++c)
      pixel[c] = srgb_byte(sphere.exposure * (opaque ? std::lerp(ground[c], shaded(c, k), coverage) : shaded(c, k)));
    if (!opaque) pixel[shaded.channels] = static_cast<unsigned char>(std::lround(255 * coverage));
  }
  return out;
}

std::string percent(double share) { return (share < 0.0005 ? "below 0.1" : decimal_label(100 * share, 1)) + "\u00a0%"; }

/// The share of the sphere's pixels of which a channel is brighter than white.
double share_above_white(const SphereDescription& sphere, const Shaded& shaded) {
  const std::size_t count = shaded.pixels.index.size();
  std::size_t above = 0;
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t c = 0; c < shaded.channels; ++c) {
      // What rounds to white is white.
      if (255 * srgb(sphere.exposure * shaded(c, k)) < 255.5) continue;
      ++above;
      break;
    }
  return static_cast<double>(above) / static_cast<double>(count);
}

std::vector<Series> series_of(const Shaded& shaded) {
  std::vector<Series> out(shaded.channels);
  const std::size_t first = shaded.pixels.index.size();
  for (std::size_t c = 0; c < shaded.channels; ++c) {
    out[c].label = shaded.channels == 1 ? "radiance" : std::string(1, "rgb"[c]);
    for (int k = 0; k < diameter_points; ++k) {
      out[c].x.push_back(position_of(k));
      out[c].y.push_back(shaded(c, first + static_cast<std::size_t>(k)));
    }
  }
  return out;
}

/// What is wrong with a light; the key goes on behind "lights/K/".
std::optional<ParameterError> problem_of(const Light& light) {
  if (light.type == Light::Type::sphere && !(light.radius > 0 && light.radius <= std::numbers::pi / 2))
    return ParameterError{"radius",
                          "found " + format_number(light.radius) + " rad; accepted: an angle above 0 and up to 90deg"};
  if (!(light.theta >= 0 && light.theta <= std::numbers::pi))
    return ParameterError{"theta", "found " + format_number(light.theta) + " rad; accepted: an angle from 0 to 180deg"};
  return std::nullopt;
}

} // namespace

std::optional<ParameterError> problem_of(const SphereDescription& sphere) {
  bool in_environment = false;
  for (std::size_t k = 0; k < sphere.lights.size(); ++k) {
    in_environment = in_environment || sphere.lights[k].type == Light::Type::environment;
    if (auto problem = problem_of(sphere.lights[k]))
      return ParameterError{"lights/" + std::to_string(k) + "/" + problem->key, problem->what};
  }
  const Rgb ground = ground_of(sphere.lights);
  const double brightest = sphere.exposure * std::max({ground[0], ground[1], ground[2]});
  if (brightest > 1)
    return ParameterError{"lights", "the environment is " + format_number(brightest) +
                                        " after the exposure, brighter than white; accepted: up to 1"};
  const Material material = material_of(sphere);
  const SlopeMap& slopes = material.mesosurface();
  if (slopes.mean_x != 0 || slopes.mean_y != 0)
    return ParameterError{"", "a sphere's material has no mean slope; accepted: \"mean_slope\" [0, 0]"};
  for (const WeightedTerm& term : material.terms) {
    if (!in_environment) break;
    if (is_measured(term.term))
      return ParameterError{"lights", "in an environment the albedo of \"" + term.name +
                                          "\", which is measured, is not known closely enough; accepted: a term that "
                                          "is a formula"};
    if (!has_mirror_planes(term))
      return ParameterError{"lights", "in an environment the material is symmetric about x and y, which \"" +
                                          term.name +
                                          "\" is not; accepted: a term that is centred, without "
                                          "correlation, and without a masking formula"};
  }
  return std::nullopt;
}

Panel sphere_panel(const PanelDescription& description, int threads) {
  const SphereDescription& sphere = description.sphere.value();
  if (const auto problem = problem_of(sphere)) throw InputError(problem->key, problem->what);
  const Shaded shaded = shade(sphere, threads);
  for (const double value : shaded.value)
    if (!std::isfinite(value))
      throw AccuracyError("radiance", "found " + format_number(value) + "; accepted: a finite number");
  Panel panel;
  panel.title = description.title;
  panel.x = description.x;
  panel.x.to = 0.5 / radius_in_picture;
  panel.x.from = -panel.x.to;
  panel.y = description.y;
  panel.series = series_of(shaded);
  panel.picture = picture_of(sphere, shaded);
  const double above = share_above_white(sphere, shaded);
  if (above > 0) panel.notes.push_back({percent(above) + " above white", "above_white", above, 0});
  return panel;
}

} // namespace brdfplot::plot
