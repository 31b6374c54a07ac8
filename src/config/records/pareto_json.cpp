#include "config/records/pareto_json.hpp"

#include "config/shapes.hpp"
#include "figure/pareto_figure.hpp"

#include <cmath>

namespace brdfplot::config {

namespace {

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json input_json(const choice::Problem& problem, const std::vector<double>& row) {
  Json out = Json::object();
  for (std::size_t k = 0; k < row.size(); ++k) out[problem.inputs[k].name] = row[k];
  return out;
}

Json largest_json(const choice::Problem& problem, const choice::Largest& largest) {
  return {{"error", number_or_null(largest.error)},
          {"at", input_json(problem, largest.input)},
          {"value", number_or_null(largest.value)},
          {"exact", number_or_null(largest.exact)}};
}

Json errors_json(const choice::Problem& problem, const choice::Errors& errors) {
  return {{"relative", largest_json(problem, errors.relative)},  {"ulp", largest_json(problem, errors.ulp)},
          {"above", largest_json(problem, errors.above)},        {"below", largest_json(problem, errors.below)},
          {"relative_rms", number_or_null(errors.relative_rms)}, {"absolute_rms", number_or_null(errors.absolute_rms)}};
}

Json operations_json(const choice::Operations& o) {
  return {{"multiply_adds", o.multiply_adds}, {"comparisons", o.comparisons},   {"divisions", o.divisions},
          {"square_roots", o.square_roots},   {"exponentials", o.exponentials}, {"transcendentals", o.transcendentals},
          {"table_reads", o.table_reads}};
}

Json time_json(const choice::Time& time, const choice::Time& reference) {
  return {{"least_ns", time.least},
          {"lower_quartile_ns", time.lower_quartile},
          {"median_ns", time.median},
          {"upper_quartile_ns", time.upper_quartile},
          {"ratio", time.least / reference.least}};
}

Json front_json(const choice::ProblemResult& result, std::size_t k, choice::CostKind cost) {
  Json out = Json::object();
  for (const auto& [name, error] :
       {std::pair{"relative", choice::ErrorKind::relative}, std::pair{"absolute", choice::ErrorKind::absolute}}) {
    const choice::Dominated& front = result.front(cost, error);
    Json& entry = out[name] = {{"on_front", static_cast<bool>(front.on_front[k])}};
    if (front.by[k]) entry["dominated_by"] = result.methods[*front.by[k]].method.name;
  }
  return out;
}

Json method_json(const choice::ProblemResult& result, std::size_t k) {
  const choice::MethodResult& m = result.methods[k];
  Json out = {{"name", m.method.name},
              {"doc", m.method.doc},
              {"source", m.method.source},
              {"kind", plot::kind_word(m.method.kind)},
              {"format", m.method.is_single() ? "float" : "double"},
              {"portable", m.method.portable},
              {"bytes", m.method.bytes}};
  if (m.method.evaluations > 0) out["evaluations"] = m.method.evaluations;
  if (!m.method.note.empty()) out["note"] = m.method.note;
  out["operations"] = m.method.operations ? operations_json(*m.method.operations) : Json();
  out["cost"] = m.cost ? Json(*m.cost) : Json();
  out["errors"] = errors_json(result.problem, m.errors);
  out["front_by_cost"] = front_json(result, k, choice::CostKind::counted);
  if (!m.time) return out;
  out["time"] = time_json(*m.time, *result.methods[result.reference].time);
  out["front_by_time"] = front_json(result, k, choice::CostKind::measured);
  return out;
}

Json problem_json(const choice::ProblemResult& result) {
  const choice::Problem& problem = result.problem;
  Json out = {{"name", problem.name},
              {"doc", problem.doc},
              {"source", problem.source},
              {"samples", result.samples},
              {"absolute_error_of", problem.seen_as.empty() ? "value" : problem.seen_as},
              {"reference", result.methods[result.reference].method.name}};
  if (problem.exact_error > 0) out["exact_error"] = problem.exact_error;
  for (const auto& input : problem.inputs)
    out["inputs"].push_back({{"name", input.name},
                             {"doc", input.doc},
                             {"from", input.low},
                             {"to", input.high},
                             {"scale", input.scale == choice::Scale::linear ? "linear" : "logarithmic"}});
  for (std::size_t k = 0; k < result.methods.size(); ++k) out["methods"].push_back(method_json(result, k));
  return out;
}

} // namespace

std::string pareto_record(const std::vector<choice::ProblemResult>& results,
                          const std::optional<choice::MachineRecord>& machine, const std::string& version) {
  Json out = {{"version", version}, {"problems", Json::array()}};
  if (machine)
    out["machine"] = {{"processor", machine->processor}, {"compiler", machine->compiler}, {"date", machine->date}};
  for (const auto& result : results) out["problems"].push_back(problem_json(result));
  return out.dump(2) + "\n";
}

} // namespace brdfplot::config
