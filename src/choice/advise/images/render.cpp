#include "choice/advise/images/render.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/interrupt.hpp"
#include "base/threads/parallel.hpp"
#include "brdf/evaluate.hpp"
#include "choice/advise/draft.hpp"
#include "choice/advise/single.hpp"
#include "sampling/sphere/cap_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace brdfplot::choice {

namespace {

using std::numbers::pi;

bool has_lobe(const TermDescription& term) { return term.type == "mirror" || term.type == "kelemen"; }

/// A material of one term and of what it depends on: its coats and the term that it is of.
MaterialDescription alone(const MaterialDescription& material, const TermDescription& term) {
  MaterialDescription out(material.name, {}, true);
  for (const TermDescription& other : material.terms) {
    const bool coat = std::ranges::any_of(term.layers, [&](const auto& layer) { return layer.coat == other.name; });
    if (&other == &term || coat || other.name == term.of_name) out.terms.push_back(other);
  }
  return out;
}

/// sqrt(alpha_x alpha_y) of the lobe of a term.
double alpha_of(const Material& material, const std::string& term) {
  const Distribution* facets = terms_of(material, term)[0]->facets();
  const SlopeMap map = std::visit([](const auto& d) { return d.slopes; }, *facets);
  return std::sqrt(map.alpha_x * map.alpha_y);
}

/// Adds rho c_i of one term under directions of light.
class TermLight {
public:
  TermLight(const Material& material, const TermDescription& term, Precision precision,
            std::span<const sphere::Place> places)
      : material_(material), term_(term.name), frames_(places),
        channels_(static_cast<std::size_t>(channels_of(material, Quantity::brdf_cos, term.name))),
        rho_(channels_ * frames_.size()), out_(3 * frames_.size()) {
    if (precision == Precision::single) single_.emplace(term);
  }

  void add(const Direction& light, double weight, const Rgb& irradiance) {
    frames_.set_light(light);
    add_lit(irradiance, weight);
  }
  void add(std::span<const Direction> lights, double weight, const Rgb& irradiance) {
    frames_.set_lights(lights);
    add_lit(irradiance, weight);
  }
  Picture take() { return std::move(out_); }

private:
  void add_lit(const Rgb& irradiance, double weight) {
    const std::size_t n = frames_.size();
    const Wanted wanted{Quantity::brdf_cos, rho_.data(), term_};
    evaluate(material_, std::span(&wanted, 1), {n, frames_.omega_o(), frames_.omega_i(), {}});
    if (single_) round_to_single();
    for (std::size_t c = 0; c < 3; ++c) {
      const double* from = rho_.data() + (channels_ > 1 ? c : 0) * n;
      const double factor = weight * irradiance[c];
      for (std::size_t k = 0; k < n; ++k) out_[c * n + k] += factor * from[k];
    }
  }

  void round_to_single() {
    const std::size_t n = frames_.size();
    const Columns light = frames_.omega_i();
    for (std::size_t k = 0; k < n; ++k) {
      std::array<double, 3> values{};
      for (std::size_t c = 0; c < channels_; ++c) values[c] = rho_[c * n + k];
      single_->round(frames_.omega_o(k), light[k], values);
      for (std::size_t c = 0; c < channels_; ++c) rho_[c * n + k] = values[c];
    }
  }

  const Material& material_;
  std::string term_;
  sphere::Frames frames_;
  std::size_t channels_;
  std::vector<double> rho_;
  Picture out_;
  std::optional<SingleForm> single_;
};

/// In each place the direction within the disc that is nearest to the mirrored viewer.
std::vector<Direction> nearest_directions(const AdviceLight& light, std::span<const sphere::Place> places) {
  const Direction middle = from_angles(light.theta, light.phi);
  std::vector<Direction> out;
  for (const sphere::Place& place : places) {
    const Direction normal = sphere::frame_at(place).normal;
    const Direction mirrored = reflected({0, 0, 1}, normal);
    const double along = std::clamp(dot(mirrored, middle), -1.0, 1.0);
    const Direction aside = normalized(mirrored + -along * middle);
    out.push_back(along >= std::cos(light.radius) ? mirrored
                                                  : std::cos(light.radius) * middle + std::sin(light.radius) * aside);
  }
  return out;
}

void add_disc_by_points(TermLight& lit, const AdviceLight& light, std::size_t rings) {
  // Radiance of irradiance 1 across the middle: 1 / (pi sin^2 r).
  const double radiance = 1 / (pi * std::pow(std::sin(light.radius), 2));
  for (const auto& point : sphere::cap_points(light.theta, light.phi, light.radius, rings)) {
    throw_if_interrupted();
    lit.add(point.direction, point.weight * radiance, light.irradiance.value);
  }
}

/// Of some places.
Picture part_of_picture(const Material& built, const TermDescription& term, const std::vector<AdviceLight>& lights,
                        const LightModel& model, Precision precision, std::span<const sphere::Place> places) {
  TermLight lit(built, term, precision, places);
  for (const AdviceLight& light : lights) {
    const bool disc = light.radius > 0 && model.kind != LightModel::Kind::punctual;
    if (disc && model.kind == LightModel::Kind::points) {
      add_disc_by_points(lit, light, model.rings);
    } else if (disc && has_lobe(term)) {
      const double alpha = alpha_of(built, term.name);
      const double widened = alpha + 0.5 * std::sin(light.radius);
      lit.add(nearest_directions(light, places), std::pow(alpha / widened, 2), light.irradiance.value);
    } else {
      lit.add(from_angles(light.theta, light.phi), 1, light.irradiance.value);
    }
  }
  return lit.take();
}

} // namespace

Picture Renderer::term_picture(const MaterialDescription& material, const TermDescription& term,
                               const LightModel& model, int threads, Precision precision) const {
  const Material built = build(alone(material, term));
  const std::size_t n = places_.at.size();
  constexpr std::size_t block = 512;
  Picture out(3 * n);
  parallel_for((n + block - 1) / block, threads, [&](std::size_t k) {
    const std::size_t first = k * block, count = std::min(block, n - first);
    const auto some = std::span(places_.at).subspan(first, count);
    const Picture part = part_of_picture(built, term, lights_, model, precision, some);
    for (std::size_t c = 0; c < 3; ++c)
      std::copy_n(part.begin() + static_cast<std::ptrdiff_t>(c * count), count,
                  out.begin() + static_cast<std::ptrdiff_t>(c * n + first));
  });
  return out;
}

Picture Renderer::picture(const MaterialDescription& material, const LightModel& model, bool remember, int threads,
                          Precision precision) {
  Picture sum(3 * places_.at.size());
  const std::string by = std::string(precision == Precision::single ? "single:" : "") +
                         std::to_string(static_cast<int>(model.kind)) + ':' + std::to_string(model.rings) + ':';
  for (const TermDescription& term : material.terms) {
    const std::string key = by + identity_of(alone(material, term)) + term.name;
    std::optional<Picture> one;
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = known_.find(key); found != known_.end()) one = found->second;
    }
    if (!one) one = term_picture(material, term, model, threads, precision);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += (*one)[k];
    if (!remember) continue;
    const std::lock_guard lock(mutex_);
    known_.emplace(key, std::move(*one));
  }
  return sum;
}

std::size_t rings_for(Renderer& renderer, const MaterialDescription& material, const AdviceScene& scene) {
  const double accepted = scene.tolerance.metric == Metric::delta_e ? 0.1 : 1e-3;
  if (std::ranges::none_of(scene.lights, [](const AdviceLight& light) { return light.radius > 0; })) return 4;
  const auto with = [&](std::size_t rings) {
    return renderer.picture(material, {LightModel::Kind::points, rings}, false, renderer.threads());
  };
  Picture last = with(4);
  for (std::size_t rings = 8;; rings *= 2) {
    Picture finer = with(rings);
    const PictureErrors change = compare(finer, last, renderer.places(), scene.tolerance.metric, scene.exposure);
    last = std::move(finer);
    if (change.decisive() < accepted) return rings;
    if (rings >= 64)
      throw AccuracyError(material.name, "with " + std::to_string(4 * rings * rings) +
                                             " directions for each disc of light the picture still changes by " +
                                             format_number(change.decisive()) +
                                             " (accepted: " + format_number(accepted) +
                                             "); a smaller disc or a rougher material needs fewer");
  }
}

} // namespace brdfplot::choice
