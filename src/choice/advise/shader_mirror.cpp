#include "choice/advise/shader_mirror.hpp"

#include <algorithm>

namespace brdfplot::choice::forms {

namespace {

using N = Counted;

bool is_round(const ModelChoice& d) { return !d.values.has("alpha_x") && !d.values.has("correlation"); }

Stretch<N> stretch_of(const ModelChoice& d) {
  return {N(2),
          N(3),
          N(0.1),
          N(1.1),
          N(0.1),
          N(0.2),
          N(1.5),
          is_round(d),
          d.values.has("correlation"),
          d.values.has("mean_slope")};
}

Roughness<N> roughness_of(const ModelChoice& d) {
  return {N(0.5), N(0.3), N(0.1), N(0.9), is_round(d), d.values.has("correlation")};
}

N density(const ModelChoice& d, const Counted3& m) {
  const Stretch<N> s = stretch_of(d);
  if (d.type == "ggx") return d_ggx(m, s);
  if (d.type == "beckmann" || d.type == "ward") return d_beckmann(m, s);
  if (d.type == "phong") return d_cosine_power(m.z, N(1), N(20));
  if (d.type == "sheen") return d_sine_power(m.z, N(1), N(2));
  if (d.type == "velvet") return d_velvet(m.z, N(0.2), N(0.3), N(4));
  if (d.type == "gaussian") return exp(N(4) * acos(m.z) * acos(m.z));
  if (d.type == "student_t" || d.type == "gtr") return d_power(m, s, N(0.5), N(-3));
  if (d.type == "exponential_power") return s.factor * exp(pow(scaled_norm2(m, s) / (m.z * m.z), N(0.6)));
  if (d.type != "mixture") {
    (void)scaled_norm2(m, s);
    read_table(1);
    return N(1);
  }
  N sum(0);
  for (const WeightedChoice& one : d.values.components("components")) sum += density(one.model, m) * N(one.weight);
  return sum;
}

/// c Lambda of one direction by the masking function.
N masked(const TermDescription& term, const Counted3& w) {
  const ModelChoice& d = term.distribution;
  const std::string& by = term.masking.type;
  const std::string shadowing = term.shadowing ? term.shadowing->type : "";
  if (shadowing == "neubelt") return N(1) - w.z;
  if (by == "karis" || shadowing == "hammon") {
    if (is_round(d)) return masked_karis(w.z, N(0.2));
    return sqrt(projected2(w, roughness_of(d)) / (N(1) - w.z * w.z)) * (N(1) - w.z);
  }
  if (by == "sheen_fit") return masked_sheen_fit(w.z, N(1), N(2), N(0.5), N(-1), N(1), N(0.5));
  const N s2 = projected2(w, roughness_of(d));
  const bool as_ggx =
      d.type == "ggx" || (term.masking.values.has("lambda_of") && term.masking.values.text("lambda_of") == "ggx");
  if (by == "smith_rational") return masked_walter(w.z, s2);
  if (by == "smith" && as_ggx) return masked_ggx(w.z, s2);
  if (by == "smith" && d.type == "beckmann") return masked_beckmann(w.z, s2);
  // Anything else is a table of a Lambda(a), one for each component.
  const N s = sqrt(s2);
  (void)(w.z / s);
  read_table(d.type == "mixture" ? d.values.components("components").size() : 1);
  return s * N(0.5);
}

bool has_masked_area(const TermDescription& term) {
  return term.masking.type != "implicit" && term.masking.type != "kelemen";
}

/// The cosine of a direction with the mesosurface.
N cosine(const TermDescription& term, const Counted3& w) {
  if (!term.distribution.values.has("mean_slope")) return w.z;
  return w.z - w.x * N(0.1) - w.y * N(0.2);
}

std::string shadowing_of(const TermDescription& term) {
  if (term.shadowing) return term.shadowing->type;
  if (term.masking.type == "v_cavity") return "minimum";
  return has_masked_area(term) ? "height_correlated" : "separable";
}

N visibility(const TermDescription& term) {
  const Counted3 o = viewer(), i = light();
  if (term.masking.type == "implicit") return N(1);
  if (term.masking.type == "kelemen") return N(1) / (N(0.8) * N(0.8));
  const std::string how = shadowing_of(term);
  if (how == "none") return N(1) / (N(0.9) * i.z);
  const N c_i = cosine(term, i), t_i = masked(term, i);
  if (how == "separable") return visibility_separable(N(1.2), c_i, t_i);
  if (how == "minimum") return visibility_minimum(N(0.9), o.z, c_i, t_i);
  if (how == "direction_correlated") {
    const N factor = correlation_factor(azimuth_difference(o, i));
    return factor * visibility_separable(N(1.2), c_i, t_i) +
           (N(1) - factor) * visibility_minimum(N(0.9), o.z, c_i, t_i);
  }
  if (how == "height_direction_correlated") {
    const N factor = correlation_factor(azimuth_difference(o, i));
    const N a = c_i * N(0.2), b = o.z * t_i;
    return N(1) / (o.z * c_i + max(a, b) + factor * min(a, b));
  }
  return visibility_height(o.z, N(0.2), c_i, t_i);
}

} // namespace

int channels_of(const ModelChoice& fresnel) {
  const auto& map = fresnel.values.map();
  return std::ranges::any_of(map, [](const auto& entry) { return std::holds_alternative<Rgb>(entry.second); }) ? 3 : 1;
}

void fresnel(const ModelChoice& of) {
  const N c(0.6);
  const int channels = channels_of(of);
  const auto each = [&](const auto& channel) {
    for (int k = 0; k < channels; ++k) channel();
  };
  if (of.type == "conductor") each([&] { (void)conductor(c, N(2), N(5)); });
  if (of.type == "dielectric") each([&] { (void)dielectric(c, N(1.25)); });
  if (of.type == "schlick") {
    const bool fifth = !of.values.has("exponent") || of.values.number("exponent") == 5;
    const N x5 = fifth ? fifth_power(c) : pow(N(1) - c, N(4));
    each([&] { (void)schlick(x5, N(0.04), N(0.96)); });
  }
  if (of.type == "f82") {
    const N x5 = fifth_power(c), dip = c * (N(1) - c) * x5;
    each([&] { (void)f82(x5, dip, N(0.5), N(0.5), N(0.1)); });
  }
}

void mirror_view(const TermDescription& term) {
  if (term.type == "kelemen" || !has_masked_area(term)) return;
  const N c = cosine(term, viewer()), t = masked(term, viewer());
  const std::string how = shadowing_of(term);
  if (how == "separable" || how == "direction_correlated") (void)(N(1) / (c + t));
}

void mirror_light(const TermDescription& term) {
  // The half vector is counted once for all terms.
  const N d = density(term.distribution, {N(0.1), N(0.7), N(0.7)});
  N value = d;
  if (term.type == "kelemen")
    value = d / (N(1) + dot(viewer(), light()));
  else if (term.masking.type != "implicit")
    value = d * visibility(term);
  fresnel(term.fresnel);
  if (term.fresnel.type != "none")
    for (int k = 0; k < channels_of(term.fresnel); ++k) (void)(value * N(0.5));
}

} // namespace brdfplot::choice::forms
