#include "figure/profile/autocorrelation.hpp"

#include "base/errors.hpp"
#include "figure/profile/drawing.hpp"
#include "figure/profile/surface.hpp"

#include <cmath>

namespace brdfplot::plot {

std::optional<ParameterError> problem_of(const AutocorrelationDescription& description) {
  if (auto error = problem_of(description.surface)) return ParameterError{"surface/" + error->key, error->what};
  if (facts_of(description.surface).has_heights) return std::nullopt;
  return ParameterError{"surface", "autocorrelation is known of gaussian, ggx and uncorrelated"};
}

Panel autocorrelation_panel(const PanelDescription& description) {
  const AutocorrelationDescription& what = description.autocorrelation.value();
  if (const auto error = problem_of(what)) throw InputError(error->key, error->what);
  const Cuts cuts(what.surface, what.seed, what.along_y);
  Panel panel;
  panel.title = description.title;
  panel.x = description.x;
  panel.y = description.y;

  Series measured;
  measured.label = "measured";
  std::vector<std::size_t> distances;
  for (double d = std::ceil(panel.x.from); d <= panel.x.to; ++d) {
    measured.x.push_back(d);
    distances.push_back(static_cast<std::size_t>(d));
  }
  for (const double value : autocorrelation(cuts, distances)) measured.y.push_back(rounded_coordinate(value));
  panel.series.push_back(std::move(measured));

  if (const auto& law = cuts.law()) {
    constexpr int points = 129;
    const bool gaussian = law->shape == simulation::Autocorrelation::gaussian;
    Series asked;
    asked.label = gaussian ? "exp(−d^2/L^2)" : "exp(−d/L)";
    asked.style = 1;
    for (int k = 0; k < points; ++k) {
      asked.x.push_back(std::lerp(panel.x.from, panel.x.to, k / (points - 1.0)));
      asked.y.push_back(law->at(asked.x.back()));
    }
    panel.series.push_back(std::move(asked));
  }
  return panel;
}

} // namespace brdfplot::plot
