#include "analysis/weight_moments.hpp"

#include "analysis/integrals.hpp"
#include "analysis/sampling_parts.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "brdf/evaluate.hpp"
#include "sampling/points.hpp"
#include "sampling/weights.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot {

namespace {

/// pdf (rho c_i / pdf)^power of one channel over lights at a fixed viewer.
class WeightPowers {
public:
  WeightPowers(const Material& material, const PairDensity& density, const Direction& omega_o, int power, int channel)
      : material_(material), density_(density), rows_(omega_o), power_(power),
        channel_(static_cast<std::size_t>(channel)) {}

  void operator()(const std::vector<Direction>& lights, std::vector<double>& out) {
    const Batch batch = rows_.with_lights(lights.size(), [&](std::size_t k) { return lights[k]; });
    brdf_cos_.resize(static_cast<std::size_t>(material_.channels()) * batch.n);
    evaluate(material_, Quantity::brdf_cos, batch, brdf_cos_.data());
    out.resize(batch.n);
    density_(batch.n, batch.o, batch.i, out.data());
    for (std::size_t k = 0; k < batch.n; ++k) {
      const double f = brdf_cos_[channel_ * batch.n + k];
      const double weight = f > underflow_of_densities ? f / out[k] : 0;
      double power = f;
      for (int times = 1; times < power_; ++times) power *= weight;
      out[k] = power;
    }
  }

private:
  const Material& material_;
  const PairDensity& density_;
  ViewerRows rows_;
  int power_;
  std::size_t channel_;
  std::vector<double> brdf_cos_;
};

} // namespace

PairDensity density_of(const Sampler& sampler) {
  return
      [&sampler](std::size_t n, const Columns& o, const Columns& i, double* out) { sampler.densities(n, o, i, out); };
}

Estimate weight_moment(int power, const Material& material, const PairDensity& density, const Direction& omega_o,
                       double tolerance, int channel) {
  const Sampler about(material, "default");
  const std::vector<SamplingPart> parts = parts_of(about, omega_o);
  WeightPowers powers(material, density, omega_o, power, channel);
  Estimate sum;
  std::vector<double> all, own;
  for (const SamplingPart& part : parts) {
    const auto integrand = [&](const std::vector<Direction>& lights, std::vector<double>& out) {
      powers(lights, out);
      if (parts.size() == 1) return;
      all.assign(lights.size(), 0);
      for (const SamplingPart& other : parts) {
        other.densities(lights, own);
        for (std::size_t k = 0; k < lights.size(); ++k) all[k] += own[k];
      }
      part.densities(lights, own);
      for (std::size_t k = 0; k < lights.size(); ++k) out[k] *= all[k] > 0 ? own[k] / all[k] : 0;
    };
    sum.add(part.lit_integral(integrand, tolerance / static_cast<double>(parts.size())));
  }
  return sum;
}

double weight_variance(const Material& material, const Sampler& sampler, const Direction& omega_o, double tolerance,
                       int channel) {
  if (!(sampler.mesosurface().project(omega_o).c > 0)) return 0;
  const PairDensity density = density_of(sampler);
  Estimate square = weight_moment(2, material, density, omega_o, tolerance, channel);
  if (square.value > 1 && square.error > tolerance)
    square = weight_moment(2, material, density, omega_o, tolerance * square.value, channel);
  const double albedo = compute_or_throw(Integral::albedo, material, omega_o, std::fmin(tolerance, 1e-7), channel);
  if (!(square.error <= tolerance * std::fmax(1.0, square.value)))
    throw AccuracyError(material.name, "the variance of the weights has an error of " + format_number(square.error) +
                                           ", more than the tolerance of " + format_number(tolerance));
  return std::fmax(square.value - albedo * albedo, 0.0);
}

double largest_weight(const Material& material, const Sampler& sampler, const Direction& omega_o, int channel) {
  if (!(sampler.mesosurface().project(omega_o).c > 0)) return 0;
  const std::vector<SamplePoint> all = points(PointKind::sobol, 1, 0, 0, 4096);
  const auto first = static_cast<std::size_t>(channel) * all.size();
  WeightedSamples drawn;
  draw(material, sampler, omega_o, all, drawn);
  double largest = 0;
  for (std::size_t k = 0; k < all.size(); ++k) largest = std::fmax(largest, drawn.weights[first + k]);
  draw(material, Sampler(material, "default"), omega_o, all, drawn);
  ViewerRows rows(omega_o);
  const Batch batch = rows.with_lights(all.size(), [&](std::size_t k) { return drawn.lights.view()[k]; });
  std::vector<double> pdf(all.size()), brdf_cos(static_cast<std::size_t>(material.channels()) * all.size());
  sampler.densities(batch.n, batch.o, batch.i, pdf.data());
  evaluate(material, Quantity::brdf_cos, batch, brdf_cos.data());
  for (std::size_t k = 0; k < all.size(); ++k)
    if (brdf_cos[first + k] > underflow_of_densities) largest = std::fmax(largest, brdf_cos[first + k] / pdf[k]);
  return largest;
}

const std::vector<SampledQuantityInfo>& sampled_quantities() {
  static const std::vector<SampledQuantityInfo> all = {
      {SampledQuantity::pdf, "pdf", "density of omega_i by a strategy of sampling (1/sr)"},
      {SampledQuantity::weight_variance, "weight_variance",
       "variance of brdf_cos / pdf over the samples of a strategy"},
      {SampledQuantity::largest_weight, "largest_weight", "largest brdf_cos / pdf of 8192 directions"},
      {SampledQuantity::sampling_cost, "sampling_cost", "estimated multiply-adds of a sample and its weight"},
      {SampledQuantity::variance_times_cost, "variance_times_cost", "weight_variance times sampling_cost"},
  };
  return all;
}

} // namespace brdfplot
