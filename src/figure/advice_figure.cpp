#include "figure/advice_figure.hpp"

#include "choice/advise/text.hpp"
#include "figure/cost_chart.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::plot {

namespace {

std::string joined_names(const std::vector<std::string>& labels) {
  std::string out;
  for (const std::string& label : labels) out += (out.empty() ? "" : ", ") + label;
  return out.empty() ? "in full" : out;
}

/// Costs ascend: a model is on the front when none before it has a smaller error.
void mark_front(std::vector<CostPoint>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (CostPoint& point : points) {
    point.on_front = point.error < least;
    least = std::min(least, point.error);
  }
}

/// Whether two dots would cover each other.
bool covers(const CostPoint& a, const CostPoint& b) {
  constexpr double width = 1.04;
  const auto near = [](double u, double v) { return std::max(u, v) <= width * std::min(u, v); };
  return a.group == b.group && near(a.cost, b.cost) && near(a.error, b.error);
}

/// Without the nameless ones that others cover, and those that cost many times as much as the answer.
std::vector<CostPoint> thinned(const std::vector<CostPoint>& points, double most_cost) {
  std::vector<CostPoint> out;
  for (const CostPoint& point : points) {
    if (point.cost > most_cost) continue;
    const bool covered =
        point.name.empty() && std::ranges::any_of(out, [&](const CostPoint& kept) { return covers(kept, point); });
    if (!covered) out.push_back(point);
  }
  return out;
}

} // namespace

Figure advice_figure(const choice::AdviceScene& scene, const choice::MaterialAdvice& advice, const std::string& id) {
  CostChart chart;
  for (std::size_t k = 0; k < advice.models.size(); ++k) {
    const choice::Model& model = advice.models[k];
    CostPoint point{"", model.cost, choice::decisive(model), false, "model"};
    if (!(point.error > 0)) point.name = joined_names(choice::simplifications(advice, model));
    if (k == advice.full) {
      point.name = "in full";
      point.group = "in full";
    }
    chart.points.push_back(std::move(point));
  }
  if (advice.answer) {
    for (const choice::FurtherStep& step : choice::further_steps(advice, *advice.answer)) {
      chart.points[step.model].name = step.label;
      chart.points[step.model].group = "one step further";
    }
    if (advice.next_cheaper) {
      chart.points[*advice.next_cheaper].name = "next cheaper";
      chart.points[*advice.next_cheaper].group = "next cheaper";
    }
    chart.points[*advice.answer].name = "answer";
    chart.points[*advice.answer].group = "answer";
  }
  mark_front(chart.points);
  constexpr double shown_beyond_answer = 3;
  chart.points =
      thinned(chart.points, advice.answer ? shown_beyond_answer * advice.models[*advice.answer].cost : infinity);
  chart.cost = {.label = choice::cost_unit(scene.target) + " of a shaded point", .column = "cost"};
  const bool delta_e = scene.tolerance.metric == choice::Metric::delta_e;
  chart.error = {.label = std::string(delta_e ? "ΔE_{ITP}" : "relative radiance") + ": p95, or half of the worst 1 %",
                 .column = "error"};
  chart.tolerance = scene.tolerance.value;
  return cost_figure(
      {chart}, id, "The least model: " + advice.name + " (" + scene.name + ")",
      "Error of a lit sphere against what shading a point costs, for the models that are simpler than the "
      "material in full.");
}

} // namespace brdfplot::plot
