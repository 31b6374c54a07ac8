#include "figure/pareto_figure.hpp"

#include "figure/cost_chart.hpp"

namespace brdfplot::plot {

namespace {

CostChart chart_of(const choice::ProblemResult& result, choice::CostKind cost, choice::ErrorKind error) {
  const bool relative = error == choice::ErrorKind::relative;
  const std::string of = result.problem.seen_as.empty() ? "the value" : result.problem.seen_as;
  CostChart chart;
  chart.cost = cost == choice::CostKind::counted
                   ? Axis{.label = "estimated cost, in multiply-adds of floats", .column = "cost"}
                   : Axis{.label = "least time of a value, in ns", .column = "ns"};
  chart.error = relative ? Axis{.label = "largest relative error", .column = "relative_error"}
                         : Axis{.label = "largest error of " + of, .column = "absolute_error"};
  const choice::Dominated& front = result.front(cost, error);
  for (std::size_t k = 0; k < result.methods.size(); ++k) {
    const choice::Method& method = result.methods[k].method;
    if (cost == choice::CostKind::counted && !method.portable) continue;
    chart.points.push_back({.name = method.name,
                            .cost = result.cost_of(k, cost),
                            .error = result.error_of(k, error),
                            .on_front = front.on_front[k],
                            .group = std::string(kind_word(method.kind))});
  }
  return chart;
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

Figure pareto_figure(const choice::ProblemResult& result, choice::CostKind cost, const choice::MachineRecord& machine) {
  const choice::Problem& problem = result.problem;
  const bool counted = cost == choice::CostKind::counted;
  const std::string place =
      counted ? "estimated cost" : machine.processor + ", " + machine.compiler + ", " + machine.date;
  Figure figure = cost_figure(
      {chart_of(result, cost, choice::ErrorKind::absolute), chart_of(result, cost, choice::ErrorKind::relative)},
      problem.name + (counted ? "_cost" : "_time"), problem.doc + ": " + place,
      "Cost of one value against the largest error found at " + std::to_string(result.samples) +
          " inputs over the whole domain.");
  return figure;
}

} // namespace brdfplot::plot
