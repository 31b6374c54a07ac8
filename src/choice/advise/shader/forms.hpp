/// \file
/// What a shader would compute of a microsurface, its facets and flat terms: one formula each, for any number type.
/// Constants of a material (alpha^2, 1 / alpha, ...) are arguments, since they are made once. With Counted numbers they
/// tell their operations; with doubles they are held against what the program evaluates.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::choice::forms {

template <class T>
struct Vector {
  T x, y, z;
};

template <class T>
T dot(const Vector<T>& u, const Vector<T>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

template <class T>
Vector<T> half_vector(const Vector<T>& o, const Vector<T>& i) {
  using std::sqrt;
  const Vector<T> sum{o.x + i.x, o.y + i.y, o.z + i.z};
  const T scale = T(1) / sqrt(dot(sum, sum));
  return {sum.x * scale, sum.y * scale, sum.z * scale};
}

/// Of a distribution that is stretched: 1 / alpha_x, 1 / alpha_y, correlation and 1 / sqrt(1 - r^2), mean slope, and
/// the factor of D.
template <class T>
struct Stretch {
  T inverse_x, inverse_y, r, inverse_q, mean_x, mean_y, factor;
  bool round = true, correlated = false, sheared = false;
};

/// z^2 times the squared unit slope of a normal (Heitz 2014, Eq. 95).
template <class T>
T scaled_norm2(const Vector<T>& m, const Stretch<T>& s) {
  if (s.round && !s.sheared) return (T(1) - m.z * m.z) * (s.inverse_x * s.inverse_x);
  const T u = (s.sheared ? m.x + s.mean_x * m.z : m.x) * s.inverse_x;
  const T v = (s.sheared ? m.y + s.mean_y * m.z : m.y) * s.inverse_y;
  const T w = s.correlated ? (v - s.r * u) * s.inverse_q : v;
  return u * u + w * w;
}

/// GGX: factor / (z^2 + n2)^2, factor = 1 / (pi det).
template <class T>
T d_ggx(const Vector<T>& m, const Stretch<T>& s) {
  const T q = m.z * m.z + scaled_norm2(m, s);
  return s.factor / (q * q);
}

/// Beckmann: factor exp(-n2 / z^2) / z^4.
template <class T>
T d_beckmann(const Vector<T>& m, const Stretch<T>& s) {
  using std::exp;
  const T over = T(1) / (m.z * m.z);
  return s.factor * over * over * exp(-scaled_norm2(m, s) * over);
}

/// Of a power of 1 + k n2 / z^2, as of Student's t, GTR and the exponential power.
template <class T>
T d_power(const Vector<T>& m, const Stretch<T>& s, const T& k, const T& exponent) {
  using std::pow;
  const T over = T(1) / (m.z * m.z);
  return s.factor * over * over * pow(T(1) + k * scaled_norm2(m, s) * over, exponent);
}

/// factor z^exponent (Phong), or of the sine (sheen).
template <class T>
T d_cosine_power(const T& z, const T& factor, const T& exponent) {
  using std::pow;
  return factor * pow(z, exponent);
}
template <class T>
T d_sine_power(const T& z, const T& factor, const T& half_exponent) {
  using std::pow;
  return factor * pow(T(1) - z * z, half_exponent);
}

/// base + inverted exp(-cot^2 / alpha^2) / sin^4 (velvet).
template <class T>
T d_velvet(const T& z, const T& base, const T& inverted, const T& inverse_alpha2) {
  using std::exp;
  const T over = T(1) / (T(1) - z * z);
  return base + inverted * over * over * exp((T(1) - over) * inverse_alpha2);
}

/// The square of the projected roughness, (alpha_o sin theta)^2; alphas as in Stretch, not inverted.
template <class T>
struct Roughness {
  T alpha_x, alpha_y, r, q;
  bool round = true, correlated = false;
};

template <class T>
T projected2(const Vector<T>& w, const Roughness<T>& a) {
  if (a.round) return (T(1) - w.z * w.z) * (a.alpha_x * a.alpha_x);
  const T y = a.alpha_y * w.y;
  const T u = a.correlated ? a.alpha_x * w.x + a.r * y : a.alpha_x * w.x;
  const T v = a.correlated ? a.q * y : y;
  return u * u + v * v;
}

/// c Lambda by c and the squared projected roughness. GGX: (sqrt(c^2 + s^2) - c) / 2.
template <class T>
T masked_ggx(const T& c, const T& s2) {
  using std::sqrt;
  return (sqrt(c * c + s2) - c) * T(0.5);
}

/// Beckmann, exactly: c (exp(-a^2) / (a sqrt(pi)) - erfc(a)) / 2.
template <class T>
T masked_beckmann(const T& c, const T& s2) {
  using std::erfc;
  using std::exp;
  using std::sqrt;
  const T s = sqrt(s2), a = c / s;
  return T(0.5) * (s * T(std::numbers::inv_sqrtpi) * exp(-a * a) - c * erfc(a));
}

/// Walter's fit of it (2007).
template <class T>
T masked_walter(const T& c, const T& s2) {
  using std::sqrt;
  const T a = c / sqrt(s2);
  if (!(a < T(1.6))) return T(0);
  return c * (T(1) - T(1.259) * a + T(0.396) * a * a) / ((T(3.535) + T(2.181) * a) * a);
}

/// alpha (1 - c) / 2 (Karis 2013).
template <class T>
T masked_karis(const T& c, const T& half_alpha) {
  return half_alpha - half_alpha * c;
}

/// c exp(L(c)), or exp(2 L(1/2) - L(1 - c)) for c > 1/2, L(x) = a / (1 + b x^p) + d x + e (Estevez and Kulla 2017).
template <class T>
T masked_sheen_fit(const T& c, const T& a, const T& b, const T& p, const T& d, const T& e, const T& twice_middle) {
  using std::exp;
  using std::pow;
  const bool low = c < T(0.5);
  const T x = low ? c : T(1) - c;
  const T l = a / (T(1) + b * pow(x, p)) + d * x + e;
  return c * exp(low ? l : twice_middle - l);
}

/// G2 / (c_o c_i) of c and c Lambda.
template <class T>
T visibility_height(const T& c_o, const T& t_o, const T& c_i, const T& t_i) {
  return T(1) / (c_i * (c_o + t_o) + c_o * t_i);
}
template <class T>
T visibility_separable(const T& over_u_o, const T& c_i, const T& t_i) {
  return over_u_o / (c_i + t_i);
}
template <class T>
T visibility_minimum(const T& u_o, const T& c_o, const T& c_i, const T& t_i) {
  using std::max;
  return T(1) / max(c_i * u_o, c_o * (c_i + t_i));
}

/// The azimuth difference of two directions by their horizontal parts.
template <class T>
T azimuth_difference(const Vector<T>& o, const Vector<T>& i) {
  using std::acos;
  using std::sqrt;
  return acos((o.x * i.x + o.y * i.y) / sqrt((T(1) - o.z * o.z) * (T(1) - i.z * i.z)));
}

/// lambda = k phi / (k phi + 1) (van Ginneken 1998).
template <class T>
T correlation_factor(const T& phi) {
  const T x = T(4.41) * phi;
  return x / (x + T(1));
}

/// f0 + (f90 - f0) (1 - c)^5; `x5` is made once for all channels.
template <class T>
T fifth_power(const T& c) {
  const T x = T(1) - c, x2 = x * x;
  return x2 * x2 * x;
}
template <class T>
T schlick(const T& x5, const T& f0, const T& rest) {
  return f0 + rest * x5;
}
/// Minus a c (1 - c)^6; `dip` = c (1 - c)^6.
template <class T>
T f82(const T& x5, const T& dip, const T& f0, const T& rest, const T& a) {
  return f0 + rest * x5 - a * dip;
}

/// Fresnel's equations for eta > 1.
template <class T>
T dielectric(const T& c, const T& eta2_minus_1) {
  using std::sqrt;
  const T g = sqrt(eta2_minus_1 + c * c);
  const T plus = g + c, minus = g - c;
  const T a = minus / plus, b = (c * plus - T(1)) / (c * minus + T(1));
  return T(0.5) * a * a * (T(1) + b * b);
}

/// Fresnel's equations for eta + i k (as commonly written, with a^2 + b^2 and a from two roots).
template <class T>
T conductor(const T& c, const T& eta2_minus_k2, const T& four_eta2_k2) {
  using std::sqrt;
  const T c2 = c * c, s2 = T(1) - c2;
  const T t0 = eta2_minus_k2 - s2;
  const T sum = sqrt(t0 * t0 + four_eta2_k2);
  const T a = sqrt(T(0.5) * (sum + t0));
  const T t1 = sum + c2, t2 = T(2) * c * a;
  const T rs = (t1 - t2) / (t1 + t2);
  const T t3 = c2 * sum + s2 * s2, t4 = t2 * s2;
  return T(0.5) * rs * (T(1) + (t3 - t4) / (t3 + t4));
}

/// r s / t of Fujii's form of Oren and Nayar.
template <class T>
T fujii_ratio(const T& lv, const T& nl, const T& nv) {
  using std::max;
  const T s = lv - nl * nv;
  return s > T(0) ? s / max(nl, nv) : s;
}

/// 1 - E(mu) of EON over its factor: the polynomial of the print in 1 - mu.
template <class T>
T eon_loss(const T& mu) {
  const T x = T(1) - mu;
  return x * (T(0.0571085289) + x * (T(0.491881867) + x * (T(-0.332181442) + x * T(0.0714429953))));
}

/// Oren and Nayar's qualitative fit without A: B max(cos dphi, 0) sin tan.
template <class T>
T oren_nayar_qualitative(const Vector<T>& o, const Vector<T>& i) {
  using std::max;
  using std::sqrt;
  const T horizontal = o.x * i.x + o.y * i.y; // sin sin cos dphi
  return max(horizontal, T(0)) / max(o.z, i.z);
}

/// Where a disc of a light is nearest to the mirrored viewer (Karis 2013), by the direction of its middle.
template <class T>
Vector<T> nearest_in_disc(const Vector<T>& mirrored, const Vector<T>& middle, const T& tangent) {
  using std::min;
  using std::sqrt;
  const T along = dot(mirrored, middle);
  const Vector<T> to{along * mirrored.x - middle.x, along * mirrored.y - middle.y, along * mirrored.z - middle.z};
  const T k = min(T(1), tangent / sqrt(dot(to, to)));
  const Vector<T> sum{middle.x + k * to.x, middle.y + k * to.y, middle.z + k * to.z};
  const T scale = T(1) / sqrt(dot(sum, sum));
  return {sum.x * scale, sum.y * scale, sum.z * scale};
}

} // namespace brdfplot::choice::forms
