/// \file
/// What shapes share that can sample the slopes seen from a direction (see visible_normals.hpp). A generator is
/// base/random.hpp's, or another with `uniform()` in (0, 1): models need not know it.
#pragma once

#include <cmath>
#include <numbers>

namespace brdfplot {

/// A slope of unit roughness, as seen from the unit vector w in the space of unit roughness. `facing` is the slope
/// along w's azimuth with its sign such that it grows towards w, `across` the one at right angles.
struct UnitSlope {
  double facing;
  double across;
};

/// x with the density e^(-x^2) / sqrt(pi), below which a share u lies: erf^-1(2 u - 1). u in [0, 1); 0 counts as 2^-54.
double gaussian(double u);

/// x >= -c / s with the density proportional to (c + s x) e^(-x^2), below which a share u lies: the visible slopes of a
/// Gaussian profile, seen from a cosine c >= 0 and a sine s >= 0. What lies above is
///   T(x) = (c sqrt(pi) erfc(x) + s e^(-x^2)) / 2,
/// which Heitz and d'Eon (2014) solve for in erf(x), where the tail has no digits; here in x, by Newton's rule for ln T
/// within -c / s (or -9, beyond which nothing is) and sqrt(-ln(1 - u)). Domain u in [0, 1); error of the share < 1e-14.
double visible_gaussian(double c, double s, double u);

/// x with the density proportional to (a + x)+ e^(-x^2): the visible slopes of a Gaussian profile, at any signed a =
/// cot theta. Exact, by rejection; at least a third of the proposals is accepted.
template <class Generator>
double sample_visible_gaussian(double a, Generator& random) {
  const auto exponential = [&] { return -std::log(random.uniform()); };
  for (;;) {
    if (a >= 0) {
      // (a + x)+ <= a + |x|: a Gaussian, or a Rayleigh variable of either sign.
      const bool gaussian = random.uniform() * (1 + a * std::sqrt(std::numbers::pi)) >= 1;
      const double radius = std::sqrt(exponential());
      const double x = radius * (gaussian                 ? std::cos(2 * std::numbers::pi * random.uniform())
                                 : random.uniform() < 0.5 ? 1.0
                                                          : -1.0);
      if (x >= 0 || random.uniform() * (1 - x / a) < 1 + x / a) return x; // a may be infinite
    } else if (a > -0.75) {
      // (a + x)+ <= x beyond -a.
      const double x = std::sqrt(a * a + exponential());
      if (random.uniform() * x < a + x) return x;
    } else {
      // With x = y - a the density is y e^(2 a y) e^(-y^2): a gamma variable, times what is at most 1.
      const double y = (exponential() + exponential()) / (-2 * a);
      if (random.uniform() < std::exp(-y * y)) return y - a;
    }
  }
}

} // namespace brdfplot
