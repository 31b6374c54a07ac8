#include "brdf/material.hpp"

#include "microfacet/registry.hpp"

#include <algorithm>

namespace brdfplot {

namespace {

template <class List>
List make(const std::string& section, const ModelChoice& choice) {
  auto made = make_model<List>(choice);
  if (const auto* error = std::get_if<ParameterError>(&made))
    throw MaterialError("/" + section + (error->key.empty() ? "" : "/" + error->key), error->what);
  return std::get<List>(std::move(made));
}

std::string default_shadowing(const Masking& masking) {
  if (std::holds_alternative<VCavity>(masking)) return "minimum";
  return std::visit([](const auto& m) { return m.has_lambda; }, masking) ? "height_correlated" : "separable";
}

Facet make_facet(const MaterialDescription& description) {
  const auto& names = facet_names();
  const auto found = std::ranges::find(names, description.facet);
  if (found == names.end()) throw MaterialError("/facet", unknown_name("value", description.facet, names));
  const auto facet = static_cast<Facet>(found - names.begin());
  if (facet != Facet::specular && description.fresnel.type != "none")
    throw MaterialError("/fresnel/type", "found \"" + description.fresnel.type + "\" beside \"facet\": \"" +
                                             description.facet + "\"; accepted: none");
  return facet;
}

/// Sets `key` in `choice` if the model that it names has it.
template <class List>
bool set_in(ModelChoice& choice, const std::string& key, double value) {
  for (const ModelSpec& spec : specs_of<List>()) {
    if (spec.type != choice.type || spec.find(key) == nullptr) continue;
    Values kept;
    const auto in = [](const std::vector<std::string>& group, const std::string& k) {
      return std::ranges::find(group, k) != group.end();
    };
    for (const auto& entry : choice.values.map()) {
      const std::string& other = entry.first;
      const auto alternative = [&](const std::string& k) {
        return std::ranges::any_of(spec.alternatives, [&](const auto& g) { return in(g, k); });
      };
      const bool displaced =
          alternative(key) && alternative(other) &&
          std::ranges::none_of(spec.alternatives, [&](const auto& g) { return in(g, key) && in(g, other); });
      if (!displaced) kept.set(other, entry.second);
    }
    kept.set(key, value);
    choice.values = kept;
    return true;
  }
  return false;
}

} // namespace

const std::vector<std::string>& facet_names() {
  static const std::vector<std::string> names = {"specular", "diffuse", "oren_nayar", "oren_nayar_direct",
                                                 "oren_nayar_qualitative"};
  return names;
}

int Material::channels() const {
  return std::visit([](const auto& f) { return f.coloured(); }, fresnel) ? 3 : 1;
}

bool Material::has_lambda() const {
  return std::visit([](const auto& m) { return m.has_lambda; }, masking);
}

const SlopeMap& Material::slopes() const {
  return std::visit([](const auto& d) -> const SlopeMap& { return d.slopes; }, distribution);
}

namespace {

/// A published fit is for one distribution alone.
void require_own_distribution(const MaterialDescription& description, const Distribution& distribution,
                              const Masking& masking) {
  std::visit(
      [&]<class M>(const M&) {
        if constexpr (requires { typename M::FitsOnly; })
          if (!std::holds_alternative<typename M::FitsOnly>(distribution))
            throw MaterialError("/masking/type", "\"" + description.masking.type +
                                                     "\" is a fit for the distribution \"" + M::FitsOnly::spec().type +
                                                     "\" alone, found \"" + description.distribution.type +
                                                     "\"; accepted with any: smith");
      },
      masking);
}

template <class D>
bool has_infinite_mean_slope(const D& distribution) {
  if constexpr (requires { distribution.parts; })
    return std::ranges::any_of(distribution.parts, [](const auto& part) {
      return std::visit([](const auto& d) { return has_infinite_mean_slope(d); }, part.distribution);
    });
  else
    return requires { distribution.profile.infinite_mean_slope; };
}

void require_finite_lambda(const Distribution& distribution, const Masking& masking) {
  const auto* smith = std::get_if<Smith>(&masking);
  if (smith == nullptr || smith->lambda_of != Smith::LambdaOf::itself) return;
  if (std::visit([](const auto& d) { return has_infinite_mean_slope(d); }, distribution))
    throw MaterialError("/masking/type", "\"smith\" has an infinite Lambda with this distribution, whose mean slope is "
                                         "infinite (\"oren_nayar\"); accepted with any: v_cavity");
}

/// Oren and Nayar fitted one microsurface.
void require_cavities(const Material& material) {
  if (!is_fit(material.facet)) return;
  if (std::holds_alternative<OrenNayar>(material.distribution) && std::holds_alternative<VCavity>(material.masking) &&
      std::holds_alternative<Minimum>(material.shadowing))
    return;
  throw MaterialError("/facet", "\"" + facet_names()[static_cast<std::size_t>(material.facet)] +
                                    "\" is a fit for the distribution \"oren_nayar\", the masking \"v_cavity\" and the "
                                    "shadowing \"minimum\" alone; accepted with any: specular, diffuse");
}

} // namespace

Material build(const MaterialDescription& description) {
  auto distribution = make<Distribution>("distribution", description.distribution);
  const auto masking = make<Masking>("masking", description.masking);
  require_own_distribution(description, distribution, masking);
  require_finite_lambda(distribution, masking);
  const ModelChoice shadowing_choice = description.shadowing.value_or(ModelChoice{.type = default_shadowing(masking)});
  const auto shadowing = make<Shadowing>("shadowing", shadowing_choice);
  const bool has_lambda = std::visit([](const auto& m) { return m.has_lambda; }, masking);
  const bool needs_lambda = std::visit([](const auto& s) { return s.needs_lambda; }, shadowing);
  if (needs_lambda && !has_lambda)
    throw MaterialError("/shadowing/type", "\"" + shadowing_choice.type +
                                               "\" needs a masking function with a Lambda, and \"" +
                                               description.masking.type +
                                               "\" has none; accepted: none, separable, minimum, direction_correlated");
  Material material{description.name,
                    std::move(distribution),
                    masking,
                    shadowing,
                    make<Fresnel>("fresnel", description.fresnel),
                    make_facet(description)};
  require_cavities(material);
  return material;
}

void set_parameter(MaterialDescription& description, const std::string& key, double value) {
  if (set_in<Distribution>(description.distribution, key, value)) return;
  if (set_in<Masking>(description.masking, key, value)) return;
  if (description.shadowing && set_in<Shadowing>(*description.shadowing, key, value)) return;
  if (set_in<Fresnel>(description.fresnel, key, value)) return;
  throw MaterialError("/distribution", "no model of this material has a parameter \"" + key + "\"");
}

} // namespace brdfplot
