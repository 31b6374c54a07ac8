#include "figure/spheres/radiance.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/parallel.hpp"
#include "brdf/albedo_table.hpp"
#include "brdf/reflected_light.hpp"
#include "figure/spheres/srgb.hpp"

#include <boost/math/special_functions/legendre.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::plot {

namespace {

constexpr double pi = std::numbers::pi;

/// Parts of a step of sRGB: what doubling the points of a light may change, and the error of an albedo.
constexpr double accepted_change = 0.25;
constexpr double accepted_albedo = 0.05;
constexpr std::size_t first_rings = 4, most_rings = 64;

/// Nodes and weights of Gauss and Legendre on [0, 1].
struct UnitRule {
  std::vector<double> x, weight;
};

UnitRule gauss_legendre(std::size_t n) {
  UnitRule rule;
  const auto degree = static_cast<int>(n);
  for (const double zero : boost::math::legendre_p_zeros<double>(degree)) {
    const double slope = boost::math::legendre_p_prime(degree, zero);
    for (const double x : {-zero, zero}) {
      rule.x.push_back(0.5 * (1 + x));
      rule.weight.push_back(1 / ((1 - x) * (1 + x) * slope * slope)); // n is even: no node is 0
    }
  }
  return rule;
}

/// Radiance of places from lights, block by block.
class Renderer {
public:
  Renderer(const Material& material, const std::vector<Place>& places, std::size_t channels, int threads)
      : material_(material), places_(places), channels_(channels), threads_(threads) {}

  /// Adds rho c_i times the weights of directions to `out`.
  void add(const std::vector<LightPoint>& points, const Rgb& colour, std::vector<double>& out) const {
    for_each_block([&](std::size_t first, Frames& frames) {
      const std::size_t n = frames.size();
      const auto own = static_cast<std::size_t>(material_.channels());
      std::vector<double> rho(own * n), sum(own * n);
      for (const LightPoint& point : points) {
        if (!frames.set_light(point.direction)) continue;
        evaluate(material_, Quantity::brdf_cos, {n, frames.omega_o(), frames.omega_i(), {}}, rho.data());
        for (std::size_t k = 0; k < rho.size(); ++k) sum[k] += point.weight * rho[k];
      }
      for (std::size_t c = 0; c < channels_; ++c)
        for (std::size_t k = 0; k < n; ++k)
          out[c * places_.size() + first + k] += colour[c] * sum[(own > 1 ? c : 0) * n + k];
    });
  }

  void add_environment(const AlbedoTable& table, const Rgb& colour, std::vector<double>& out) const {
    for_each_block([&](std::size_t first, Frames& frames) {
      for (std::size_t c = 0; c < channels_; ++c)
        for (std::size_t k = 0; k < frames.size(); ++k)
          out[c * places_.size() + first + k] +=
              colour[c] * table.albedo(table.channels() > 1 ? c : 0, frames.omega_o(k));
    });
  }

private:
  template <class Visit>
  void for_each_block(const Visit& visit) const {
    constexpr std::size_t size = 1024;
    parallel_for((places_.size() + size - 1) / size, threads_, [&](std::size_t block) {
      const std::size_t first = block * size;
      const std::span<const Place> all(places_);
      Frames frames(all.subspan(first, std::min(size, all.size() - first)));
      visit(first, frames);
    });
  }

  const Material& material_;
  const std::vector<Place>& places_;
  std::size_t channels_;
  int threads_;
};

/// The largest difference as it is shown, in steps of sRGB.
double most_steps(const std::vector<double>& a, const std::vector<double>& b, double exposure) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    most = std::max(most, 255 * std::fabs(srgb(exposure * a[k]) - srgb(exposure * b[k])));
  return most;
}

std::vector<double> of_sphere_light(const Renderer& renderer, const Light& light, std::size_t count, double exposure) {
  const auto with = [&](std::size_t rings) {
    std::vector<double> out(count);
    renderer.add(points_of(light, rings), light.colour.value, out);
    return out;
  };
  std::vector<double> before = with(first_rings);
  double change = 0;
  for (std::size_t rings = 2 * first_rings; rings <= most_rings; rings *= 2) {
    std::vector<double> now = with(rings);
    change = most_steps(before, now, exposure);
    if (change <= accepted_change) return now;
    before = std::move(now);
  }
  throw AccuracyError("sphere light", "with " + std::to_string(4 * most_rings * most_rings) +
                                          " points it still changes by " + format_number(change) +
                                          " steps of sRGB (accepted: " + format_number(accepted_change) +
                                          "); a smaller light or a rougher material needs fewer");
}

AlbedoTable albedo_of(const Material& material, double asked) {
  const auto channels = static_cast<std::size_t>(material.channels());
  const auto terms = terms_of(material, "");
  const bool isotropic = std::ranges::all_of(terms, [](const WeightedTerm* term) { return term->is_isotropic(); });
  // The table's error is that of two interpolations and of the integrals.
  const double tolerance = asked / 3;
  AlbedoTable table(
      channels, isotropic,
      [&](const Direction& o) {
        return reflected_light(terms, o, 0.1 * tolerance, {0, channels}, every_direction);
      },
      tolerance);
  if (!(table.error() <= asked))
    throw AccuracyError("environment", "reached an error of " + format_number(table.error()) +
                                           " in the albedo (asked: " + format_number(asked) + ")");
  return table;
}

} // namespace

std::size_t channels_of(const Material& material, const std::vector<Light>& lights) {
  const bool coloured = std::ranges::any_of(lights, [](const Light& light) { return light.colour.is_rgb; });
  return coloured ? 3 : static_cast<std::size_t>(material.channels());
}

Rgb ground_of(const std::vector<Light>& lights) {
  Rgb sum{};
  for (const Light& light : lights)
    for (std::size_t c = 0; c < 3 && light.type == Light::Type::environment; ++c) sum[c] += light.colour.value[c];
  return sum;
}

std::vector<LightPoint> points_of(const Light& light, std::size_t rings) {
  const Direction middle = from_angles(light.theta, light.phi);
  const Direction down = from_angles(light.theta + pi / 2, light.phi),
                  side{-std::sin(light.phi), std::cos(light.phi), 0};
  const double height = 2 * std::pow(std::sin(light.radius / 2), 2); // 1 - cos(radius)
  const UnitRule rule = gauss_legendre(rings);
  const std::size_t around = 4 * rings;
  std::vector<LightPoint> out;
  for (std::size_t j = 0; j < rings; ++j) {
    const double drop = rule.x[j] * height; // 1 - cos(angle from the middle)
    const double sine = std::sqrt(drop * (2 - drop));
    for (std::size_t k = 0; k < around; ++k) {
      const double azimuth = 2 * pi * (static_cast<double>(k) + 0.5) / static_cast<double>(around);
      out.push_back({(1 - drop) * middle + (sine * std::cos(azimuth)) * down + (sine * std::sin(azimuth)) * side,
                     2 * pi * height * rule.weight[j] / static_cast<double>(around)});
    }
  }
  return out;
}

std::vector<double> radiance(const Material& material, const std::vector<Light>& lights,
                             const std::vector<Place>& places, double exposure, int threads) {
  const std::size_t channels = channels_of(material, lights);
  const Renderer renderer(material, places, channels, threads);
  std::vector<double> out(channels * places.size());
  for (const Light& light : lights) {
    if (light.type == Light::Type::directional)
      renderer.add({{from_angles(light.theta, light.phi), 1}}, light.colour.value, out);
    if (light.type != Light::Type::sphere) continue;
    const std::vector<double> own = of_sphere_light(renderer, light, out.size(), exposure);
    for (std::size_t k = 0; k < out.size(); ++k) out[k] += own[k];
  }
  const Rgb ground = ground_of(lights);
  const double brightest = exposure * std::max({ground[0], ground[1], ground[2]});
  if (brightest > 0)
    renderer.add_environment(albedo_of(material, accepted_albedo * finest_step / brightest), ground, out);
  return out;
}

} // namespace brdfplot::plot
