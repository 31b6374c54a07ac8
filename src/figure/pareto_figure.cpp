#include "figure/pareto_figure.hpp"

#include "figure/cost_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace brdfplot::plot {

namespace {

/// An error above this says no more than that there is nothing right.
constexpr double hopeless = 10;

/// A point, within the chart where its error is hopeless: then its name tells it.
CostPoint point_of(const choice::ProblemResult& result, std::size_t k, choice::CostKind cost, choice::ErrorKind error) {
  const choice::Method& method = result.methods[k].method;
  CostPoint point{.name = method.name,
                  .cost = result.cost_of(k, cost),
                  .error = result.error_of(k, error),
                  .on_front = result.front(cost, error).on_front[k],
                  .group = std::string(kind_word(method.kind)),
                  .cost_to = cost == choice::CostKind::measured ? result.methods[k].time->upper_quartile : 0};
  if (!(point.error > hopeless) || std::isinf(point.error)) return point;
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), " (%.0e)", point.error);
  point.name += text.data();
  point.error = hopeless;
  return point;
}

CostChart chart_of(const choice::ProblemResult& result, choice::CostKind cost, choice::ErrorKind error) {
  const bool relative = error == choice::ErrorKind::relative;
  const std::string of = result.problem.seen_as.empty() ? "the value" : result.problem.seen_as;
  CostChart chart;
  chart.cost =
      cost == choice::CostKind::counted
          ? Axis{.label = "cost, in " + (result.problem.cost_unit.empty() ? "multiply-adds of floats, estimated"
                                                                          : result.problem.cost_unit),
                 .column = "cost"}
          : Axis{.label = "least time of a value, in ns", .column = "ns"};
  chart.title = relative ? "Relative error" : "Error of " + of;
  chart.error = {.label = relative ? "largest relative error" : "largest error of " + of, .column = "error"};
  for (std::size_t k = 0; k < result.methods.size(); ++k) {
    const choice::Method& method = result.methods[k].method;
    if (cost == choice::CostKind::counted && !method.portable) continue;
    chart.points.push_back(point_of(result, k, cost, error));
  }
  return chart;
}

Figure figure_of(const choice::ProblemResult& result, choice::CostKind cost, const std::string& suffix,
                 const std::string& place) {
  const choice::Problem& problem = result.problem;
  return cost_figure(
      {chart_of(result, cost, choice::ErrorKind::absolute), chart_of(result, cost, choice::ErrorKind::relative)},
      problem.name + suffix, problem.doc + ": " + place,
      "Cost of one value against the largest error found at " + std::to_string(result.samples) +
          " inputs over the whole domain, and by a search from the worst of them. An error above 10 is drawn at 10, "
          "with its size in brackets.");
}

} // namespace

std::string_view kind_word(choice::Kind kind) {
  switch (kind) {
  case choice::Kind::kernel: return "kernel";
  case choice::Kind::printed: return "as printed";
  case choice::Kind::rewritten: return "rewritten";
  case choice::Kind::approximation: return "published approximation";
  case choice::Kind::fit: return "rational fit";
  case choice::Kind::table: return "table";
  case choice::Kind::quadrature: return "quadrature";
  }
  return {};
}

Figure pareto_figure(const choice::ProblemResult& result) {
  Figure figure = figure_of(result, choice::CostKind::counted, "_cost", "estimated cost");
  const auto portable = [](const choice::MethodResult& m) { return m.method.portable; };
  if (!std::ranges::all_of(result.methods, portable))
    figure.description += " Kernels of instruction sets are in the table alone.";
  return figure;
}

Figure pareto_figure(const choice::ProblemResult& result, const choice::MachineRecord& machine) {
  Figure figure = figure_of(result, choice::CostKind::measured, "_time", machine.text());
  figure.description += " Lines run from the least time to the upper quartile.";
  return figure;
}

} // namespace brdfplot::plot
