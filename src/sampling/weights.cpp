#include "sampling/weights.hpp"

#include "brdf/evaluate.hpp"

namespace brdfplot {

void draw(const Material& material, const Sampler& sampler, const Direction& omega_o,
          const std::vector<SamplePoint>& points, WeightedSamples& samples) {
  const std::size_t n = points.size();
  sampler.sample(omega_o, points, samples.lights, samples.pdf);
  DirectionArrays viewers;
  viewers.x.assign(n, omega_o.x), viewers.y.assign(n, omega_o.y), viewers.z.assign(n, omega_o.z);
  samples.weights.resize(static_cast<std::size_t>(material.channels()) * n);
  evaluate(material, Quantity::brdf_cos, {n, viewers.view(), samples.lights.view(), {}}, samples.weights.data());
  for (std::size_t first = 0; first < samples.weights.size(); first += n) {
    double* const weights = samples.weights.data() + first;
    for (std::size_t k = 0; k < n; ++k) {
      const double pdf = samples.pdf[k], weight = weights[k] / pdf;
      weights[k] = weights[k] > 0 && pdf > 0 ? weight : 0;
    }
  }
}

} // namespace brdfplot
