#include "microfacet/distributions/isotropic/velvet.hpp"

#include "microfacet/distributions/ggx.hpp"
#include "microfacet/distributions/inverse_gaussian.hpp"

namespace brdfplot {

ModelSpec VelvetProfile::spec() {
  ModelSpec spec{.type = "velvet",
                 .doc = "inverted Gaussian on a uniform base; Lambda exact",
                 .source = "Ashikhmin et al. 2000; Neubelt and Pettineo 2013; Akenine-Moller et al. 2018, Eq. 9.73",
                 .parameters =
                     isotropic_roughness({.min = 1e-6, .max = 1e6}, "width of the inverted Gaussian, as cot theta_m"),
                 .alternatives = {{"alpha"}, {"roughness"}}};
  spec.parameters.push_back({.key = "amplitude",
                             .bounds = {.min = 0, .max = 1e6},
                             .fallback = 4.0,
                             .doc = "k_amp, of the inverted Gaussian over the base"});
  return spec;
}

VelvetProfile VelvetProfile::from(const Values& values) {
  const double alpha = alpha_from(values);
  const double ratio = values.number("amplitude") * alpha * alpha;
  return {alpha, 1 / (1 + ratio), ratio / (1 + ratio)};
}

double VelvetProfile::p22(double r2) const {
  const double alpha2 = alpha * alpha;
  return base * GgxShape::density(r2) + inverted * InverseGaussianShape::density(r2 * alpha2) * alpha2;
}

double VelvetProfile::density(double sin2, double z) const {
  const double alpha2 = alpha * alpha;
  return base * std::numbers::inv_pi + inverted * InverseGaussianShape::scaled_density(sin2 * alpha2, z * z) * alpha2;
}

double VelvetProfile::a_lambda(double a) const {
  const double cot = a * width();
  return (base * GgxShape::a_lambda(cot) + inverted / alpha * InverseGaussianShape::a_lambda(alpha * cot)) / width();
}

} // namespace brdfplot
