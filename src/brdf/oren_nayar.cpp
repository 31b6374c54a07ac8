#include "brdf/oren_nayar.hpp"

#include <numbers>

namespace brdfplot {

kernels::FlatTerm oren_nayar_term(OrenNayarFit fit) {
  return fit == OrenNayarFit::qualitative ? kernels::FlatTerm::oren_nayar_qualitative : kernels::FlatTerm::oren_nayar;
}

kernels::FlatParameters oren_nayar_parameters(OrenNayarFit fit, double sigma, const Rgb& albedo) {
  const double s = sigma * sigma, rough = s / (s + 0.09);
  kernels::FlatParameters parameters{{1 - 0.5 * s / (s + 0.33), 0.45 * rough, 0.125 * rough, 0.17 * s / (s + 0.13), 0},
                                     {}};
  for (std::size_t c = 0; c < 3; ++c) {
    parameters.factors[c][0] = albedo[c] * std::numbers::inv_pi;
    parameters.factors[c][1] = fit == OrenNayarFit::full ? albedo[c] * albedo[c] * std::numbers::inv_pi : 0;
  }
  return parameters;
}

double oren_nayar_brdf(OrenNayarFit fit, double sigma, const Direction& omega_o, const Direction& omega_i) {
  double value = 0;
  double* const out = &value;
  kernels::flat_brdf(oren_nayar_term(fit), oren_nayar_parameters(fit, sigma, {1, 1, 1}),
                     {&omega_o.x, &omega_o.y, &omega_o.z}, {&omega_i.x, &omega_i.y, &omega_i.z}, false, 1, &out, 1);
  return value;
}

} // namespace brdfplot
