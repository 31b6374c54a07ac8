#include "microfacet/distributions/exponential_power.hpp"

#include "base/number.hpp"
#include "microfacet/remembered.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <numbers>

namespace brdfplot {

ModelSpec ExponentialPowerShape::about() {
  return {.type = "exponential_power",
          .doc = "slopes exp(-t^(2p)): p = 1 is Beckmann, less has a sharper peak and a longer tail",
          .source = "Holzschuch and Pacanowski 2017, Eqs. 34-38; Lambda by quadrature",
          .parameters = {{.key = "p", .bounds = {.min = 0.1, .max = 10}, .doc = "power of the squared slope"}}};
}

ExponentialPowerShape ExponentialPowerShape::from(const Values& values) {
  const double p = values.number("p");
  const double log_peak = std::log(p * std::numbers::inv_pi) - boost::math::lgamma(1 / p);
  return remembered<ExponentialPowerShape>(format_number(p), [=] {
    // A share P(1 / p, t2^p) of the ground is within t, P the regularised lower incomplete gamma function.
    const double wider = std::sqrt(std::pow(boost::math::gamma_p_inv(1 / p, 0.5), 1 / p) / std::numbers::ln2);
    return ExponentialPowerShape{p, log_peak, wider,
                                 ALambdaTable([=](double t2) { return log_peak - std::pow(t2, p); })};
  });
}

double ExponentialPowerShape::density(double t2) const { return std::exp(log_peak - std::pow(t2, power)); }

double ExponentialPowerShape::slope_within(double u) const {
  return std::pow(boost::math::gamma_p_inv(1 / power, u), 0.5 / power);
}

double ExponentialPowerShape::scaled_density(double n2, double z2) const {
  const double numerator = density(n2 / z2);
  return numerator > 0 ? numerator / (z2 * z2) : 0;
}

} // namespace brdfplot
