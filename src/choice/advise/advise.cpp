#include "choice/advise/advise.hpp"

#include "base/errors.hpp"
#include "base/threads/parallel.hpp"
#include "choice/advise/images/reference.hpp"
#include "choice/advise/refit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>

namespace brdfplot::choice {

double decisive(const Model& model) { return (model.dense ? *model.dense : model.errors).decisive(); }

Drawing drawing_of(const MaterialAdvice& advice, const Model& model) {
  return {advice.ladder.lights[model.light], advice.ladder.rungs[model.rung].drafts[0].precision};
}

namespace {

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

/// A model before it is evaluated: what it costs is known.
struct Planned {
  std::size_t rung, light;
  double cost;
};

class Search {
public:
  Search(const AdviceScene& scene, const AdvisedMaterial& material, const AdviceOptions& options)
      : scene_(scene), options_(options) {
    advice_.name = material.material.name;
    advice_.ladder = ladder_of(material, scene.lights, scene.target);
    for (const MaterialDescription& variant : advice_.ladder.variants) {
      references_.emplace_back(variant, scene, 1.0, 0, options.threads);
      coarse_.emplace_back(variant, scene, 0.4, references_.back().rings, options.threads);
    }
    advice_.places = references_[0].renderer->places().at.size();
    advice_.rings = references_[0].rings;
  }

  MaterialAdvice run() {
    require_light();
    plan();
    walk_up();
    add_steps_of_full();
    sort();
    name_others();
    set_reached();
    return std::move(advice_);
  }

private:
  void require_light() const {
    const Picture& picture = references_[0].picture;
    if (std::ranges::none_of(picture, [](double radiance) { return radiance > 0; }))
      throw InputError(scene_.name, "no light reaches what is seen of \"" + advice_.name + "\"");
  }

  void plan() {
    const Ladder& ladder = advice_.ladder;
    for (std::size_t rung = 0; rung < ladder.rungs.size(); ++rung)
      for (std::size_t light = 0; light < ladder.lights.size(); ++light)
        planned_.push_back({rung, light,
                            shader_cost(ladder.rungs[rung].drafts[0].material, scene_.lights, ladder.lights[light],
                                        {scene_.target, ladder.rungs[rung].drafts[0].precision})});
    std::ranges::stable_sort(planned_, {}, &Planned::cost);
    advice_.ladder_size = planned_.size();
  }

  /// The draft or the draft fitted, whichever is nearer, at fewer places than errors are told of.
  MaterialDescription fitted(const Draft& draft, const Reference& reference, const LightModel& how) const {
    const bool points = how.kind == LightModel::Kind::points;
    const bool smaller = !points && advice_.ladder.lights[0].kind == LightModel::Kind::points;
    const Draft start = smaller ? with_free_roughness(draft) : draft;
    if (start.free.empty()) return start.material;
    // Few directions are enough for a fit, if what it is to be like has the same.
    const LightModel model = points ? LightModel{LightModel::Kind::points, 1} : how;
    const Picture target = points ? reference.renderer->picture(reference.material, model) : reference.picture;
    const MaterialDescription after = refitted(start, *reference.renderer, {target, model, scene_.exposure});
    const auto error = [&](const MaterialDescription& material) {
      return compare(target, reference.renderer->picture(material, model, false), reference.renderer->places(),
                     scene_.tolerance.metric, scene_.exposure)
          .decisive();
    };
    return error(after) < error(start.material) ? after : start.material;
  }

  /// Of each variant. What is fitted is fitted once for all models that sample discs, and once for each other; in
  /// double, since differences are taken.
  std::vector<MaterialDescription> materials_of(const Planned& planned) {
    const LightModel& how = advice_.ladder.lights[planned.light];
    const std::pair key{identity_of(advice_.ladder.rungs[planned.rung].drafts[0].material), static_cast<int>(how.kind)};
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = fits_.find(key); found != fits_.end()) return found->second;
    }
    std::vector<MaterialDescription> out;
    for (std::size_t v = 0; v < coarse_.size(); ++v)
      out.push_back(fitted(advice_.ladder.rungs[planned.rung].drafts[v], coarse_[v], how));
    const std::lock_guard lock(mutex_);
    return fits_.emplace(key, std::move(out)).first->second;
  }

  Model evaluated(const Planned& planned) {
    Model model{planned.rung, planned.light, planned.cost, materials_of(planned), {}};
    model.errors = largest_errors(references_, model.materials, how(model), scene_, true);
    return model;
  }

  Drawing how(const Model& model) const { return drawing_of(advice_, model); }

  void evaluate(const std::vector<Planned>& some) {
    std::vector<Model> found(some.size());
    const std::size_t before = advice_.models.size();
    std::size_t done = 0;
    parallel_for(some.size(), options_.threads, [&](std::size_t k) {
      found[k] = evaluated(some[k]);
      const std::lock_guard lock(progress_);
      if (options_.progress) options_.progress(before + ++done, planned_.size());
    });
    for (Model& model : found) advice_.models.push_back(std::move(model));
  }

  /// From the cheapest on, in blocks that do not depend on the number of threads, until one is within the tolerance.
  void walk_up() {
    constexpr std::size_t block = 32;
    for (std::size_t first = 0; first < planned_.size() && !answer_; first += block) {
      const auto begin = planned_.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = planned_.begin() + static_cast<std::ptrdiff_t>(std::min(first + block, planned_.size()));
      evaluate({begin, end});
      for (std::size_t k = first; k < advice_.models.size() && !answer_; ++k)
        if (is_within(advice_.models[k])) answer_ = Planned{advice_.models[k].rung, advice_.models[k].light, 0};
    }
    walked_ = advice_.models.size();
  }

  bool is_within(Model& model) {
    if (model.errors.decisive() > doubt * scene_.tolerance.value) return false;
    verify(model);
    return model.dense->decisive() <= scene_.tolerance.value;
  }

  /// The material in full, and each single simplification of it.
  void add_steps_of_full() {
    std::vector<Planned> more;
    for (std::size_t k = walked_; k < planned_.size(); ++k) {
      const std::vector<std::size_t>& levels = advice_.ladder.rungs[planned_[k].rung].levels;
      const auto simpler = std::ranges::count_if(levels, [](std::size_t level) { return level > 0; });
      if (simpler + (planned_[k].light > 0 ? 1 : 0) <= 1) more.push_back(planned_[k]);
    }
    evaluate(more);
  }

  void sort() {
    std::ranges::stable_sort(advice_.models, {}, &Model::cost);
    const auto place = [&](std::size_t rung, std::size_t light) {
      const auto found =
          std::ranges::find_if(advice_.models, [&](const Model& m) { return m.rung == rung && m.light == light; });
      return static_cast<std::size_t>(found - advice_.models.begin());
    };
    advice_.full = place(0, 0);
    if (answer_) advice_.answer = place(answer_->rung, answer_->light);
  }

  void verify(Model& model) {
    if (model.dense) return;
    if (dense_.empty()) {
      for (const Reference& one : references_)
        dense_.emplace_back(one.material, scene_, 3.2, one.rings, options_.threads);
      advice_.dense_places = dense_[0].renderer->places().at.size();
    }
    model.dense = largest_errors(dense_, model.materials, how(model), scene_);
  }

  /// The next cheaper one, the nearest of those that are cheaper, and the nearest within the budget.
  void name_others() {
    std::vector<Model>& models = advice_.models;
    const double below = advice_.answer ? models[*advice_.answer].cost : infinity;
    const auto better = [&](std::size_t k, const std::optional<std::size_t>& than) {
      return !than || decisive(models[k]) < decisive(models[*than]);
    };
    for (std::size_t k = 0; k < models.size() && models[k].cost < below; ++k) {
      const auto& next = advice_.next_cheaper;
      const bool dearer = !next || models[*next].cost < models[k].cost;
      if (dearer || better(k, next)) advice_.next_cheaper = k;
      if (better(k, advice_.best_cheaper)) advice_.best_cheaper = k;
      if (scene_.budget && models[k].cost <= *scene_.budget && better(k, advice_.best_in_budget))
        advice_.best_in_budget = k;
    }
    for (const auto& one : {advice_.next_cheaper, advice_.best_cheaper, advice_.best_in_budget})
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
  std::vector<Reference> references_, coarse_, dense_;
  std::vector<Planned> planned_; ///< by ascending cost
  std::size_t walked_ = 0;       ///< so many of them were evaluated on the way to the answer
  std::optional<Planned> answer_;
  std::mutex mutex_, progress_;
  std::map<std::pair<std::string, int>, std::vector<MaterialDescription>> fits_;
};

} // namespace

MaterialAdvice advise(const AdviceScene& scene, const AdvisedMaterial& material, const AdviceOptions& options) {
  return Search(scene, material, options).run();
}

} // namespace brdfplot::choice
