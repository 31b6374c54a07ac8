#include "figure/spheres/radiance.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/interrupt.hpp"
#include "base/threads/parallel.hpp"
#include "brdf/integrals/albedo_table.hpp"
#include "brdf/integrals/reflected_light.hpp"
#include "draw/number_text.hpp"
#include "figure/spheres/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brdfplot::plot {

namespace {

/// In steps of sRGB: what doubling the points of a light may change, and the error of an albedo.
constexpr double accepted_change = 0.25;
constexpr double accepted_albedo = 0.05;
/// While any place changes by more, a highlight may lie between the points, and all places are computed again.
constexpr double coarse_change = 8;
constexpr std::size_t first_rings = 4, most_coarse_rings = 64, most_rings = 256;

/// What reflects light, and on how many threads that is computed.
struct Renderer {
  const Material& material;
  std::size_t channels;
  int threads;

  /// Calls `visit` with blocks of places, and where they begin.
  template <class Visit>
  void for_each_block(const std::vector<Place>& places, const Visit& visit) const {
    constexpr std::size_t size = 1024;
    const std::span<const Place> all(places);
    parallel_for((all.size() + size - 1) / size, threads, [&](std::size_t block) {
      const std::size_t first = block * size;
      Frames frames(all.subspan(first, std::min(size, all.size() - first)));
      visit(first, frames);
    });
  }

  /// The sum of rho c_i over directions with their weights, times the colour.
  std::vector<double> of_points(const std::vector<LightPoint>& points, const Rgb& colour,
                                const std::vector<Place>& places) const {
    std::vector<double> out(channels * places.size());
    for_each_block(places, [&](std::size_t first, Frames& frames) {
      const std::size_t n = frames.size();
      const auto own = static_cast<std::size_t>(material.channels());
      std::vector<double> rho(own * n), sum(own * n);
      for (const LightPoint& point : points) {
        frames.set_light(point.direction);
        evaluate(material, Quantity::brdf_cos, {n, frames.omega_o(), frames.omega_i(), {}}, rho.data());
        for (std::size_t k = 0; k < rho.size(); ++k) sum[k] += point.weight * rho[k];
      }
      for (std::size_t c = 0; c < channels; ++c)
        for (std::size_t k = 0; k < n; ++k)
          out[c * places.size() + first + k] = colour[c] * sum[(own > 1 ? c : 0) * n + k];
    });
    return out;
  }

  /// The albedo times the colour.
  std::vector<double> of_environment(const AlbedoTable& table, const Rgb& colour,
                                     const std::vector<Place>& places) const {
    std::vector<double> out(channels * places.size());
    for_each_block(places, [&](std::size_t first, Frames& frames) {
      for (std::size_t c = 0; c < channels; ++c)
        for (std::size_t k = 0; k < frames.size(); ++k)
          out[c * places.size() + first + k] =
              colour[c] * table.albedo(table.channels() > 1 ? c : 0, frames.omega_o(k));
    });
    return out;
  }
};

/// A sphere light with more and more points, for those places that still change.
class SphereLight {
public:
  SphereLight(const Renderer& renderer, const Light& light, const std::vector<Place>& places, double exposure)
      : renderer_(renderer), light_(light), places_(places), exposure_(exposure), open_(places.size()) {
    std::iota(open_.begin(), open_.end(), std::size_t{0});
  }

  std::vector<double> run() {
    value_ = renderer_.of_points(points_of(light_, first_rings), light_.colour.value, places_);
    for (std::size_t rings = 2 * first_rings;; rings *= 2) {
      const std::vector<double> change = refine(rings);
      const double most = *std::ranges::max_element(change);
      const bool coarse = most > coarse_change;
      if (!coarse) keep_changing(change);
      if (open_.empty()) return value_;
      if (rings >= (coarse ? most_coarse_rings : most_rings)) fail(rings, most);
    }
  }

private:
  [[noreturn]] static void fail(std::size_t rings, double change) {
    throw AccuracyError("sphere light", "with " + std::to_string(4 * rings * rings) + " points it still changes by " +
                                            decimal_label(change, 2) +
                                            " steps of sRGB (accepted: " + decimal_label(accepted_change, 2) +
                                            "); a smaller light or a rougher material needs fewer");
  }

  /// Puts the values of the open places, and tells how far they change, in steps of sRGB.
  std::vector<double> refine(std::size_t rings) {
    std::vector<Place> some;
    for (const std::size_t k : open_) some.push_back(places_[k]);
    const std::vector<double> now = renderer_.of_points(points_of(light_, rings), light_.colour.value, some);
    std::vector<double> change(some.size());
    for (std::size_t k = 0; k < now.size(); ++k) {
      double& before = value_[k / some.size() * places_.size() + open_[k % some.size()]];
      const double steps = 255 * std::fabs(srgb(exposure_ * now[k]) - srgb(exposure_ * before));
      change[k % some.size()] = std::max(change[k % some.size()], steps);
      before = now[k];
    }
    return change;
  }

  void keep_changing(const std::vector<double>& change) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < change.size(); ++k)
      if (change[k] > accepted_change) open_[kept++] = open_[k];
    open_.resize(kept);
  }

  const Renderer& renderer_;
  const Light& light_;
  const std::vector<Place>& places_;
  double exposure_;
  std::vector<std::size_t> open_; ///< places that are not done
  std::vector<double> value_;
};

AlbedoTable albedo_of(const Material& material, double asked) {
  const auto channels = static_cast<std::size_t>(material.channels());
  const auto terms = terms_of(material, "");
  const bool isotropic = std::ranges::all_of(terms, [](const WeightedTerm* term) { return term->is_isotropic(); });
  // The table's error is that of two interpolations and of the integrals.
  const double tolerance = asked / 3;
  AlbedoTable table(
      channels, isotropic,
      [&](const Direction& o) {
        throw_if_interrupted();
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
  return sphere::cap_points(light.theta, light.phi, light.radius, rings);
}

std::vector<double> radiance(const Material& material, const std::vector<Light>& lights,
                             const std::vector<Place>& places, double exposure, int threads) {
  const Renderer renderer{material, channels_of(material, lights), threads};
  std::vector<double> out(renderer.channels * places.size());
  const auto add = [&](const std::vector<double>& more) {
    for (std::size_t k = 0; k < out.size(); ++k) out[k] += more[k];
  };
  for (const Light& light : lights) {
    if (light.type == Light::Type::directional)
      add(renderer.of_points({{from_angles(light.theta, light.phi), 1}}, light.colour.value, places));
    if (light.type == Light::Type::sphere) add(SphereLight(renderer, light, places, exposure).run());
  }
  const Rgb ground = ground_of(lights);
  const double brightest = exposure * std::max({ground[0], ground[1], ground[2]});
  if (brightest > 0)
    add(renderer.of_environment(albedo_of(material, accepted_albedo * finest_step / brightest), ground, places));
  return out;
}

} // namespace brdfplot::plot
