/// \file
/// Diffuse and cloth terms as they are published, one pair of directions at a time in double: what a renderer has. Both
/// directions are above the horizon.
#pragma once

#include "brdf/term.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace brdfplot::transcribed {

using std::numbers::inv_pi;
using std::numbers::pi;

inline Direction half(const Direction& o, const Direction& i) {
  const Direction h = o + i;
  return (1 / std::sqrt(dot(h, h))) * h;
}

inline double pow5(double x) { return x * x * x * x * x; }
inline Rgb times(const Rgb& colour, double s) { return {colour[0] * s, colour[1] * s, colour[2] * s}; }
inline double schlick(double f, double c) { return f + (1 - f) * pow5(1 - c); }

/// By channel.
template <class F>
Rgb each(const F& f) {
  return {f(std::size_t{0}), f(std::size_t{1}), f(std::size_t{2})};
}

struct Lambert {
  Rgb albedo;
  Rgb rho(const Direction&, const Direction&) const { return times(albedo, inv_pi); }
};

struct FresnelLambert {
  Rgb albedo, f0;
  Rgb rho(const Direction&, const Direction& i) const {
    return each([&](std::size_t c) { return (1 - schlick(f0[c], i.z)) * albedo[c] * inv_pi; });
  }
};

struct FresnelLambertHalf {
  Rgb albedo, f0;
  Rgb rho(const Direction& o, const Direction& i) const {
    const double lh = dot(half(o, i), i);
    return each([&](std::size_t c) { return (1 - schlick(f0[c], lh)) * albedo[c] * inv_pi; });
  }
};

inline double through_both(double l, double v) { return (1 - pow5(1 - l)) * (1 - pow5(1 - v)); }

struct Shirley {
  Rgb albedo, f0;
  Rgb rho(const Direction& o, const Direction& i) const {
    const double both = 21 / (20 * pi) * through_both(i.z, o.z);
    return each([&](std::size_t c) { return both * (1 - f0[c]) * albedo[c]; });
  }
};

struct Disney {
  Rgb albedo;
  double roughness, subsurface;
  Rgb rho(const Direction& o, const Direction& i) const {
    const double lh = dot(half(o, i), i), m_l = pow5(1 - i.z), m_v = pow5(1 - o.z);
    const double ss90 = roughness * lh * lh, d90 = 0.5 + 2 * ss90;
    const double f_d = (1 + (d90 - 1) * m_l) * (1 + (d90 - 1) * m_v);
    const double f_s = (1 + (ss90 - 1) * m_l) * (1 + (ss90 - 1) * m_v);
    const double f_ss = (1 / (i.z + o.z) - 0.5) * f_s + 0.5;
    return times(albedo, inv_pi * ((1 - subsurface) * f_d + 1.25 * subsurface * f_ss));
  }
};

struct DisneySheen {
  Rgb color;
  Rgb rho(const Direction& o, const Direction& i) const { return times(color, pow5(1 - dot(half(o, i), i))); }
};

struct Hammon {
  Rgb albedo, f0;
  double alpha;
  Rgb rho(const Direction& o, const Direction& i) const {
    const double facing = 0.5 + 0.5 * dot(o, i), nh = half(o, i).z;
    const double rough = facing * (0.9 - 0.4 * facing) * ((0.5 + nh) / nh), both = 1.05 * through_both(i.z, o.z);
    return each([&](std::size_t c) {
      return albedo[c] * inv_pi * ((1 - alpha) * both * (1 - f0[c]) + alpha * rough + albedo[c] * (0.3641 * alpha));
    });
  }
};

struct VelvetCloth {
  Rgb albedo, f0;
  double alpha, amplitude;
  Rgb rho(const Direction& o, const Direction& i) const {
    const Direction h = half(o, i);
    const double lh = dot(h, i), c2 = h.z * h.z, s2 = 1 - c2, a2 = alpha * alpha;
    const double d = (1 + amplitude * std::exp(-c2 / (a2 * s2)) / (s2 * s2)) / (pi * (1 + amplitude * a2));
    const double cloth = d / (4 * (i.z + o.z - i.z * o.z));
    return each([&](std::size_t c) {
      const double f = schlick(f0[c], lh);
      return (1 - f) * albedo[c] * inv_pi + f * cloth;
    });
  }
};

struct Uncharted2 {
  Rgb albedo;
  double rim, rim_power, inner, inner_power, diffuse;
  Rgb rho(const Direction& o, const Direction&) const {
    return times(albedo, inv_pi * (rim * std::pow(o.z, rim_power) + inner * std::pow(1 - o.z, inner_power) + diffuse));
  }
};

/// As printed, with a scatter of 1.
struct Wrap {
  Rgb albedo;
  double w;
  Rgb rho(const Direction&, const Direction& i) const {
    const double light =
        std::clamp((i.z + w) / (1 + w), 0.0, 1 / (1 + w)) * std::clamp(1 + std::max(i.z, 0.0), 0.0, 1.0);
    return times(albedo, inv_pi * light / i.z);
  }
};

constexpr double k1 = 0.5 - 2 / (3 * pi), k2 = 2.0 / 3 - 28 / (15 * pi);

inline double fujii(double roughness, const Direction& o, const Direction& i) {
  const double s = dot(o, i) - o.z * i.z, t = s > 0 ? std::max(o.z, i.z) : 1;
  return inv_pi / (1 + k1 * roughness) * (1 + roughness * s / t);
}

struct Fujii {
  Rgb albedo;
  double roughness;
  Rgb rho(const Direction& o, const Direction& i) const { return times(albedo, fujii(roughness, o, i)); }
};

struct Eon {
  Rgb albedo;
  double roughness;
  /// E_FON_exact of the authors' shader.
  double once_albedo(double mu) const {
    const double a = 1 / (1 + k1 * roughness), s = std::sqrt(1 - mu * mu);
    const double g = s * (std::acos(mu) - s * mu) + 2.0 / 3 * ((s / mu) * (1 - s * s * s) - s);
    return a + roughness * a * inv_pi * g;
  }
  Rgb rho(const Direction& o, const Direction& i) const {
    const double mean = (1 + k2 * roughness) / (1 + k1 * roughness);
    const double once = fujii(roughness, o, i);
    const double further = (1 - once_albedo(o.z)) * (1 - once_albedo(i.z)) / (1 - mean);
    return each([&](std::size_t c) {
      const double a = albedo[c];
      return a * once + inv_pi * a * a * mean / (1 - a * (1 - mean)) * further;
    });
  }
};

/// As in Mitsuba 0.6, with angles.
struct OrenNayar {
  Rgb albedo;
  double sigma;
  Rgb rho(const Direction& o, const Direction& i) const {
    const double s = sigma * sigma, theta_o = std::acos(o.z), theta_i = std::acos(i.z);
    const double a = std::max(theta_o, theta_i), b = std::min(theta_o, theta_i);
    const double k = (o.x * i.x + o.y * i.y) / (std::sin(theta_o) * std::sin(theta_i));
    const double q = 2 * inv_pi * b, angles = 4 * inv_pi * inv_pi * a * b;
    const double c2 = 0.45 * s / (s + 0.09) * (k >= 0 ? std::sin(a) : std::sin(a) - q * q * q);
    const double c3 = 0.125 * s / (s + 0.09) * angles * angles;
    const double once =
        1 - 0.5 * s / (s + 0.33) + k * c2 * std::tan(b) + (1 - std::fabs(k)) * c3 * std::tan(0.5 * (a + b));
    const double twice = 0.17 * s / (s + 0.13) * (1 - k * q * q);
    return each([&](std::size_t c) { return inv_pi * albedo[c] * (once + albedo[c] * twice); });
  }
};

struct OrenNayarQualitative {
  Rgb albedo;
  double sigma;
  Rgb rho(const Direction& o, const Direction& i) const {
    const double s = sigma * sigma, sin_o = std::sqrt(1 - o.z * o.z), sin_i = std::sqrt(1 - i.z * i.z);
    const double k = std::max(0.0, (o.x * i.x + o.y * i.y) / (sin_o * sin_i));
    const double tan_b = std::min(sin_o, sin_i) / std::max(o.z, i.z);
    return times(albedo,
                 inv_pi * (1 - 0.5 * s / (s + 0.33) + 0.45 * s / (s + 0.09) * k * std::max(sin_o, sin_i) * tan_b));
  }
};

/// Imageworks' sheen, with the authors' fit of Lambda.
struct Sheen {
  double alpha;
  double l(double x) const {
    const double t = (1 - alpha) * (1 - alpha);
    const auto mix = [t](double at_0, double at_1) { return t * at_0 + (1 - t) * at_1; };
    return mix(25.3245, 21.5473) / (1 + mix(3.32435, 3.82987) * std::pow(x, mix(0.16801, 0.19823))) +
           mix(-1.27393, -1.97760) * x + mix(-4.85967, -4.32054);
  }
  double lambda(double c) const { return std::exp(c < 0.5 ? l(c) : 2 * l(0.5) - l(1 - c)); }
  double density(double nh) const { return (2 + 1 / alpha) * std::pow(1 - nh * nh, 0.5 / alpha) / (2 * pi); }
  Rgb rho(const Direction& o, const Direction& i) const {
    const double value = density(half(o, i).z) / ((1 + lambda(o.z) + lambda(i.z)) * 4 * o.z * i.z);
    return {value, value, value};
  }
};

/// The same with the denominator of Eq. 9.74.
struct SheenUnmasked {
  Sheen sheen;
  Rgb rho(const Direction& o, const Direction& i) const {
    const double value = sheen.density(half(o, i).z) / (4 * (i.z + o.z - i.z * o.z));
    return {value, value, value};
  }
};

} // namespace brdfplot::transcribed
