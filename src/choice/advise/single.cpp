#include "choice/advise/single.hpp"

#include "microfacet/distributions.hpp"
#include "microfacet/fresnel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::choice {

namespace {

bool has_form(const ModelChoice& distribution) {
  static const std::vector<std::string> with = {"ggx", "beckmann", "student_t", "sheen"};
  if (distribution.type == "sheen" && !distribution.values.has("alpha")) return false;
  if (distribution.type != "mixture") return std::ranges::find(with, distribution.type) != with.end();
  const WeightedChoices components = distribution.values.components("components");
  return std::ranges::all_of(components, [](const WeightedChoice& one) { return has_form(one.model); });
}

/// Whether the masking function is one of those that are written out, none of which is a table.
bool has_closed_masking(const TermDescription& term) {
  if (term.distribution.type == "mixture") return false;
  const std::string& by = term.masking.type;
  const std::string shadowing = term.shadowing ? term.shadowing->type : "";
  if (shadowing == "neubelt" || shadowing == "hammon" || by == "karis" || by == "smith_rational") return true;
  return by == "smith" && (forms::as_ggx(term) || term.distribution.type == "beckmann");
}

template <class T>
forms::Lobe<T> lobe_of(const ModelChoice& d) {
  forms::Lobe<T> lobe;
  lobe.type = d.type;
  if (d.type == "mixture") {
    for (const WeightedChoice& one : d.values.components("components")) {
      lobe.components.push_back(lobe_of<T>(one.model));
      lobe.weights.push_back(T(one.weight));
    }
    return lobe;
  }
  if (d.type == "sheen") {
    const double alpha = d.values.number("alpha");
    lobe.stretch.factor = T((2 + 1 / alpha) / (2 * std::numbers::pi));
    lobe.exponent = T(0.5 / alpha);
    return lobe;
  }
  const SlopeMap map =
      std::visit([](const auto& one) { return one.slopes; }, make_or_throw<Distribution>("distribution", d));
  const bool round = map.alpha_x == map.alpha_y && map.correlation == 0; // NOLINT(clang-diagnostic-float-equal)
  lobe.stretch = {T(1 / map.alpha_x),
                  T(1 / map.alpha_y),
                  T(map.correlation),
                  T(1 / map.decorrelation()),
                  T(map.mean_x),
                  T(map.mean_y),
                  T(1 / (std::numbers::pi * map.determinant())),
                  round,
                  map.correlation != 0,
                  !map.centred()};
  lobe.roughness = {T(map.alpha_x),         T(map.alpha_y), T(map.correlation),
                    T(map.decorrelation()), round,          map.correlation != 0};
  lobe.half_alpha = T(0.5 * map.alpha_x);
  if (d.type == "student_t") {
    const double gamma = d.values.number("gamma");
    lobe.k = T(1 / (gamma - 1));
    lobe.exponent = T(-gamma);
  }
  return lobe;
}

/// The constants of one channel, as the forms take them.
std::array<double, 3> fresnel_constants(const ModelChoice& fresnel, std::size_t channel) {
  const auto of = [&](const char* key) { return fresnel.values.rgb(key)[channel]; };
  if (fresnel.type == "conductor") {
    const double eta2 = of("eta") * of("eta"), k2 = of("k") * of("k");
    return {eta2 - k2, 4 * eta2 * k2, 0};
  }
  if (fresnel.type == "dielectric") return {of("eta") * of("eta") - 1, 0, 0};
  if (fresnel.type == "schlick") {
    const double f90 = fresnel.values.has("f90") ? of("f90") : 1;
    return {of("f0"), f90 - of("f0"), fresnel.values.has("exponent") ? fresnel.values.number("exponent") : 5};
  }
  if (fresnel.type == "f82") return {of("f0"), 1 - of("f0"), F82Fresnel::coefficient(of("f0"), of("f82"))};
  return {};
}

/// F, or 1 where there is none or none that the forms have.
template <class T>
T reflectance(const ModelChoice& fresnel, const std::array<T, 3>& k, const T& c) {
  using std::pow;
  if (fresnel.type == "conductor") return forms::conductor(c, k[0], k[1]);
  if (fresnel.type == "dielectric" && k[0] > T(0)) return forms::dielectric(c, k[0]);
  const T x5 = forms::fifth_power(c);
  if (fresnel.type == "schlick")
    return forms::schlick(k[2] == T(5) ? x5 : pow(T(1) - c, k[2]), k[0], k[1]); // NOLINT(clang-diagnostic-float-equal)
  if (fresnel.type == "f82") return forms::f82(x5, c * (T(1) - c) * x5, k[0], k[1], k[2]);
  return T(1);
}

template <class T>
forms::Vector<T> vector_of(const Direction& d) {
  return {static_cast<T>(d.x), static_cast<T>(d.y), static_cast<T>(d.z)};
}

} // namespace

bool has_single_form(const TermDescription& term) {
  if (term.type == "mirror") return has_form(term.distribution);
  static const std::vector<std::string> without = {"kelemen", "merl", "rgl", "facet_diffuse"};
  return std::ranges::find(without, term.type) == without.end();
}

template <class T>
SingleForm::Constants<T> SingleForm::constants_of(const TermDescription& term) {
  Constants<T> out;
  if (term.type != "mirror") return out;
  out.lobe = lobe_of<T>(term.distribution);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::array<double, 3> constants = fresnel_constants(term.fresnel, c);
    for (std::size_t k = 0; k < 3; ++k) out.fresnel[c][k] = static_cast<T>(constants[k]);
  }
  return out;
}

SingleForm::SingleForm(const TermDescription& term)
    : term_(term), facets_(term.type == "mirror"), table_(!has_closed_masking(term)), full_(constants_of<double>(term)),
      single_(constants_of<float>(term)) {}

template <class T>
std::array<T, 3> SingleForm::reflected(const Constants<T>& constants, const Direction& omega_o,
                                       const Direction& omega_i) const {
  const forms::Vector<T> o = vector_of<T>(omega_o), i = vector_of<T>(omega_i), h = forms::half_vector(o, i);
  const forms::Lobe<T>& lobe = constants.lobe;
  T facets = forms::density(lobe, h);
  if (!table_) {
    const T c = forms::cosine(lobe, o), t = forms::masked(term_, lobe, o, c);
    facets *= forms::visibility(term_, lobe, o, i, {c, t, c + t, T(1) / (c + t)});
  }
  std::array<T, 3> out{};
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = facets * reflectance(term_.fresnel, constants.fresnel[k], forms::dot(o, h));
  return out;
}

void SingleForm::round(const Direction& o, const Direction& i, std::array<double, 3>& values) const {
  if (facets_ && o.z > 0 && i.z > 0) {
    const std::array<double, 3> full = reflected(full_, o, i);
    const std::array<float, 3> single = reflected(single_, o, i);
    for (std::size_t c = 0; c < 3; ++c)
      if (full[c] > 0) values[c] *= static_cast<double>(single[c]) / full[c];
  }
  for (double& value : values) value = static_cast<double>(static_cast<float>(value));
}

} // namespace brdfplot::choice
