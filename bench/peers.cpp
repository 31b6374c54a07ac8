#include "peers.hpp"

#include <boost/math/special_functions/erf.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace brdfplot::bench {

namespace {

template <class T>
constexpr T root_pi = T(1) / std::numbers::inv_sqrtpi_v<T>;

template <class T>
T square(T x) {
  return x * x;
}

template <class T>
T printed_lambda_beckmann(T a) {
  return T(0.5) * (std::erf(a) - 1) + std::exp(-a * a) / (2 * a * root_pi<T>);
}

/// Names as in pbrt-v4, util/vecmath.h.
template <class T>
struct Vector3 {
  T x, y, z;
  T cos2_theta() const { return z * z; }
  T sin2_theta() const { return std::max(T(0), 1 - cos2_theta()); }
  T sin_theta() const { return std::sqrt(sin2_theta()); }
  T tan2_theta() const { return sin2_theta() / cos2_theta(); }
  T cos_phi() const {
    const T sine = sin_theta();
    return sine == 0 ? 1 : std::clamp(x / sine, T(-1), T(1));
  }
  T sin_phi() const {
    const T sine = sin_theta();
    return sine == 0 ? 0 : std::clamp(y / sine, T(-1), T(1));
  }
};

template <class T>
struct PbrtGgx {
  T alpha_x, alpha_y;
  T d(const Vector3<T>& m) const {
    const T tan2 = m.tan2_theta();
    if (std::isinf(tan2)) return 0;
    const T cos4 = square(m.cos2_theta());
    if (cos4 < T(1e-16)) return 0;
    const T e = tan2 * (square(m.cos_phi() / alpha_x) + square(m.sin_phi() / alpha_y));
    return 1 / (std::numbers::pi_v<T> * alpha_x * alpha_y * cos4 * square(1 + e));
  }
  T lambda(const Vector3<T>& w) const {
    const T tan2 = w.tan2_theta();
    if (std::isinf(tan2)) return 0;
    const T alpha2 = square(w.cos_phi() * alpha_x) + square(w.sin_phi() * alpha_y);
    return (std::sqrt(1 + alpha2 * tan2) - 1) / 2;
  }
};

template <class T>
struct PbrtBeckmann {
  T alpha_x, alpha_y;
  T d(const Vector3<T>& m) const {
    const T tan2 = m.tan2_theta();
    if (std::isinf(tan2)) return 0;
    const T cos4 = square(m.cos2_theta());
    return std::exp(-tan2 * (square(m.cos_phi() / alpha_x) + square(m.sin_phi() / alpha_y))) /
           (std::numbers::pi_v<T> * alpha_x * alpha_y * cos4);
  }
  T lambda(const Vector3<T>& w) const {
    const T tan = std::sqrt(w.tan2_theta());
    if (std::isinf(tan)) return 0;
    const T alpha = std::sqrt(square(w.cos_phi() * alpha_x) + square(w.sin_phi() * alpha_y));
    return printed_lambda_beckmann(1 / (alpha * tan));
  }
};

template <class T>
struct LeanGgx {
  T alpha;
  T d(const Vector3<T>& m) const {
    const T cos2 = m.cos2_theta(), tan2 = (1 - cos2) / cos2;
    return square(alpha) / (std::numbers::pi_v<T> * square(cos2) * square(square(alpha) + tan2));
  }
  T lambda(const Vector3<T>& w) const {
    const T cos2 = w.cos2_theta(), tan2 = (1 - cos2) / cos2;
    return T(0.5) * (std::sqrt(1 + square(alpha) * tan2) - 1);
  }
};

template <class T>
struct LeanBeckmann {
  T alpha;
  T d(const Vector3<T>& m) const {
    const T cos2 = m.cos2_theta(), tan2 = (1 - cos2) / cos2;
    return std::exp(-tan2 / square(alpha)) / (std::numbers::pi_v<T> * square(alpha) * square(cos2));
  }
  T lambda(const Vector3<T>& w) const {
    const T cos2 = w.cos2_theta(), tan = std::sqrt((1 - cos2) / cos2);
    return printed_lambda_beckmann(1 / (alpha * tan));
  }
};

double fresnel_complex(double cosine, std::complex<double> eta) {
  cosine = std::clamp(cosine, 0.0, 1.0);
  const double sin2_i = 1 - square(cosine);
  const std::complex<double> sin2_t = sin2_i / (eta * eta), cos_t = std::sqrt(1.0 - sin2_t);
  const std::complex<double> parallel = (eta * cosine - cos_t) / (eta * cosine + cos_t);
  const std::complex<double> perpendicular = (cosine - eta * cos_t) / (cosine + eta * cos_t);
  return (std::norm(parallel) + std::norm(perpendicular)) / 2;
}

double half_vector_cosine(kernels::Vectors<double> o, kernels::Vectors<double> i, std::size_t k) {
  const double x = o.x[k] + i.x[k], y = o.y[k] + i.y[k], z = o.z[k] + i.z[k];
  return (o.x[k] * x + o.y[k] * y + o.z[k] * z) / std::sqrt(x * x + y * y + z * z);
}

template <class Model, class T>
void over_normals(const Model& model, kernels::Vectors<T> m, T* out, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) out[k] = model.d({m.x[k], m.y[k], m.z[k]});
}

template <class Model, class T>
void over_pairs(const Model& model, kernels::Vectors<T> o, kernels::Vectors<T> i, T* out, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    const Vector3<T> w_o{o.x[k], o.y[k], o.z[k]}, w_i{i.x[k], i.y[k], i.z[k]};
    if (w_o.z <= 0 || w_i.z <= 0) {
      out[k] = 0;
      continue;
    }
    Vector3<T> m{w_o.x + w_i.x, w_o.y + w_i.y, w_o.z + w_i.z};
    const T length = std::sqrt(m.x * m.x + m.y * m.y + m.z * m.z);
    m = {m.x / length, m.y / length, m.z / length};
    const T g = 1 / (1 + model.lambda(w_o) + model.lambda(w_i));
    out[k] = model.d(m) * g / (4 * w_o.z * w_i.z);
  }
}

} // namespace

template <class T>
void printed_beckmann(const T* c, const T* s, T* out, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) out[k] = printed_lambda_beckmann(c[k] / s[k]);
}

template <class T>
void printed_beckmann_of_a(const T* a, T* out, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) out[k] = printed_lambda_beckmann(a[k]);
}

template <class T>
void printed_beckmann_boost(const T* c, const T* s, T* out, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    const T a = c[k] / s[k];
    out[k] = T(0.5) * (boost::math::erf(a) - 1) + std::exp(-a * a) / (2 * a * root_pi<T>);
  }
}

template <class T>
void printed_ggx(const T* c, const T* s, T* out, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    const T a = c[k] / s[k];
    out[k] = (std::sqrt(1 + 1 / (a * a)) - 1) / 2;
  }
}

template <class T>
void walter_scalar(const T* c, const T* s, T* out, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    const T a = c[k] / s[k];
    out[k] = a < T(1.6) ? (1 - T(1.259) * a + T(0.396) * a * a) / (T(3.535) * a + T(2.181) * a * a) : 0;
  }
}

template <class T>
void pbrt_ggx(double alpha, kernels::Vectors<T> o, kernels::Vectors<T> i, T* out, std::size_t n) {
  over_pairs(PbrtGgx<T>{static_cast<T>(alpha), static_cast<T>(alpha)}, o, i, out, n);
}
template <class T>
void pbrt_beckmann(double alpha, kernels::Vectors<T> o, kernels::Vectors<T> i, T* out, std::size_t n) {
  over_pairs(PbrtBeckmann<T>{static_cast<T>(alpha), static_cast<T>(alpha)}, o, i, out, n);
}
template <class T>
void pbrt_d_ggx(double alpha, kernels::Vectors<T> m, kernels::Vectors<T>, T* out, std::size_t n) {
  over_normals(PbrtGgx<T>{static_cast<T>(alpha), static_cast<T>(alpha)}, m, out, n);
}
template <class T>
void pbrt_d_beckmann(double alpha, kernels::Vectors<T> m, kernels::Vectors<T>, T* out, std::size_t n) {
  over_normals(PbrtBeckmann<T>{static_cast<T>(alpha), static_cast<T>(alpha)}, m, out, n);
}

void pbrt_conductor(double alpha, kernels::Vectors<double> o, kernels::Vectors<double> i, double* out, std::size_t n) {
  over_pairs(PbrtGgx<double>{alpha, alpha}, o, i, out, n);
  for (std::size_t k = 0; k < n; ++k)
    out[k] *= fresnel_complex(half_vector_cosine(o, i, k), {conductor_eta, conductor_k});
}

void pbrt_gold(double alpha, kernels::Vectors<double> o, kernels::Vectors<double> i, double* out, std::size_t n) {
  over_pairs(PbrtGgx<double>{alpha, alpha}, o, i, out, n);
  for (std::size_t k = 0; k < n; ++k) {
    const double facing = half_vector_cosine(o, i, k), white = out[k];
    for (std::size_t channel = 0; channel < 3; ++channel)
      out[channel * n + k] = white * fresnel_complex(facing, {gold_eta[channel], gold_k[channel]});
  }
}

template <class T>
void lean_ggx(double alpha, kernels::Vectors<T> o, kernels::Vectors<T> i, T* out, std::size_t n) {
  over_pairs(LeanGgx<T>{static_cast<T>(alpha)}, o, i, out, n);
}
template <class T>
void lean_beckmann(double alpha, kernels::Vectors<T> o, kernels::Vectors<T> i, T* out, std::size_t n) {
  over_pairs(LeanBeckmann<T>{static_cast<T>(alpha)}, o, i, out, n);
}

template OverCs<double> printed_beckmann<double>;
template OverCs<float> printed_beckmann<float>;
template OverCs<double> printed_beckmann_boost<double>;
template OverCs<float> printed_beckmann_boost<float>;
template OverCs<double> printed_ggx<double>;
template OverCs<float> printed_ggx<float>;
template OverCs<double> walter_scalar<double>;
template OverCs<float> walter_scalar<float>;
template void printed_beckmann_of_a(const double*, double*, std::size_t);
template void printed_beckmann_of_a(const float*, float*, std::size_t);
template Brdf<double> pbrt_ggx<double>;
template Brdf<float> pbrt_ggx<float>;
template Brdf<double> pbrt_beckmann<double>;
template Brdf<float> pbrt_beckmann<float>;
template Brdf<double> pbrt_d_ggx<double>;
template Brdf<float> pbrt_d_ggx<float>;
template Brdf<double> pbrt_d_beckmann<double>;
template Brdf<float> pbrt_d_beckmann<float>;
template Brdf<double> lean_ggx<double>;
template Brdf<float> lean_ggx<float>;
template Brdf<double> lean_beckmann<double>;
template Brdf<float> lean_beckmann<float>;

} // namespace brdfplot::bench
