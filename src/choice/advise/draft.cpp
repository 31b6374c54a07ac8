#include "choice/advise/draft.hpp"

#include "base/number.hpp"
#include "microfacet/distributions.hpp"

#include <algorithm>
#include <set>

namespace brdfplot::choice {

TermDescription* Draft::find(const std::string& term) {
  const auto found = std::ranges::find(material.terms, term, &TermDescription::name);
  return found != material.terms.end() ? &*found : nullptr;
}

void Draft::set_free(const std::string& term, const std::string& key) {
  const FreeParameter one{term, key};
  if (std::ranges::find(free, one) == free.end()) free.push_back(one);
}

void Draft::remove(const std::function<bool(const TermDescription&)>& which) {
  std::set<std::string> gone;
  for (const TermDescription& term : material.terms)
    if (which(term)) gone.insert(term.name);
  std::erase_if(material.terms, [&](const TermDescription& term) {
    const std::string& of = term.of_name.empty() && !term.of.empty() ? term.of[0].name : term.of_name;
    return gone.contains(term.name) || gone.contains(of);
  });
  std::erase_if(free, [&](const FreeParameter& one) { return find(one.term) == nullptr; });
}

namespace {

/// The values of a distribution whose roughness may be written in many ways, as alpha or alpha_x and alpha_y.
void make_canonical(ModelChoice& choice) {
  const auto& specs = specs_of<Distribution>();
  const auto spec = std::ranges::find(specs, choice.type, &ModelSpec::type);
  if (spec == specs.end() || spec->find("alpha_x") == nullptr) return;
  const auto distribution = make_or_throw<Distribution>("distribution", choice);
  const SlopeMap map = std::visit([](const auto& d) { return d.slopes; }, distribution);
  const std::vector<ParameterSpec> of_map = SlopeMap::parameters();
  Values values;
  for (const auto& [key, value] : choice.values.map())
    if (std::ranges::find(of_map, key, &ParameterSpec::key) == of_map.end()) values.set(key, value);
  if (map.alpha_x == map.alpha_y) { // NOLINT(clang-diagnostic-float-equal)
    values.set("alpha", map.alpha_x);
  } else {
    values.set("alpha_x", map.alpha_x);
    values.set("alpha_y", map.alpha_y);
  }
  if (map.correlation != 0) values.set("correlation", map.correlation);
  if (!map.centred()) values.set("mean_slope", Vec2{map.mean_x, map.mean_y});
  choice.values = values;
}

void make_canonical(TermDescription& term) {
  if (term.name.empty()) term.name = term.type;
  if (!term.distribution.type.empty()) make_canonical(term.distribution);
  for (TermDescription& other : term.of) make_canonical(other);
}

void append(std::string& out, const ModelChoice& choice);

void append(std::string& out, const Value& value) {
  std::visit(
      [&]<class T>(const T& v) {
        if constexpr (std::is_same_v<T, double>) {
          append_number(out, v);
        } else if constexpr (std::is_same_v<T, std::string>) {
          out += '"' + v + '"';
        } else if constexpr (std::is_same_v<T, bool>) {
          out += v ? "true" : "false";
        } else if constexpr (std::is_same_v<T, WeightedChoices>) {
          for (const WeightedChoice& one : v) {
            append_number(out, one.weight);
            append(out, one.model);
          }
        } else {
          for (const double x : v) {
            append_number(out, x);
            out += ',';
          }
        }
      },
      value);
}

void append(std::string& out, const Values& values) {
  out += '{';
  for (const auto& [key, value] : values.map()) {
    out += key + ':';
    append(out, value);
    out += ';';
  }
  out += '}';
}

void append(std::string& out, const ModelChoice& choice) {
  out += choice.type;
  append(out, choice.values);
}

} // namespace

MaterialDescription canonical(MaterialDescription material) {
  for (TermDescription& term : material.terms) make_canonical(term);
  material.listed = true;
  return material;
}

std::string identity_of(const TermDescription& term) {
  std::string out = term.name + '=' + term.type + '*';
  append(out, term.weight);
  append(out, term.values);
  append(out, term.distribution);
  append(out, term.masking);
  if (term.shadowing) append(out, *term.shadowing);
  append(out, term.fresnel);
  out += '/' + term.of_name;
  for (const TermDescription& other : term.of) out += '(' + identity_of(other) + ')';
  for (const LayerDescription& layer : term.layers) {
    out += '<' + layer.name + ',' + layer.coat + ',';
    append(out, layer.weight);
    append(out, layer.values);
    out += '>';
  }
  return out;
}

std::string identity_of(const MaterialDescription& material) {
  std::string out;
  for (const TermDescription& term : material.terms) out += identity_of(term) + '\n';
  return out;
}

std::string identity_of(const Draft& draft) {
  return identity_of(draft.material) + (draft.precision == Precision::single ? "single" : "full");
}

} // namespace brdfplot::choice
