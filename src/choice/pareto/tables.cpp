#include "choice/pareto/tables.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace brdfplot::choice {

namespace {

std::string short_text(double value, const char* format) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return "none";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

/// "a=1.336" or "alpha=0.1 cos_o=0.2", the shortest digits.
std::string place_text(const Problem& problem, const std::vector<double>& input) {
  std::string text;
  for (std::size_t k = 0; k < input.size(); ++k)
    text += (text.empty() ? "" : " ") + problem.inputs[k].name + "=" + format_number(input[k]);
  return text;
}

std::string rounded_place(const Problem& problem, const std::vector<double>& input) {
  std::string text;
  for (std::size_t k = 0; k < input.size(); ++k)
    text += (text.empty() ? "" : " ") + problem.inputs[k].name + "=" + short_text(input[k], "%.4g");
  return text;
}

/// "ra": on the front of the relative and of the absolute error.
std::string front_text(const ProblemResult& result, std::size_t k, CostKind cost) {
  std::string text;
  if (result.front(cost, ErrorKind::relative).on_front[k]) text += 'r';
  if (result.front(cost, ErrorKind::absolute).on_front[k]) text += 'a';
  return text.empty() ? "-" : text;
}

/// Who dominates a method in the absolute error; itself where nobody does.
std::string dominated_by(const ProblemResult& result, std::size_t k, ErrorKind error) {
  const auto& by = result.front(CostKind::counted, error).by[k];
  return by ? result.methods[*by].method.name : "";
}

void append_largest(std::string& row, const Problem& problem, const Largest& largest) {
  row += "," + format_number(largest.error) + "," + quoted(place_text(problem, largest.input));
}

std::string csv_row(const ProblemResult& result, std::size_t k) {
  const MethodResult& m = result.methods[k];
  const Method& method = m.method;
  std::string row = result.problem.name + "," + quoted(method.name) + "," + (method.is_single() ? "float" : "double") +
                    "," + (m.cost ? format_number(*m.cost) : "");
  const Operations none{}, &o = method.operations ? *method.operations : none;
  for (const std::size_t count :
       {o.multiply_adds, o.comparisons, o.divisions, o.square_roots, o.exponentials, o.transcendentals, o.table_reads})
    row += "," + (method.operations ? std::to_string(count) : "");
  row += "," + std::to_string(method.bytes);
  append_largest(row, result.problem, m.errors.relative);
  append_largest(row, result.problem, m.errors.ulp);
  append_largest(row, result.problem, m.errors.above);
  append_largest(row, result.problem, m.errors.below);
  row += "," + format_number(m.errors.relative_rms) + "," + format_number(m.errors.absolute_rms);
  for (const ErrorKind error : {ErrorKind::relative, ErrorKind::absolute})
    row += std::string(",") + (result.front(CostKind::counted, error).on_front[k] ? "yes" : "no") + "," +
           quoted(dominated_by(result, k, error));
  return row + "," + quoted(method.source) + "\n";
}

} // namespace

std::string pareto_csv(const std::vector<ProblemResult>& results) {
  std::string out =
      "problem,method,format,cost,multiply_adds,comparisons,divisions,square_roots,exponentials,"
      "transcendentals,table_reads,table_bytes,relative_error,relative_error_at,ulp,ulp_at,above,above_at,"
      "below,below_at,relative_rms,absolute_rms,on_relative_front,relative_dominated_by,"
      "on_absolute_front,absolute_dominated_by,source\n";
  for (const auto& result : results)
    for (std::size_t k = 0; k < result.methods.size(); ++k) out += csv_row(result, k);
  return out;
}

std::string times_csv(const std::vector<ProblemResult>& results, const MachineRecord& machine) {
  std::string out = "problem,method,least_ns,lower_quartile_ns,median_ns,upper_quartile_ns,ratio,reference,processor,"
                    "compiler,date\n";
  for (const auto& result : results) {
    const MethodResult& reference = result.methods[result.reference];
    for (const auto& m : result.methods) {
      if (!m.time || !reference.time) continue;
      out += result.problem.name + "," + quoted(m.method.name);
      for (const double value : {m.time->least, m.time->lower_quartile, m.time->median, m.time->upper_quartile,
                                 m.time->least / reference.time->least})
        out += "," + short_text(value, "%.4g");
      out += "," + quoted(reference.method.name) + "," + quoted(machine.processor) + "," + quoted(machine.compiler) +
             "," + machine.date + "\n";
    }
  }
  return out;
}

std::vector<std::vector<std::string>> pareto_cells(const ProblemResult& result) {
  std::vector<std::size_t> order(result.methods.size());
  std::iota(order.begin(), order.end(), 0);
  const auto cost = [&](std::size_t k) {
    return result.methods[k].cost.value_or(std::numeric_limits<double>::infinity());
  };
  std::ranges::stable_sort(order, {}, cost);
  const bool timed = result.methods.at(0).time.has_value();
  const MethodResult& reference = result.methods[result.reference];
  const std::string absolute = result.problem.seen_as.empty() ? "absolute" : result.problem.seen_as;
  std::vector<std::vector<std::string>> cells = {{"method", "cost"}};
  const bool tables = std::ranges::any_of(result.methods, [](const MethodResult& m) { return m.method.bytes > 0; });
  if (tables) cells[0].push_back("bytes");
  if (timed) cells[0].insert(cells[0].end(), {"ns", "ratio"});
  cells[0].insert(cells[0].end(), {"relative", "ulp", absolute, "where", "front"});
  if (timed) cells[0].push_back("timed");
  for (const std::size_t k : order) {
    const MethodResult& m = result.methods[k];
    auto& row = cells.emplace_back();
    row = {m.method.name, m.cost ? short_text(*m.cost, "%.4g") : "-"};
    if (tables) row.push_back(m.method.bytes > 0 ? std::to_string(m.method.bytes) : "");
    if (timed)
      row.insert(row.end(),
                 {short_text(m.time->least, "%.3g"), short_text(m.time->least / reference.time->least, "%.2f")});
    const Largest& absolute_error = m.errors.absolute();
    row.insert(row.end(),
               {short_text(m.errors.relative.error, "%.3g"), short_text(m.errors.ulp.error, "%.3g"),
                short_text(absolute_error.error, "%+.3g"), rounded_place(result.problem, absolute_error.input),
                m.method.portable ? front_text(result, k, CostKind::counted) : ""});
    if (timed) row.push_back(front_text(result, k, CostKind::measured));
  }
  return cells;
}

std::string front_line(const ProblemResult& result, CostKind cost, ErrorKind error) {
  const std::vector<bool>& on_front = result.front(cost, error).on_front;
  std::vector<std::size_t> front;
  for (std::size_t k = 0; k < on_front.size(); ++k)
    if (on_front[k]) front.push_back(k);
  std::ranges::stable_sort(front, {}, [&](std::size_t k) { return result.cost_of(k, cost); });
  const std::string seen = result.problem.seen_as.empty() ? "absolute" : result.problem.seen_as;
  std::string line = std::string("front by ") + (cost == CostKind::counted ? "cost, " : "time, ") +
                     (error == ErrorKind::relative ? "relative" : seen) + ":";
  for (std::size_t k = 0; k < front.size(); ++k)
    line += (k == 0 ? " " : ", ") + result.methods[front[k]].method.name + " " +
            short_text(result.cost_of(front[k], cost), "%.3g") + " (" +
            short_text(result.error_of(front[k], error), "%.2g") + ")";
  return line;
}

std::string pareto_legend(bool times) {
  return std::string("cost: estimated, in multiply-adds of floats (a double counts twice). bytes: of tables.") +
         (times ? " ns:\nleast processor time of a value; ratio: against the reference." : "") +
         " relative, ulp, absolute: the largest errors\nfound (none: no number somewhere); where: of the absolute "
         "one.\n" +
         (times ? "front, timed: r, a: nothing is as cheap and as good in the relative or absolute error, by cost, by "
                  "time.\nTimes within 10 % and errors"
                : "front: r, a: nothing is as cheap and as good in the relative or absolute error.\nErrors") +
         " within 25 % of each other are not told apart. Kernels of instruction sets are not compared by cost.\n";
}

} // namespace brdfplot::choice
