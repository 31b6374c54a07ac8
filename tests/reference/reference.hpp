/// \file
/// Every closed form in the words of its definition, for any number type: the arbiter of all error figures.
///
/// Nothing is rewritten for stability; the precision of the number type has to absorb the cancellation. How much that
/// is: Lambda of GGX loses 2 log2(a) + 2 bits, so that a = 1e300 wants 2100 bits and a < 1e6 is at home in 113; the
/// quadratic form of the slopes loses log2(1 / (1 - r^2)) bits. One identity is used, erf a - 1 = -erfc a, because the
/// difference itself would lose 1.44 a^2 bits; tests/accuracy compares with the difference at 2600 bits.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/erf.hpp>

#include <cmath>
#include <limits>

namespace brdfplot::reference {

template <class R>
R pi() {
  return boost::math::constants::pi<R>();
}

template <class R>
struct Vector {
  R x, y, z;
};

template <class R>
R dot(const Vector<R>& u, const Vector<R>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

template <class R>
struct Stretch {
  R alpha_x, alpha_y, correlation, mean_x, mean_y;
};

enum class Model { beckmann, ggx };
enum class G2Form { none, separable, minimum, height_correlated, direction_correlated, height_direction_correlated };

/// Signed a; Heitz 2014, Eqs. 69 and 72, extended to a < 0 as Heitz et al. 2016 do. a != 0.
template <class R>
R lambda_beckmann(const R& a) {
  using std::exp, std::sqrt, boost::math::erfc;
  return -erfc(a) / 2 + exp(R(-a * a)) / (2 * a * sqrt(pi<R>()));
}

template <class R>
R lambda_ggx(const R& a) {
  using std::sqrt;
  const R root = sqrt(R(1 + 1 / (a * a)));
  return (-1 + (a > 0 ? root : R(-root))) / 2;
}

template <class R>
R lambda(Model model, const R& a) {
  return model == Model::beckmann ? lambda_beckmann(a) : lambda_ggx(a);
}

/// Walter et al. 2007, the fit of Lambda.
template <class R>
R lambda_walter(const R& a) {
  if (a >= R(16) / 10) return R(0);
  return (1 - R(1259) / 1000 * a + R(396) / 1000 * a * a) / (R(3535) / 1000 * a + R(2181) / 1000 * a * a);
}

/// Projected area of the mesosurface; Heitz 2014, section 5.5.
template <class R>
R mesosurface_area(const Stretch<R>& k, const Vector<R>& omega) {
  return omega.z - omega.x * k.mean_x - omega.y * k.mean_y;
}

/// alpha_o sin(theta_o), Eq. 92 and 97 (with the 2 of the cross term, which the print leaves to the reader).
template <class R>
R projected_roughness(const Stretch<R>& k, const Vector<R>& omega) {
  using std::sqrt;
  const R square = k.alpha_x * k.alpha_x * omega.x * omega.x +
                   2 * k.correlation * k.alpha_x * k.alpha_y * omega.x * omega.y +
                   k.alpha_y * k.alpha_y * omega.y * omega.y;
  return square > 0 ? R(sqrt(square)) : R(0);
}

/// Lambda(omega), by a = c / s; 0 for s = 0.
template <class R>
R lambda(Model model, const Stretch<R>& k, const Vector<R>& omega) {
  const R s = projected_roughness(k, omega);
  return s == 0 ? R(0) : lambda(model, R(mesosurface_area(k, omega) / s));
}

/// c (1 + Lambda), Eq. 41.
template <class R>
R sigma(Model model, const Stretch<R>& k, const Vector<R>& omega) {
  return mesosurface_area(k, omega) * (1 + lambda(model, k, omega));
}

/// 1 / (1 + Lambda) above the horizon of the mesosurface (Eq. 43), 0 below.
template <class R>
R g1(Model model, const Stretch<R>& k, const Vector<R>& omega) {
  return mesosurface_area(k, omega) > 0 ? R(1 / (1 + lambda(model, k, omega))) : R(0);
}

/// The angle in [0, pi] between the projections of two directions to the plane; 0 where one has none. By Newton's
/// method from the angle in double: Boost 1.74 has atan2 of a float128 to some 50 bits only.
template <class R>
R azimuth_difference(const Vector<R>& o, const Vector<R>& i) {
  using std::abs, std::atan2, std::cos, std::sin;
  const R cross = o.x * i.y - o.y * i.x, along = o.x * i.x + o.y * i.y;
  const R across = cross < 0 ? R(-cross) : cross, size = across > abs(along) ? across : R(abs(along));
  if (size == 0) return R(0);
  const R x = along / size, y = across / size;
  R phi = atan2(static_cast<double>(y), static_cast<double>(x));
  for (R step = 1; abs(R(step * step * step)) > std::numeric_limits<R>::epsilon();) {
    const R c = cos(phi), s = sin(phi);
    step = (y * c - x * s) / (x * c + y * s);
    phi += step;
  }
  return phi;
}

/// The factors of Eqs. 100 and 101; phi in [0, pi].
template <class R>
R direction_factor_ginneken(const R& phi) {
  return R(441) / 100 * phi / (R(441) / 100 * phi + 1);
}
template <class R>
R direction_factor_ashikhmin(const R& phi) {
  using std::exp;
  return 1 - exp(R(-R(73) / 10 * phi * phi));
}

/// G2 of two Lambdas (Eqs. 35, 98 to 101); `factor` is lambda(phi), of which only the last two forms know.
template <class R>
R g2(G2Form form, const R& lambda_o, const R& lambda_i, const R& factor) {
  const R g_o = 1 / (1 + lambda_o), g_i = 1 / (1 + lambda_i);
  const R& larger = lambda_o > lambda_i ? lambda_o : lambda_i;
  const R& smaller = lambda_o > lambda_i ? lambda_i : lambda_o;
  const R least = g_o < g_i ? g_o : g_i;
  switch (form) {
  case G2Form::none: return g_o;
  case G2Form::separable: return g_o * g_i;
  case G2Form::minimum: return least;
  case G2Form::height_correlated: return 1 / (1 + lambda_o + lambda_i);
  case G2Form::direction_correlated: return factor * g_o * g_i + (1 - factor) * least;
  case G2Form::height_direction_correlated: return 1 / (1 + larger + factor * smaller);
  }
  return R(0);
}

/// Squared norm of a slope, Eqs. 88, 92 and 95.
template <class R>
R slope_norm2(const Stretch<R>& k, const R& slope_x, const R& slope_y) {
  const R x = (slope_x - k.mean_x) / k.alpha_x, y = (slope_y - k.mean_y) / k.alpha_y;
  return (x * x - 2 * k.correlation * x * y + y * y) / (1 - k.correlation * k.correlation);
}

/// Density of slopes, Eqs. 67, 70, 81, 84 and 95.
template <class R>
R p22(Model model, const Stretch<R>& k, const R& slope_x, const R& slope_y) {
  using std::exp, std::sqrt;
  const R det = k.alpha_x * k.alpha_y * sqrt(R(1 - k.correlation * k.correlation));
  const R norm2 = slope_norm2(k, slope_x, slope_y);
  if (model == Model::beckmann) return exp(R(-norm2)) / (pi<R>() * det);
  return 1 / (pi<R>() * det * (1 + norm2) * (1 + norm2));
}

/// D(omega_m) = P22 / cos^4 (Eq. 64) of a unit vector.
template <class R>
R d(Model model, const Stretch<R>& k, const Vector<R>& m) {
  if (!(m.z > 0)) return R(0);
  const R cos2 = m.z * m.z;
  return p22(model, k, R(-m.x / m.z), R(-m.y / m.z)) / (cos2 * cos2);
}

/// D_omega_o(omega_m) = G1 <o, m> D(m) / c (Eq. 16).
template <class R>
R d_visible(Model model, const Stretch<R>& k, const Vector<R>& o, const Vector<R>& m) {
  const R facing = dot(o, m), c = mesosurface_area(k, o);
  return facing > 0 && c > 0 ? R(g1(model, k, o) * facing * d(model, k, m) / c) : R(0);
}

/// Specular BRDF with F = 1, D(h) G2 / (4 c_o c_i) (Eq. 29); unit vectors.
template <class R>
R brdf(Model model, G2Form form, const Stretch<R>& k, const Vector<R>& o, const Vector<R>& i, const R& factor = R(0)) {
  using std::sqrt;
  const R c_o = mesosurface_area(k, o), c_i = mesosurface_area(k, i);
  const Vector<R> sum{o.x + i.x, o.y + i.y, o.z + i.z};
  if (!(c_o > 0 && c_i > 0 && sum.z > 0)) return R(0);
  const R norm = sqrt(dot(sum, sum));
  const Vector<R> h{sum.x / norm, sum.y / norm, sum.z / norm};
  return d(model, k, h) * g2(form, lambda(model, k, o), lambda(model, k, i), factor) / (4 * c_o * c_i);
}

template <class R>
R schlick(const R& c, const R& f0, const R& f90, const R& exponent) {
  using std::pow;
  return f0 + (f90 - f0) * pow(R(1 - c), exponent);
}

/// Unpolarised, relative index eta.
template <class R>
R dielectric(const R& c, const R& eta) {
  using std::sqrt;
  const R cos2_t = 1 - (1 - c * c) / (eta * eta);
  if (cos2_t < 0) return R(1);
  const R c_t = sqrt(cos2_t);
  const R s = (c - eta * c_t) / (c + eta * c_t), p = (eta * c - c_t) / (eta * c + c_t);
  return (s * s + p * p) / 2;
}

template <class R>
struct Complex {
  R re, im;
  Complex operator+(const Complex& w) const { return {re + w.re, im + w.im}; }
  Complex operator-(const Complex& w) const { return {re - w.re, im - w.im}; }
  Complex operator*(const Complex& w) const { return {re * w.re - im * w.im, re * w.im + im * w.re}; }
  R norm2() const { return re * re + im * im; }
};

/// The root in the first quadrant of a number in the upper half plane.
template <class R>
Complex<R> square_root(const Complex<R>& w) {
  using std::sqrt;
  const R modulus = sqrt(w.norm2());
  const R re2 = (modulus + w.re) / 2, im2 = (modulus - w.re) / 2;
  return {re2 > 0 ? R(sqrt(re2)) : R(0), im2 > 0 ? R(sqrt(im2)) : R(0)};
}

/// Unpolarised, relative index n = eta + i k: with q = sqrt(n^2 - sin^2), r_s = (c - q) / (c + q) and
/// r_p = (n^2 c - q) / (n^2 c + q).
template <class R>
R conductor(const R& c, const R& eta, const R& k) {
  const Complex<R> n{eta, k}, n2 = n * n, cosine{c, R(0)};
  const Complex<R> q = square_root(n2 - Complex<R>{1 - c * c, R(0)});
  const R s = (cosine - q).norm2() / (cosine + q).norm2();
  const R p = (n2 * cosine - q).norm2() / (n2 * cosine + q).norm2();
  return (s + p) / 2;
}

} // namespace brdfplot::reference
