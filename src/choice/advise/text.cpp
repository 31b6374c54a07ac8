#include "choice/advise/text.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace brdfplot::choice {

std::string metric_name(Metric metric) { return metric == Metric::delta_e ? "ΔE_ITP" : "relative radiance"; }

namespace {

std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string short_number(double value) { return formatted("%.3g", value); }
std::string whole(double value) { return formatted("%.0f", value); }
std::string degrees(double radians) { return formatted("%.3g°", radians * 180 / std::numbers::pi); }
std::string percent(double share) { return formatted("%+.1f %%", 100 * share); }

/// Where on the sphere: the angle from the viewer and the azimuth in the picture.
std::string where(const sphere::Place& place) {
  return "θ_o " + degrees(std::asin(std::min(std::hypot(place.x, place.y), 1.0))) + ", at " +
         degrees(std::atan2(place.y, place.x)) + " in the picture";
}

std::string errors_text(const PictureErrors& e) {
  return "p95 " + short_number(e.p95) + ", worst 1 % " + short_number(e.worst) + " (" + where(e.where) + "), light " +
         percent(e.energy);
}

std::string joined_labels(const std::vector<std::string>& labels) {
  std::string out;
  for (const std::string& label : labels) out += (out.empty() ? "" : " · ") + label;
  return out.empty() ? "nothing is simpler" : out;
}

class Writer {
public:
  Writer(const AdviceScene& scene, const MaterialAdvice& advice) : scene_(scene), advice_(advice) {}

  std::string text() {
    out_ = advice_.name + "   (" + scene_.name + ")\n";
    reached();
    answer();
    further();
    untold();
    proof();
    examined();
    return out_;
  }

private:
  void line(const std::string& head, const std::string& body) {
    const std::size_t width = std::max<std::size_t>(10, head.size() + 1);
    out_ += "  " + head + std::string(width - head.size(), ' ') + body + "\n";
  }
  const Model& model(std::size_t k) const { return advice_.models[k]; }
  const PictureErrors& best_known(const Model& m) const { return m.dense ? *m.dense : m.errors; }

  void reached() {
    const ReachedAngles& r = advice_.reached;
    std::string differences;
    for (const auto& [least, most] : r.difference)
      differences +=
          (differences.empty() ? "" : ", ") + (least < most ? degrees(least) + " to " + degrees(most) : degrees(most));
    line("reaches", "θ_o " + degrees(r.least_view) + " to " + degrees(r.largest_view) + ", θ_i " +
                        degrees(r.least_light) + " to " + degrees(r.largest_light) + "; θ_d (the angle of F) only " +
                        differences + ": nothing is said of others");
  }

  void answer() {
    const Model& full = model(advice_.full);
    line("in full", "cost " + whole(full.cost) + ", " + short_number(full.errors.decisive()) + " off by its " +
                        (advice_.ladder.lights.size() > 1 ? "directions of discs" : "rounding"));
    if (!advice_.answer) {
      line("answer", "none within the tolerance");
      return;
    }
    const Model& best = model(*advice_.answer);
    line("answer", "cost " + whole(best.cost) + " of " + whole(full.cost) + " (" + percent(best.cost / full.cost - 1) +
                       ", " + cost_unit(scene_.target) + " for each point)   " + metric_name(scene_.tolerance.metric) +
                       " " + errors_text(best_known(best)) + "   [tolerance " + short_number(scene_.tolerance.value) +
                       ", worst 1 % " + short_number(2 * scene_.tolerance.value) + "]");
    line("", joined_labels(simplifications(advice_, best)));
    if (scene_.budget)
      line("budget", short_number(*scene_.budget) + (advice_.within_budget(scene_) ? ": met" : ": not met"));
  }

  /// What one more step would do.
  void further() {
    if (!advice_.answer) return;
    const std::vector<FurtherStep> steps = further_steps(advice_, *advice_.answer);
    if (steps.empty()) return;
    line("why not less", "");
    for (const FurtherStep& step : steps) {
      const Model& m = model(step.model);
      out_ += "    " + step.label + ": saves " + whole(model(*advice_.answer).cost - m.cost) + ", " +
              errors_text(best_known(m)) + "\n";
    }
  }

  /// Single simplifications of the model in full that the scene hardly tells.
  void untold() {
    std::string out;
    for (const FurtherStep& step : further_steps(advice_, advice_.full))
      if (model(step.model).errors.decisive() < 0.1 * scene_.tolerance.value)
        out += (out.empty() ? "" : " · ") + step.label;
    if (!out.empty()) line("not told", "(alone, below a tenth of the tolerance) " + out);
  }

  void proof() {
    const std::size_t below = advice_.answer ? cheaper() : advice_.models.size();
    std::string text = std::to_string(advice_.ladder_size) + " models; " +
                       (advice_.answer ? "the " + std::to_string(below) + " cheaper ones" : "they are") +
                       " all evaluated at " + std::to_string(advice_.places) + " places";
    if (advice_.best_cheaper) {
      const Model& m = model(*advice_.best_cheaper);
      text += ", the nearest of which is off by " + short_number(decisive(m)) + " (cost " + whole(m.cost) + ")";
    }
    line("proved", text);
    if (!advice_.next_cheaper) return;
    const Model& next = model(*advice_.next_cheaper);
    if (advice_.answer) {
      line("next", "cost " + whole(next.cost) + ": " + joined_labels(simplifications(advice_, next)));
      line("verified", "at " + std::to_string(advice_.dense_places) +
                           " places: " + short_number(decisive(model(*advice_.answer))) + " and (the next cheaper) " +
                           short_number(decisive(next)) + " of " + short_number(scene_.tolerance.value));
    } else if (advice_.best_cheaper) {
      line("nearest", "cost " + whole(model(*advice_.best_cheaper).cost) + ", off by " +
                          short_number(decisive(model(*advice_.best_cheaper))) + ": " +
                          joined_labels(simplifications(advice_, model(*advice_.best_cheaper))));
    }
  }

  /// What the search does not see.
  void examined() {
    if (!advice_.examined || !advice_.answer) return;
    const Examination& e = *advice_.examined;
    if (e.finer)
      line("", "against " + std::to_string(e.finer->directions) + " directions of each disc at " +
                   std::to_string(advice_.places) + " places: " + short_number(e.finer->answer) + " and " +
                   short_number(e.finer->next_cheaper));
    if (e.single)
      line("single", "in single precision, which is what a shader has, the answer is off by " +
                         short_number(e.single->decisive()) + " at " + std::to_string(advice_.places) +
                         " places (in double " + short_number(model(*advice_.answer).errors.decisive()) + ")");
    breaks(e);
    if (e.walk)
      line("walk", "the material in full has " + with_error(e.walk->light) +
                       " of light against all bounces of a walk on its surface, at one place " +
                       with_error(e.walk->largest) + " (" + where(e.walk->where) + "; " +
                       std::to_string(e.walk->places) + " places, ± standard error)");
  }

  void breaks(const Examination& e) {
    std::string text;
    for (const Break& at : e.breaks) {
      const bool same = at.alpha_factor == 1; // NOLINT(clang-diagnostic-float-equal)
      text += (same ? "" : "; with α times " + short_number(at.alpha_factor) + ": ") + short_number(at.difference) +
              " at θ_o " + degrees(at.theta_o) + ", θ_i " + degrees(at.theta_i) + ", azimuths " + degrees(at.azimuth) +
              " apart";
    }
    line("at worst", "under a light of " + short_number(e.irradiance) + " alone, of any direction: " + text);
  }

  static std::string with_error(const simulation::Measured& m) {
    return percent(m.value) + " ± " + formatted("%.1f %%", 100 * m.standard_error);
  }

  std::size_t cheaper() const {
    const double cost = model(*advice_.answer).cost;
    return static_cast<std::size_t>(
        std::ranges::count_if(advice_.models, [&](const Model& m) { return m.cost < cost; }));
  }

  const AdviceScene& scene_;
  const MaterialAdvice& advice_;
  std::string out_;
};

} // namespace

std::string advice_text(const AdviceScene& scene, const MaterialAdvice& advice) { return Writer(scene, advice).text(); }

std::string models_csv(const AdviceScene& scene, const MaterialAdvice& advice) {
  std::string out = "cost,error,p95,worst,light,verified,within,answer,model\n";
  for (std::size_t k = 0; k < advice.models.size(); ++k) {
    const Model& m = advice.models[k];
    const PictureErrors& e = m.dense ? *m.dense : m.errors;
    for (const double value : {m.cost, e.decisive(), e.p95, e.worst, e.energy}) {
      append_number(out, value);
      out += ',';
    }
    const bool within = e.decisive() <= scene.tolerance.value;
    out += std::string(m.dense ? "1" : "0") + "," + (within ? "1" : "0") + "," + (advice.answer == k ? "1" : "0") + ",";
    std::string labels;
    for (const std::string& label : simplifications(advice, m)) labels += (labels.empty() ? "" : "; ") + label;
    out += '"' + labels + "\"\n";
  }
  return out;
}

} // namespace brdfplot::choice
