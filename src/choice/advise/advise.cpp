#include "choice/advise/advise.hpp"

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "choice/advise/refit.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace brdfplot::choice {

double decisive(const Model& model) { return (model.dense ? *model.dense : model.errors).decisive(); }

namespace {

/// The roughest and the smoothest lobe of a material.
Fineness fineness_of(const MaterialDescription& material, double scale) {
  Fineness out{scale, 1, 0};
  for (const WeightedTerm& term : build(material).terms) {
    if (term.facets() == nullptr) continue;
    const SlopeMap map = std::visit([](const auto& d) { return d.slopes; }, *term.facets());
    out.least_alpha = std::min({out.least_alpha, map.alpha_x, map.alpha_y});
    out.largest_alpha = std::max({out.largest_alpha, std::min(1.0, map.alpha_x), std::min(1.0, map.alpha_y)});
  }
  out.largest_alpha = std::max(out.largest_alpha, out.least_alpha);
  return out;
}

/// A variant with the picture that it has in full.
struct Reference {
  MaterialDescription material;
  std::unique_ptr<Renderer> renderer;
  Picture picture;
  std::size_t rings = 0;

  Reference(const MaterialDescription& of, const AdviceScene& scene, double scale, std::size_t finer)
      : material(of), renderer(std::make_unique<Renderer>(
                          scene.lights, places_on_sphere(scene.view, scene.lights, fineness_of(of, scale)))) {
    picture = reference_picture(*renderer, material, scene, rings);
    if (finer == 0) return;
    const bool discs = std::ranges::any_of(scene.lights, [](const AdviceLight& light) { return light.radius > 0; });
    if (discs) picture = renderer->picture(material, {LightModel::Kind::points, rings *= finer}, false);
  }

  PictureErrors errors(const MaterialDescription& other, const LightModel& light, const AdviceScene& scene,
                       bool remember) const {
    return compare(picture, renderer->picture(other, light, remember), renderer->places(), scene.tolerance.metric,
                   scene.exposure);
  }
};

/// Roughness may stand for the size of a light.
Draft with_free_roughness(Draft draft) {
  for (const TermDescription& term : draft.material.terms) {
    const bool has = term.distribution.values.has("alpha") || term.distribution.values.has("alpha_x");
    const bool tabulated = std::ranges::any_of(
        draft.material.terms, [&](const TermDescription& other) { return other.of_name == term.name; });
    if (term.type == "mirror" && has && !tabulated) draft.set_free(term.name, "alpha");
  }
  return draft;
}

class Search {
public:
  Search(const AdviceScene& scene, const AdvisedMaterial& material, const AdviceOptions& options)
      : scene_(scene), options_(options) {
    advice_.name = material.material.name;
    advice_.ladder = ladder_of(material, scene.lights);
    for (const MaterialDescription& variant : advice_.ladder.variants) references_.emplace_back(variant, scene, 1.0, 0);
    advice_.places = references_[0].renderer->places().at.size();
    advice_.rings = references_[0].rings;
  }

  MaterialAdvice run() {
    require_light();
    evaluate_all();
    sort();
    decide();
    set_reached();
    return std::move(advice_);
  }

private:
  void require_light() const {
    const Picture& picture = references_[0].picture;
    if (std::ranges::none_of(picture, [](double radiance) { return radiance > 0; }))
      throw InputError(scene_.name, "no light reaches what is seen of \"" + advice_.name + "\"");
  }

  /// One rung under all lights. What is fitted is fitted once for all that sample discs, and once for each other.
  std::vector<Model> evaluate_rung(std::size_t rung) const {
    std::vector<Model> out;
    for (std::size_t light = 0; light < advice_.ladder.lights.size(); ++light) {
      const LightModel& how = advice_.ladder.lights[light];
      Model model{rung, light, 0, {}, {}};
      const bool as_before = how.kind == LightModel::Kind::points && light > 0;
      for (std::size_t v = 0; v < references_.size(); ++v) {
        const Draft& draft = advice_.ladder.rungs[rung].drafts[v];
        model.materials.push_back(as_before ? out[0].materials[v] : fitted(draft, references_[v], how));
        const PictureErrors errors = references_[v].errors(model.materials[v], how, scene_, true);
        if (v == 0 || errors.decisive() > model.errors.decisive()) model.errors = errors;
      }
      model.cost = shader_cost(model.materials[0], scene_.lights, how);
      out.push_back(std::move(model));
    }
    return out;
  }

  /// The draft or the draft fitted, whichever is nearer.
  MaterialDescription fitted(const Draft& draft, const Reference& reference, const LightModel& how) const {
    const bool points = how.kind == LightModel::Kind::points;
    const bool smaller = !points && advice_.ladder.lights[0].kind == LightModel::Kind::points;
    const Draft start = smaller ? with_free_roughness(draft) : draft;
    if (start.free.empty()) return start.material;
    // Few directions are enough for a fit, if what it is to be like has the same.
    const LightModel model = points ? LightModel{LightModel::Kind::points, 2} : how;
    const Picture target = points ? reference.renderer->picture(reference.material, model) : reference.picture;
    const MaterialDescription after = refitted(start, *reference.renderer, {target, model, scene_.exposure});
    const auto error = [&](const MaterialDescription& material) {
      return compare(target, reference.renderer->picture(material, model), reference.renderer->places(),
                     scene_.tolerance.metric, scene_.exposure)
          .decisive();
    };
    return error(after) < error(start.material) ? after : start.material;
  }

  void evaluate_all() {
    const std::size_t rungs = advice_.ladder.rungs.size(), lights = advice_.ladder.lights.size();
    std::vector<std::vector<Model>> found(rungs);
    std::mutex mutex;
    std::size_t done = 0;
    parallel_for(rungs, options_.threads, [&](std::size_t k) {
      found[k] = evaluate_rung(k);
      const std::lock_guard lock(mutex);
      done += lights;
      if (options_.progress) options_.progress(done, rungs * lights);
    });
    for (std::vector<Model>& some : found)
      for (Model& model : some) advice_.models.push_back(std::move(model));
  }

  void sort() {
    std::ranges::stable_sort(advice_.models, [](const Model& a, const Model& b) {
      return a.cost < b.cost || (!(b.cost < a.cost) && a.errors.decisive() < b.errors.decisive());
    });
    const auto full = std::ranges::find_if(advice_.models, [](const Model& m) { return m.rung == 0 && m.light == 0; });
    advice_.full = static_cast<std::size_t>(full - advice_.models.begin());
  }

  void verify(Model& model) {
    if (model.dense) return;
    if (dense_.empty()) {
      for (const MaterialDescription& variant : advice_.ladder.variants) dense_.emplace_back(variant, scene_, 3.2, 2);
      advice_.dense_places = dense_[0].renderer->places().at.size();
      advice_.dense_rings = dense_[0].rings;
    }
    for (std::size_t v = 0; v < dense_.size(); ++v) {
      const PictureErrors errors =
          dense_[v].errors(model.materials[v], advice_.ladder.lights[model.light], scene_, false);
      if (!model.dense || errors.decisive() > model.dense->decisive()) model.dense = errors;
    }
  }

  void decide() {
    std::vector<Model>& models = advice_.models;
    for (std::size_t k = 0; k < models.size() && !advice_.answer; ++k) {
      if (models[k].errors.decisive() > doubt * scene_.tolerance.value) continue;
      verify(models[k]);
      if (models[k].dense->decisive() <= scene_.tolerance.value) advice_.answer = k;
    }
    const std::size_t end = advice_.answer ? *advice_.answer : models.size();
    for (std::size_t k = 0; k < end; ++k) {
      if (advice_.answer && !(models[k].cost < models[end].cost)) break;
      const auto better = [&](const std::optional<std::size_t>& than) {
        return !than || decisive(models[k]) < decisive(models[*than]);
      };
      if (better(advice_.best_cheaper)) advice_.best_cheaper = k;
      if (!advice_.next_cheaper || models[*advice_.next_cheaper].cost < models[k].cost) advice_.next_cheaper = k;
      if (scene_.budget && models[k].cost <= *scene_.budget && better(advice_.best_in_budget))
        advice_.best_in_budget = k;
    }
    for (const auto& one : {advice_.next_cheaper, advice_.best_cheaper})
      if (one) verify(models[*one]);
  }

  void set_reached() {
    const Reference& reference = references_[0];
    const Places& places = reference.renderer->places();
    ReachedAngles& out = advice_.reached;
    out.least_view = out.least_light = std::numbers::pi;
    for (std::size_t k = 0; k < places.at.size(); ++k) {
      const Rgb rgb = colour_at(reference.picture, places.at.size(), k);
      if (!(std::max({rgb[0], rgb[1], rgb[2]}) > 0)) continue;
      const Direction normal = sphere::frame_at(places.at[k]).normal;
      const double view = std::acos(std::min(normal.z, 1.0));
      out.least_view = std::min(out.least_view, view);
      out.largest_view = std::max(out.largest_view, view);
      for (const AdviceLight& light : scene_.lights) {
        const double c = dot(normal, from_angles(light.theta, light.phi));
        if (!(c > 0)) continue;
        out.least_light = std::min(out.least_light, std::acos(std::min(c, 1.0)));
        out.largest_light = std::max(out.largest_light, std::acos(std::min(c, 1.0)));
      }
    }
    for (const AdviceLight& light : scene_.lights)
      out.difference.emplace_back(0.5 * std::max(light.theta - light.radius, 0.0), 0.5 * (light.theta + light.radius));
  }

  const AdviceScene& scene_;
  const AdviceOptions& options_;
  MaterialAdvice advice_;
  std::vector<Reference> references_, dense_;
};

} // namespace

MaterialAdvice advise(const AdviceScene& scene, const AdvisedMaterial& material, const AdviceOptions& options) {
  return Search(scene, material, options).run();
}

std::vector<std::string> simplifications(const MaterialAdvice& advice, const Model& model) {
  std::vector<std::string> out;
  const std::vector<std::size_t>& levels = advice.ladder.rungs[model.rung].levels;
  for (std::size_t k = 0; k < levels.size(); ++k)
    if (levels[k] > 0) out.push_back(advice.ladder.options[k].steps[levels[k] - 1].label);
  if (advice.ladder.lights.size() > 1) out.push_back(advice.ladder.light_labels[model.light]);
  return out;
}

std::vector<FurtherStep> further_steps(const MaterialAdvice& advice, std::size_t from) {
  const Model& start = advice.models[from];
  const std::vector<std::size_t>& levels = advice.ladder.rungs[start.rung].levels;
  std::vector<FurtherStep> out;
  for (std::size_t k = 0; k < advice.models.size(); ++k) {
    const Model& model = advice.models[k];
    if (!(model.cost < start.cost)) continue;
    const std::vector<std::size_t>& other = advice.ladder.rungs[model.rung].levels;
    std::size_t changed = 0, last = 0;
    for (std::size_t i = 0; i < levels.size(); ++i)
      if (other[i] != levels[i]) {
        ++changed;
        last = i;
      }
    const bool light = model.light != start.light;
    if (changed + (light ? 1 : 0) != 1) continue;
    const std::string label = light ? advice.ladder.light_labels[model.light]
                              : other[last] > 0 ? advice.ladder.options[last].steps[other[last] - 1].label
                                                : advice.ladder.options[last].name + ": as in full";
    out.push_back({label, k});
  }
  std::ranges::stable_sort(out, [&](const FurtherStep& a, const FurtherStep& b) {
    return advice.models[a.model].cost > advice.models[b.model].cost;
  });
  return out;
}

} // namespace brdfplot::choice
