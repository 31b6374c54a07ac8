/// \file
/// What a renderer computes to draw a direction by a strategy: one formula each, for any number type, like
/// forms.hpp. Slopes are those at unit roughness, seen from the cosine c and the sine s.
#pragma once

#include "choice/advise/shader/forms.hpp"

#include <utility>

namespace brdfplot::choice::forms {

/// Towards the viewer, and at right angles to that.
template <class T>
struct UnitSlopes {
  T facing, across;
};

/// r (cos 2 pi u, sin 2 pi u).
template <class T>
std::pair<T, T> polar(const T& r, const T& u) {
  using std::cos;
  using std::sin;
  const T phi = T(2 * std::numbers::pi) * u;
  return {r * cos(phi), r * sin(phi)};
}

/// Lambert's lobe, by the disc below it.
template <class T>
Vector<T> cosine_lobe(const T& u1, const T& u2) {
  using std::sqrt;
  const auto [x, y] = polar(T(sqrt(u1)), u2);
  return {x, y, sqrt(T(1) - u1)};
}

/// The norm of the slopes within which a share u of the ground lies.
template <class T>
T ground_slope_ggx(const T& u) {
  using std::sqrt;
  return sqrt(u / (T(1) - u));
}
template <class T>
T ground_slope_beckmann(const T& u) {
  using std::log;
  using std::sqrt;
  return sqrt(-log(T(1) - u));
}

/// A point of a spherical cap, plus the viewer (Dupuy and Benyoub 2023).
template <class T>
UnitSlopes<T> visible_slopes_ggx(const T& c, const T& s, const T& u1, const T& u2) {
  using std::max;
  using std::sqrt;
  const T z = (T(1) - u2) * (T(1) + c) - c;
  const auto [x, y] = polar(T(sqrt(max(T(0), T(1) - z * z))), u1);
  const T over = T(1) / (z + c);
  return {(x + s) * over, y * over};
}

/// A point of a disc of which half is scaled, raised to the hemisphere (Heitz 2018).
template <class T>
UnitSlopes<T> visible_slopes_ggx_2018(const T& c, const T& s, const T& u1, const T& u2) {
  using std::max;
  using std::sqrt;
  const auto [across, place] = polar(T(sqrt(u1)), u2);
  const T half = T(0.5) * (T(1) + c);
  const T height = (T(1) - half) * sqrt(T(1) - across * across) + half * place;
  const T z = sqrt(max(T(0), T(1) - across * across - height * height));
  const T over = T(1) / (s * height + c * z);
  return {(s * z - c * height) * over, across * over};
}

/// The normal of unit slopes, stretched; (x, y) is the azimuth of the viewer in the space of unit roughness.
template <class T>
Vector<T> stretched_normal(const UnitSlopes<T>& slopes, const T& x, const T& y, const T& alpha_x, const T& alpha_y) {
  using std::sqrt;
  const T u = alpha_x * (slopes.facing * x - slopes.across * y), v = alpha_y * (slopes.facing * y + slopes.across * x);
  const T over = T(1) / sqrt(u * u + v * v + T(1));
  return {u * over, v * over, over};
}

/// The viewer in the space of unit roughness: cosine and sine, and its azimuth.
template <class T>
struct StretchedViewer {
  T c, s, x, y;

  StretchedViewer(const Vector<T>& o, const T& alpha_x, const T& alpha_y) {
    using std::sqrt;
    const T across = alpha_x * o.x, along = alpha_y * o.y, s2 = across * across + along * along;
    const T sine = sqrt(s2), over = T(1) / sine, shorter = T(1) / sqrt(s2 + o.z * o.z);
    c = o.z * shorter, s = sine * shorter;
    x = across * over, y = along * over;
  }
};

template <class T>
Vector<T> mirrored(const Vector<T>& o, const Vector<T>& m) {
  const T twice = T(2) * dot(o, m);
  return {twice * m.x - o.x, twice * m.y - o.y, twice * m.z - o.z};
}

} // namespace brdfplot::choice::forms
