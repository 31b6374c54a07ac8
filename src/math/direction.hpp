/// \file
/// Directions as unit vectors, and the symbols used everywhere.
///
/// | symbol  | meaning                                             | source             |
/// | ------- | --------------------------------------------------- | ------------------ |
/// | omega_o | direction towards the viewer                        | Heitz 2014, Tab. 1 |
/// | omega_i | direction towards the light                         | Heitz 2014, Tab. 1 |
/// | omega_h | half vector of omega_o and omega_i                  | Heitz 2014, Tab. 1 |
/// | omega_m | normal of a microfacet                              | Heitz 2014, Tab. 1 |
/// | omega_g | normal of the geometric surface, (0, 0, 1)          | Heitz 2014, Tab. 1 |
/// | D, P22  | distribution of normals (1/sr), of slopes           | Heitz 2014, Eq. 64 |
/// | Lambda  | Smith's auxiliary function; G1 = 1 / (1 + Lambda)   | Heitz 2014, Eq. 43 |
/// | c       | projected area of the mesosurface; cos theta when the distribution is centred | section 5.5 |
/// | s       | projected roughness alpha_o sin theta (Eq. 97); a = c / s | Eq. 96       |
/// | sigma   | projected area of the microsurface, c (1 + Lambda)  | Eq. 41             |
#pragma once

#include <cmath>

namespace brdfplot {

/// A vector; where the text says direction, of unit length. Right-handed, z along omega_g.
struct Direction {
  double x;
  double y;
  double z;
};

inline double dot(const Direction& u, const Direction& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }

inline Direction operator+(const Direction& u, const Direction& v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }

inline Direction operator*(double k, const Direction& v) { return {k * v.x, k * v.y, k * v.z}; }

/// v / |v|, safe for the whole range of doubles (subnormal and huge components included). The zero vector stays zero.
inline Direction normalized(const Direction& v) {
  const double scale = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
  if (!(scale > 0)) return {0, 0, 0};
  int exponent = 0;
  std::frexp(scale, &exponent);
  const Direction w{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
  return (1 / std::sqrt(dot(w, w))) * w;
}

/// (cos phi sin theta, sin phi sin theta, cos theta), angles in radians (Heitz 2014, Table 1). A negative theta is the
/// direction on the other side of the normal.
inline Direction from_angles(double theta, double phi) {
  const double sin_theta = std::sin(theta);
  return {std::cos(phi) * sin_theta, std::sin(phi) * sin_theta, std::cos(theta)};
}

/// omega_h, the normalised sum. When omega_i = -omega_o there is none: the zero vector.
inline Direction half_vector(const Direction& omega_o, const Direction& omega_i) {
  return normalized(omega_o + omega_i);
}

/// omega_o mirrored at the plane with normal omega_m: 2 (o.m) m - o.
inline Direction reflected(const Direction& omega_o, const Direction& omega_m) {
  return (2 * dot(omega_o, omega_m)) * omega_m + -1.0 * omega_o;
}

} // namespace brdfplot
