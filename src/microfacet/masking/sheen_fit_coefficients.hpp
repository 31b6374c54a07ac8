/// \file
/// The published fit of the masking of `sheen`.
#pragma once

namespace brdfplot {

/// L(x) = a / (1 + b x^power) + d x + e for a roughness r, between those of r = 0 and r = 1 (Estevez and Kulla 2017):
/// Lambda is e^L(c) for a cosine c below 1/2, and e^(2 L(1/2) - L(1 - c)) above.
struct SheenFitCoefficients {
  double a, b, power, d, e;

  explicit SheenFitCoefficients(double r) {
    const double t = (1 - r) * (1 - r);
    const auto mix = [t](double at_0, double at_1) { return t * at_0 + (1 - t) * at_1; };
    a = mix(25.3245, 21.5473), b = mix(3.32435, 3.82987), power = mix(0.16801, 0.19823);
    d = mix(-1.27393, -1.97760), e = mix(-4.85967, -4.32054);
  }
};

} // namespace brdfplot
