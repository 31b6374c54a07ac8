/// \file
/// Smith's Lambda of any isotropic distribution of slopes, by quadrature.
#pragma once

#include <functional>

namespace brdfplot {

/// ln of a slope density at a squared slope; -infinity where the density is 0. The logarithm, so that a Lambda of
/// 1e-300 has as many digits as one of 1.
using LogDensity = std::function<double(double r2)>;

/// a Lambda(a) for an isotropic density of slopes p(r):
///   a Lambda(a) = 2 int_0^inf p(sqrt(a^2 + t^2)) t (t - a atan(t / a)) dt,
/// Heitz 2014, Eqs. 40-43 in polar slopes r^2 = a^2 + t^2; every term is positive, so nothing cancels. With the density
/// of unit roughness of a shape-invariant distribution, a is that of Eq. 63; with P22 itself, cot theta_o.
/// Domain a >= 0, p r^2 integrable over r. Limits: the mean slope along one axis, int p r^2 dr, times 2 at a = 0; 0 at
/// infinity, and from a = 1e75 on, where Lambda < 1e-149 and a^3 would overflow soon. Relative error about 1e-13.
/// \throws AccuracyError when the estimate is not below 1e-10.
double a_lambda_by_quadrature(const LogDensity& log_density, double a);

} // namespace brdfplot
