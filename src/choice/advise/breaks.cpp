#include "choice/advise/breaks.hpp"

#include "brdf/evaluate.hpp"
#include "choice/advise/images/metric.hpp"
#include "choice/advise/single.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::choice {

namespace {

/// theta_o, phi_o, theta_i, phi_i.
using Angles = std::array<double, 4>;

double angle_from_normal(const Direction& d) { return std::acos(std::clamp(d.z, -1.0, 1.0)); }

MaterialDescription with_roughness(MaterialDescription material, double factor) {
  for (TermDescription& term : material.terms)
    for (const char* key : {"alpha", "alpha_x", "alpha_y"})
      if (term.distribution.values.has(key))
        term.distribution.values.set(key, term.distribution.values.number(key) * factor);
  return material;
}

bool has_tables(const MaterialDescription& material) {
  return std::ranges::any_of(material.terms, [](const TermDescription& term) {
    return !term.of_name.empty() || std::ranges::any_of(term.layers, [](const LayerDescription& layer) {
      return layer.values.has("attenuation") && layer.values.text("attenuation") == "albedo";
    });
  });
}

/// Two materials under one punctual light.
class Pair {
public:
  Pair(const AdviceScene& scene, const MaterialDescription& full, const MaterialDescription& simple)
      : scene_(scene), full_(build(full)), simple_(build(simple)) {}

  double difference(const Angles& at) const {
    const Direction o = from_angles(at[0], at[1]), i = from_angles(at[2], at[3]);
    return choice::difference(scene_.tolerance.metric, radiance(full_, o, i), radiance(simple_, o, i), scene_.exposure);
  }

  Break climbed(Angles at, double alpha_factor) const {
    constexpr double grazing = 89.9 * std::numbers::pi / 180;
    double worst = difference(at);
    for (double step = 0.4; step > 1e-3;) {
      const Angles before = at;
      for (std::size_t k = 0; k < at.size(); ++k)
        for (const double by : {step, -step}) {
          Angles other = before;
          other[k] = k % 2 == 0 ? std::clamp(before[k] + by, 0.0, grazing) : before[k] + by;
          if (const double here = difference(other); here > worst) {
            worst = here;
            at = other;
          }
        }
      if (at == before) step *= 0.5;
    }
    const double azimuth = std::fabs(std::remainder(at[1] - at[3], 2 * std::numbers::pi));
    return {alpha_factor, worst, at[0], at[2], azimuth};
  }

private:
  Rgb radiance(const Material& material, const Direction& o, const Direction& i) const {
    std::array<double, 3> rho{};
    evaluate(material, Quantity::brdf_cos, {1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, {}}, rho.data());
    const bool grey = channels_of(material, Quantity::brdf_cos) == 1;
    Rgb out{};
    for (std::size_t c = 0; c < 3; ++c) out[c] = rho[grey ? 0 : c] * brightest(scene_).irradiance.value[c];
    return out;
  }

  const AdviceScene& scene_;
  Material full_, simple_;
};

/// The worst of a coarse grid over the hemisphere.
std::vector<Angles> worst_of_grid(const Pair& pair, std::size_t count) {
  constexpr double step = std::numbers::pi / 12;
  std::vector<std::pair<double, Angles>> all;
  for (int o = 0; o <= 5; ++o)
    for (int i = 0; i <= 5; ++i)
      for (int phi_o = 0; phi_o < 6; phi_o += 3)
        for (int difference = 0; difference <= 12; difference += 3) {
          const Angles at = {(o + 0.5) * step, phi_o * step, (i + 0.5) * step, (phi_o + difference) * step};
          all.emplace_back(pair.difference(at), at);
        }
  std::ranges::stable_sort(all, [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Angles> out;
  for (std::size_t k = 0; k < count; ++k) out.push_back(all[k].second);
  return out;
}

/// The directions at a place, of the light that differs most there.
Angles start_of(const AdviceScene& scene, const Pair& pair, const sphere::Place& place) {
  Angles best{};
  double worst = -1;
  const std::array<sphere::Place, 1> places = {place};
  sphere::Frames frames(places);
  for (const AdviceLight& light : scene.lights) {
    frames.set_light(from_angles(light.theta, light.phi));
    const Direction o = frames.omega_o(0), i = frames.omega_i()[0];
    if (!(i.z > 0)) continue;
    const Angles at = {angle_from_normal(o), std::atan2(o.y, o.x), angle_from_normal(i), std::atan2(i.y, i.x)};
    if (const double here = pair.difference(at); here > worst) {
      worst = here;
      best = at;
    }
  }
  return best;
}

} // namespace

const AdviceLight& brightest(const AdviceScene& scene) {
  return *std::ranges::max_element(scene.lights, {},
                                   [](const AdviceLight& l) { return luminance(l.irradiance.value); });
}

std::vector<Break> breaks_of(const AdviceScene& scene, const MaterialAdvice& advice) {
  const Model& answer = advice.models[*advice.answer];
  const sphere::Place worst = answer.dense->where;
  const MaterialDescription &full = advice.ladder.variants[0], &simple = answer.materials[0];
  std::vector<Break> out;
  for (const double factor : {1.0, 0.5, 2.0}) {
    if (factor != 1 && (has_tables(full) || has_tables(simple))) continue; // NOLINT(clang-diagnostic-float-equal)
    const Pair pair(scene, with_roughness(full, factor), with_roughness(simple, factor));
    out.push_back(pair.climbed(start_of(scene, pair, worst), factor));
    for (const Angles& start : worst_of_grid(pair, 3))
      if (const Break other = pair.climbed(start, factor); other.difference > out.back().difference) out.back() = other;
  }
  return out;
}

} // namespace brdfplot::choice
