/// \file
/// What a shader computes of a term of mirror facets, for any number type: with Counted numbers it tells its
/// operations, with floats what they round.
#pragma once

#include "brdf/term.hpp"
#include "choice/advise/shader/forms.hpp"
#include "choice/methods/counted.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace brdfplot::choice::forms {

/// Constants of a lobe, made before anything is shaded. The values that stand here are for counting.
template <class T>
struct Lobe {
  std::string type;
  Stretch<T> stretch{T(2), T(3), T(0.1), T(1.1), T(0.1), T(0.2), T(1.5)};
  Roughness<T> roughness{T(0.5), T(0.3), T(0.1), T(0.9)};
  T k = T(0.5), exponent = T(-3); ///< of powers
  T half_alpha = T(0.2);          ///< alpha / 2
  std::vector<Lobe> components{};
  std::vector<T> weights{};
};

/// What depends on the viewer alone: c, c Lambda, their sum and its inverse.
template <class T>
struct MaskedView {
  T c, t, u, over_u;
};

/// A value of a table, which counts as read.
template <class T>
T of_table(double value) {
  if constexpr (!std::is_same_v<T, Counted>) throw std::logic_error("a table has no form but in counts");
  return read_entry<T>(value);
}

template <class T>
T density(const Lobe<T>& lobe, const Vector<T>& m) {
  using std::acos;
  using std::exp;
  using std::pow;
  const Stretch<T>& s = lobe.stretch;
  const std::string& type = lobe.type;
  if (type == "ggx") return d_ggx(m, s);
  if (type == "beckmann" || type == "ward") return d_beckmann(m, s);
  if (type == "phong") return d_cosine_power(m.z, T(1), T(20));
  if (type == "sheen") return d_sine_power(m.z, s.factor, lobe.exponent);
  if (type == "velvet") return d_velvet(m.z, T(0.2), T(0.3), T(4));
  if (type == "gaussian") return exp(T(4) * acos(m.z) * acos(m.z));
  if (type == "student_t" || type == "gtr") return d_power(m, s, lobe.k, lobe.exponent);
  if (type == "exponential_power") return s.factor * exp(pow(scaled_norm2(m, s) / (m.z * m.z), T(0.6)));
  if (type != "mixture") {
    (void)scaled_norm2(m, s);
    return of_table<T>(1);
  }
  T sum(0);
  for (std::size_t k = 0; k < lobe.components.size(); ++k) sum += density(lobe.components[k], m) * lobe.weights[k];
  return sum;
}

/// Whether the distribution's Lambda is GGX's.
inline bool as_ggx(const TermDescription& term) {
  const Values& values = term.masking.values;
  return term.distribution.type == "ggx" || (values.has("lambda_of") && values.text("lambda_of") == "ggx");
}

/// The projected area of the mesosurface.
template <class T>
T cosine(const Lobe<T>& lobe, const Vector<T>& w) {
  const Stretch<T>& s = lobe.stretch;
  return s.sheared ? w.z - w.x * s.mean_x - w.y * s.mean_y : w.z;
}

/// c Lambda of one direction with the projected area c of the mesosurface, by the masking function.
template <class T>
T masked(const TermDescription& term, const Lobe<T>& lobe, const Vector<T>& w, const T& c) {
  using std::sqrt;
  const std::string& by = term.masking.type;
  const std::string shadowing = term.shadowing ? term.shadowing->type : "";
  if (shadowing == "neubelt") return T(1) - c;
  if (by == "karis" || shadowing == "hammon") {
    if (lobe.roughness.round) return masked_karis(c, lobe.half_alpha);
    return sqrt(projected2(w, lobe.roughness) / (T(1) - w.z * w.z)) * (T(1) - c);
  }
  if (by == "sheen_fit") {
    if constexpr (!std::is_same_v<T, Counted>) throw std::logic_error("the fit has no form but in counts");
    return masked_sheen_fit(c, T(1), T(2), T(0.5), T(-1), T(1), T(0.5));
  }
  if (lobe.type == "mixture" && lobe.stretch.sheared) { // a table for each component, of an a of its own
    T sum(0);
    for (std::size_t k = 0; k < lobe.components.size(); ++k) {
      const T c_k = cosine(lobe.components[k], w), s_k = sqrt(projected2(w, lobe.components[k].roughness));
      sum += s_k * (of_table<T>(1) * lobe.weights[k]);
      (void)(c_k / s_k);
    }
    return sum;
  }
  const T s2 = projected2(w, lobe.roughness);
  if (by == "smith_rational") return masked_walter(c, s2);
  if (by == "smith" && as_ggx(term)) return masked_ggx(c, s2);
  if (by == "smith" && lobe.type == "beckmann") return masked_beckmann(c, s2);
  // Anything else is a table of a Lambda(a), one for each component.
  const T s = sqrt(s2);
  (void)(c / s);
  for (std::size_t k = 0; k < (lobe.type == "mixture" ? lobe.components.size() : 1); ++k) (void)of_table<T>(1);
  return s * T(0.5);
}

inline bool has_masked_area(const TermDescription& term) {
  return term.masking.type != "implicit" && term.masking.type != "kelemen";
}

inline std::string shadowing_of(const TermDescription& term) {
  if (term.shadowing) return term.shadowing->type;
  if (term.masking.type == "v_cavity") return "minimum";
  return has_masked_area(term) ? "height_correlated" : "separable";
}

/// G2 / (c_o c_i), or what stands for it.
template <class T>
T visibility(const TermDescription& term, const Lobe<T>& lobe, const Vector<T>& o, const Vector<T>& i,
             const MaskedView<T>& view) {
  using std::max;
  using std::min;
  const std::string how = shadowing_of(term);
  if (how == "none") return T(1) / (view.u * i.z);
  const T c_i = cosine(lobe, i), t_i = masked(term, lobe, i, c_i);
  if (how == "separable") return visibility_separable(view.over_u, c_i, t_i);
  if (how == "minimum") return visibility_minimum(view.u, view.c, c_i, t_i);
  if (how == "direction_correlated") {
    const T factor = correlation_factor(azimuth_difference(o, i));
    return factor * visibility_separable(view.over_u, c_i, t_i) +
           (T(1) - factor) * visibility_minimum(view.u, view.c, c_i, t_i);
  }
  if (how == "height_direction_correlated") {
    const T factor = correlation_factor(azimuth_difference(o, i));
    const T a = c_i * view.t, b = view.c * t_i;
    return T(1) / (view.c * c_i + max(a, b) + factor * min(a, b));
  }
  return visibility_height(view.c, view.t, c_i, t_i);
}

} // namespace brdfplot::choice::forms
