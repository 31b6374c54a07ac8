#include "figure/profile/panel.hpp"

#include "base/errors.hpp"
#include "draw/number_text.hpp"
#include "figure/profile/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace brdfplot::plot {

namespace {

// The blanks in "74.6 %" and "Eq. 49: 74.6 %" do not break lines.
std::string percent(double share) { return decimal_label(100 * share, 1) + "\u00a0%"; }

void add_numbers(const ProfileDescription& description, const Cuts& cuts, Panel& panel) {
  const auto cut = static_cast<std::size_t>(description.cut);
  const Distortion distortion{description.stretch, description.shear};
  const auto note = [&](const std::string& text, const std::string& label, double value) {
    panel.notes.push_back({text, label, rounded_coordinate(value), 0});
  };
  const auto all = cuts.surface_of(cut);
  Visibility mean;
  Shares both;
  for (const std::size_t k : all) {
    if (!description.omega_o) break;
    const Profile profile = distortion.of(cuts.profile(k));
    const double theta_o = distortion.of(*description.omega_o);
    mean += measure(profile, theta_o);
    if (description.omega_i) both += measure(profile, theta_o, distortion.of(*description.omega_i));
  }
  const auto count = static_cast<double>(all.size());
  for (const std::string& name : description.numbers) {
    if (name == "autocorrelation") {
      const double value = autocorrelation(cuts, {cuts.correlation_length()}).front();
      const std::string what = cuts.is_independent() ? "neighbouring heights" : "heights one correlation length apart";
      note(what + ": correlation " + decimal_label(value, 2), "autocorrelation", value);
    } else if (name == "theta_m") {
      const double angle = cuts.theta_m(cut);
      note("θ_m = ±" + decimal_label(angle * 180 / std::numbers::pi, 1) + "°", "theta_m", angle);
    } else if (name == "projected_area") {
      const double area = mean.seen_area / count, mesosurface = mean.mesosurface / count;
      note("visible projected area " + decimal_label(area, 4), "projected_area", area);
      note("geometric surface " + decimal_label(mesosurface, 4), "projected_mesosurface", mesosurface);
    } else if (name == "g2") {
      const double share = both.seen / both.facing;
      note("visible and lit: " + percent(share) + " of what faces both", "g2", share);
      const double o = cuts.g1(cut, *description.omega_o, distortion).value();
      const double i = cuts.g1(cut, *description.omega_i, distortion).value();
      const double correlated = 1 / (1 / o + 1 / i - 1);
      note("Smith, separable:\u00a0" + percent(o * i), "g2_separable", o * i);
      note("height-correlated:\u00a0" + percent(correlated), "g2_height_correlated", correlated);
    } else {
      const double share = mean.shares.seen / mean.shares.facing;
      note("visible: " + percent(share) + " of what faces ω_o", "g1", share);
      const auto model = cuts.g1(cut, *description.omega_o, distortion);
      if (!model) continue;
      note((cuts.cavities() ? "Eq.\u00a049:\u00a0" : "Smith:\u00a0") + percent(*model), "g1_model", *model);
    }
  }
}

} // namespace

const std::vector<std::string>& profile_arrows() {
  static const std::vector<std::string> all = {"omega_o", "omega_i", "omega_g", "omega_m"};
  return all;
}

const std::vector<std::string>& profile_numbers() {
  static const std::vector<std::string> all = {"g1", "g2", "projected_area", "autocorrelation", "theta_m"};
  return all;
}

std::optional<ParameterError> problem_of(const ProfileDescription& description) {
  const auto has = [](const std::vector<std::string>& list, const char* name) {
    return std::ranges::find(list, name) != list.end();
  };
  const Distortion distortion{description.stretch, description.shear};
  for (const auto& [key, theta] :
       {std::pair{"omega_o", description.omega_o}, std::pair{"omega_i", description.omega_i}}) {
    if (!theta) continue;
    if (!(std::cos(*theta) > 0))
      return ParameterError{key, "below the horizon; accepted: an angle between -90deg and 90deg"};
    if (!(std::cos(distortion.of(*theta)) > 0))
      return ParameterError{"shear", "it takes " + std::string(key) + " below the horizontal; accepted: less"};
  }
  if (!description.omega_o) {
    const bool needed = description.rays > 0 || description.paths > 0 || description.projection ||
                        description.omega_i || has(description.arrows, "omega_o") || has(description.numbers, "g1") ||
                        has(description.numbers, "g2") || has(description.numbers, "projected_area");
    if (needed) return ParameterError{"", "\"omega_o\" is missing, which the rest of the profile asks for"};
  }
  for (const auto& [key, list, name] :
       {std::tuple{"arrows", &description.arrows, "omega_i"}, std::tuple{"numbers", &description.numbers, "g2"}})
    if (has(*list, name) && !description.omega_i)
      return ParameterError{key, "\"" + std::string(name) + "\" needs \"omega_i\""};
  if (auto error = problem_of(description.surface)) return ParameterError{"surface/" + error->key, error->what};
  if (static_cast<std::size_t>(description.cut) >= cut_count(description.surface))
    return ParameterError{"cut", "found " + std::to_string(description.cut) + "; accepted: a whole number below " +
                                     std::to_string(cut_count(description.surface))};
  const SurfaceFacts facts = facts_of(description.surface);
  for (const auto& [key, count] : {std::pair{"rays", description.rays}, {"paths", description.paths}})
    if (!facts.joined && count > 0)
      return ParameterError{key, "facets that are independent stop no rays; accepted: a joined surface"};
  for (const char* number : {"autocorrelation", "g2"})
    if (!facts.has_heights && has(description.numbers, number))
      return ParameterError{"numbers", "\"" + std::string(number) + "\" is known of gaussian, ggx and uncorrelated"};
  if (!facts.cavities && has(description.numbers, "theta_m"))
    return ParameterError{"numbers", "\"theta_m\" is known of v_cavity"};
  return std::nullopt;
}

Panel profile_panel(const PanelDescription& description) {
  const ProfileDescription& profile = description.profile.value();
  if (const auto error = problem_of(profile)) throw InputError(error->key, error->what);
  const Cuts cuts(profile.surface, profile.seed, profile.along_y);
  Panel panel;
  panel.title = description.title;
  panel.x = description.x;
  panel.y = description.y;
  const Profile drawn = cuts.profile(static_cast<std::size_t>(profile.cut));
  panel.series = parts_of(profile, drawn);
  panel.sketch = sketch_of(profile, drawn);
  add_numbers(profile, cuts, panel);
  return panel;
}

} // namespace brdfplot::plot
