#include "choice/pareto/pareto.hpp"

#include "base/threads/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

namespace {

ProblemResult without_errors(Problem problem) {
  ProblemResult result;
  for (auto& method : problem.methods) {
    const auto cost = estimated_cost(problem, method);
    result.methods.push_back({.method = std::move(method), .cost = cost, .errors = {}, .time = {}});
  }
  problem.methods.clear();
  const auto kernel =
      std::ranges::find_if(result.methods, [](const MethodResult& m) { return m.method.kind == Kind::kernel; });
  if (kernel != result.methods.end()) result.reference = static_cast<std::size_t>(kernel - result.methods.begin());
  result.problem = std::move(problem);
  return result;
}

/// One format of one problem.
void measure_errors(ProblemResult& result, bool single, int threads) {
  std::vector<MethodResult*> methods;
  for (auto& m : result.methods)
    if (m.method.is_single() == single) methods.push_back(&m);
  if (methods.empty()) return;
  const Samples samples = sample(result.problem, single, threads);
  result.samples = samples.size();
  parallel_for(methods.size(), threads,
               [&](std::size_t k) { methods[k]->errors = errors_of(result.problem, methods[k]->method, samples); });
}

void measure_times(ProblemResult& result, const std::function<void(double)>& rest) {
  Problem problem = result.problem;
  for (const auto& m : result.methods) problem.methods.push_back(m.method);
  const auto times = times_of(problem, rest);
  for (std::size_t k = 0; k < times.size(); ++k) result.methods[k].time = times[k];
}

void find_fronts(ProblemResult& result) {
  for (const CostKind cost : {CostKind::counted, CostKind::measured})
    for (const ErrorKind error : {ErrorKind::relative, ErrorKind::absolute}) {
      std::vector<CostError> points;
      for (std::size_t k = 0; k < result.methods.size(); ++k)
        points.push_back({result.cost_of(k, cost), result.error_of(k, error)});
      result.fronts.push_back(dominated(points, cost == CostKind::measured ? measured_slack : counted_slack));
    }
}

} // namespace

std::optional<double> estimated_cost(const Problem& problem, const Method& method) {
  if (!problem.cost_unit.empty()) return method.evaluations > 0 ? std::optional(method.evaluations) : std::nullopt;
  if (!method.operations) return std::nullopt;
  return cost(*method.operations) * (method.is_single() ? 1 : 2);
}

bool ProblemResult::has_costs() const {
  return std::ranges::any_of(methods, [](const MethodResult& m) { return m.cost.has_value(); });
}

double ProblemResult::cost_of(std::size_t method, CostKind kind) const {
  const MethodResult& m = methods[method];
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (kind == CostKind::measured) return m.time ? m.time->least : unknown;
  return m.method.portable ? m.cost.value_or(unknown) : unknown;
}

double ProblemResult::error_of(std::size_t method, ErrorKind kind) const {
  const Errors& errors = methods[method].errors;
  return std::fabs(kind == ErrorKind::relative ? errors.relative.error : errors.absolute().error);
}

std::vector<ProblemResult> pareto(std::vector<Problem> problems, const ParetoOptions& options, const Report& report) {
  constexpr double share_of_errors = 0.5;
  std::vector<ProblemResult> results;
  for (auto& problem : problems) results.push_back(without_errors(std::move(problem)));
  const double each = 1 / static_cast<double>(results.size());
  for (std::size_t k = 0; k < results.size(); ++k) {
    const std::string name = results[k].problem.name;
    const double begin = static_cast<double>(k) * each;
    report(begin, name + ", errors");
    for (const bool single : {false, true}) measure_errors(results[k], single, options.threads);
    if (options.times)
      measure_times(results[k], [&](double share) {
        report(begin + each * (share_of_errors + (1 - share_of_errors) * share), name + ", times");
      });
    find_fronts(results[k]);
  }
  return results;
}

} // namespace brdfplot::choice
