#include "choice/stress/error_map.hpp"

#include "choice/stress/findings_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace brdfplot::choice {

namespace {

constexpr double nearest_angle = 1e-4;
constexpr double least_error = 1e-17; ///< drawn for what is exact

MapAxis axis_of(const Input& input, std::size_t count) {
  MapAxis axis{.name = input.name, .logarithmic = input.scale == Scale::logarithmic, .at = {}};
  double low = input.low, high = input.high;
  if (input.name.starts_with("cos_")) {
    axis.angle_of_cosine = axis.logarithmic = true;
    axis.name = input.name == "cos_theta" ? "theta" : "theta_" + input.name.substr(4);
    low = nearest_angle;
    high = std::numbers::pi / 2;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count - 1);
    axis.at.push_back(axis.logarithmic ? low * std::pow(high / low, share) : low + share * (high - low));
  }
  return axis;
}

bool is_drawn(const Method& method) {
  return method.portable && method.kind != Kind::fit && method.kind != Kind::table;
}

/// The row of the largest error that was found, or the middle of the domain.
Row worst_row(const Problem& problem, const std::vector<MethodReport>& reports) {
  Row row;
  for (const Input& input : problem.inputs)
    row.push_back(input.scale == Scale::linear ? (input.low + input.high) / 2 : std::sqrt(input.low * input.high));
  double largest = 0;
  for (const MethodReport& report : reports) {
    const auto method = std::ranges::find(problem.methods, report.method, &Method::name);
    if (!is_drawn(*method) || method->kind == Kind::approximation || report.error_at.empty()) continue;
    if (report.error > largest) {
      largest = report.error;
      row = report.error_at;
    }
  }
  return row;
}

std::vector<Row> rows_of(const ProblemMap& map, const Row& fixed) {
  std::vector<Row> rows;
  const std::vector<double> ys = map.y.at.empty() ? std::vector<double>{0} : map.y.at;
  for (const double y : ys)
    for (const double x : map.x.at) {
      Row row = fixed;
      row[0] = map.x.input(x);
      if (!map.y.at.empty()) row[1] = map.y.input(y);
      rows.push_back(std::move(row));
    }
  return rows;
}

double drawn_error(double error) {
  return std::isfinite(error) ? std::log10(std::max(error, least_error)) : std::numeric_limits<double>::quiet_NaN();
}

ErrorMap map_of(const Subject& subject, const std::vector<Row>& rows, const std::vector<Exact>& exact) {
  ErrorMap map{.method = subject.method().name, .single = subject.method().is_single(), .seen = {}, .own = {}};
  for (const Trial& trial : subject.trials(rows, exact)) {
    map.seen.push_back(drawn_error(subject.seen_error(trial)));
    if (subject.problem().seen) map.own.push_back(drawn_error(subject.error(trial)));
  }
  return map;
}

std::size_t points_along(const Problem& problem) {
  if (problem.inputs.size() == 1) return is_slow(problem) ? 61 : 601;
  return is_slow(problem) ? 24 : 72;
}

} // namespace

double MapAxis::input(double drawn) const { return angle_of_cosine ? std::max(std::cos(drawn), 0.0) : drawn; }

ProblemMap error_map(const Problem& problem, const std::vector<MethodReport>& reports) {
  const std::size_t count = points_along(problem);
  ProblemMap map{.problem = problem.name,
                 .doc = problem.doc,
                 .seen_as = problem.seen_as,
                 .x = axis_of(problem.inputs[0], count),
                 .y = {},
                 .fixed = {},
                 .maps = {}};
  if (problem.inputs.size() > 1) map.y = axis_of(problem.inputs[1], count);
  const Row fixed = worst_row(problem, reports);
  for (std::size_t k = 2; k < problem.inputs.size(); ++k)
    map.fixed += (k > 2 ? ", " : "") + row_text({problem.inputs[k].name}, {fixed[k]}, true);
  const std::vector<Row> rows = rows_of(map, fixed);
  std::optional<std::pair<std::vector<Row>, std::vector<Exact>>> known[2];
  for (const Method& method : problem.methods) {
    if (!is_drawn(method)) continue;
    const Subject subject(problem, method);
    auto& of_type = known[method.is_single() ? 1 : 0];
    if (!of_type) {
      std::vector<Row> rounded;
      for (const Row& row : rows) rounded.push_back(subject.rounded(row));
      std::vector<Exact> exact = exact_values(problem, rounded);
      of_type.emplace(std::move(rounded), std::move(exact));
    }
    map.maps.push_back(map_of(subject, of_type->first, of_type->second));
  }
  return map;
}

} // namespace brdfplot::choice
