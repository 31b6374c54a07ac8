#include "choice/advise/shader/cost.hpp"

#include "base/errors.hpp"
#include "choice/advise/shader/flat.hpp"
#include "choice/advise/shader/mirror.hpp"

#include <algorithm>

namespace brdfplot::choice {

namespace {

using forms::Counted3;

/// What coats take from the terms beneath them, at the viewer or at a light: a factor once for all terms of a coat.
class CoatForms {
public:
  explicit CoatForms(const MaterialDescription& material) : material_(material) {}

  void view(const TermDescription& term) const {
    for_each(term, [&](const LayerDescription& layer, const TermDescription& coat) {
      const std::string how = attenuation_of(layer);
      if (how == "both" || how == "half") by_fresnel(coat);
      if (how == "albedo") forms::read_table(1);
      if (tinted(layer)) (void)(Counted(1.5) / sqrt(Counted(1.25) + Counted(0.5) * Counted(0.5)));
    });
  }
  void light(const TermDescription& term, int channels) const {
    for_each(term, [&](const LayerDescription& layer, const TermDescription& coat) {
      const std::string how = attenuation_of(layer);
      if (how == "both") by_fresnel(coat);
      if (how == "albedo") {
        forms::read_table(1);
        (void)min(Counted(0.5), Counted(0.6));
      }
      if (!tinted(layer)) return;
      const Counted path = Counted(1.5) / sqrt(Counted(1.25) + Counted(0.5) * Counted(0.5)) + Counted(1.0);
      for (int c = 0; c < 3; ++c) (void)(Counted(0.5) * exp2(path * Counted(-0.5)));
    });
    for (const LayerDescription& layer : term.layers) // F(o.h) of `half_vector` is the coat's own
      for (int c = 0; c < channels && !layer.coat.empty() && attenuation_of(layer) != "none"; ++c)
        (void)(Counted(0.5) * Counted(0.5));
  }

private:
  /// Of the layers that are met first with this term.
  template <class Visit>
  void for_each(const TermDescription& term, const Visit& visit) const {
    for (const LayerDescription& layer : term.layers) {
      if (layer.coat.empty()) continue;
      const auto coat = std::ranges::find(material_.terms, layer.coat, &TermDescription::name);
      const auto first = std::ranges::find_if(material_.terms, [&](const TermDescription& other) {
        return std::ranges::any_of(other.layers,
                                   [&](const auto& l) { return l.name == layer.name && !l.coat.empty(); });
      });
      if (coat != material_.terms.end() && first->name == term.name) visit(layer, *coat);
    }
  }
  static std::string attenuation_of(const LayerDescription& layer) {
    return layer.values.has("attenuation") ? layer.values.text("attenuation") : "both";
  }
  static bool tinted(const LayerDescription& layer) {
    return layer.values.has("tint") && layer.values.rgb("tint") != Rgb{1, 1, 1};
  }
  /// 1 - w F of each channel that F has.
  static void by_fresnel(const TermDescription& coat) {
    forms::fresnel(coat.fresnel);
    for (int c = 0; c < forms::channels_of(coat.fresnel); ++c) (void)(Counted(1) - Counted(0.5) * Counted(0.5));
  }

  const MaterialDescription& material_;
};

bool is_flat(const TermDescription& term) { return term.type != "mirror" && term.type != "kelemen"; }

/// Runs `part` with every term, coats included, and returns what it counted.
template <class Part>
Operations counted_over(const MaterialDescription& material, const Part& part) {
  Counted::reset();
  for (const TermDescription& term : material.terms) part(term);
  return Counted::operations();
}

int channels_of_term(const TermDescription& term) {
  const bool weight = std::holds_alternative<Rgb>(term.weight);
  const bool values = std::ranges::any_of(term.values.map(),
                                          [](const auto& entry) { return std::holds_alternative<Rgb>(entry.second); });
  return weight || values || forms::channels_of(term.fresnel) == 3 ? 3 : 1;
}

/// The directions of a light: c_i and, where facets or flat terms ask for it, the half vector with its cosines.
void directions(const MaterialDescription& material) {
  const bool half = std::ranges::any_of(
      material.terms, [](const TermDescription& term) { return !is_flat(term) || forms::needs_half_vector(term); });
  if (!half) return;
  const Counted3 o = forms::viewer(), i = forms::light();
  (void)forms::dot(o, forms::half_vector(o, i));
}

/// What one term adds to the radiance of a light.
void light_of(const TermDescription& term) {
  is_flat(term) ? forms::flat_light(term) : forms::mirror_light(term);
  const int channels = channels_of_term(term);
  const bool weighted = std::holds_alternative<Rgb>(term.weight) || std::get<double>(term.weight) != 1;
  // times the weight where it is none, and into the sum; c_i and the light's colour are common
  for (int c = 0; c < channels; ++c) {
    if (weighted && !is_flat(term)) (void)(Counted(0.5) * Counted(0.5));
    (void)(Counted(0.5) + Counted(0.5));
  }
}

} // namespace

ShaderOperations shader_operations(const MaterialDescription& material) {
  const CoatForms coats(material);
  ShaderOperations out;
  out.view = counted_over(material, [&](const TermDescription& term) {
    is_flat(term) ? forms::flat_view(term) : forms::mirror_view(term);
    coats.view(term);
  });
  out.light = counted_over(material, [&](const TermDescription& term) {
    light_of(term);
    coats.light(term, channels_of_term(term));
  });
  Counted::reset();
  directions(material);
  for (int c = 0; c < 3; ++c) (void)(Counted(0.5) * Counted(0.5) + Counted(0.5)); // times c_i E, into the sum
  out.light += Counted::operations();
  return out;
}

namespace {

/// Beside the shading of a nearest point: where it is, and the flat terms at the middle.
Operations nearest_operations() {
  Counted::reset();
  const Counted3 r = forms::viewer(), middle = forms::light();
  (void)forms::nearest_in_disc(r, middle, Counted(0.1));
  (void)(Counted(0.5) * Counted(0.5)); // of the widened lobe
  return Counted::operations();
}

} // namespace

double shader_cost(const MaterialDescription& material, const std::vector<AdviceLight>& lights, const LightModel& model,
                   const Machine& machine) {
  const ShaderOperations operations = shader_operations(material);
  const auto of = [&](const Operations& some) { return cost(some, machine.target, machine.precision); };
  double total = of(operations.view);
  for (const AdviceLight& light : lights) {
    const bool disc = light.radius > 0 && model.kind != LightModel::Kind::punctual;
    const bool points = disc && model.kind == LightModel::Kind::points;
    const auto count = static_cast<double>(points ? 4 * model.rings * model.rings : 1);
    total += count * of(operations.light);
    if (disc && !points) total += of(nearest_operations());
  }
  return total;
}

} // namespace brdfplot::choice
