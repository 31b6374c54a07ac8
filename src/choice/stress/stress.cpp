#include "choice/stress/stress.hpp"

#include "choice/stress/climb.hpp"
#include "choice/stress/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace brdfplot::choice {

namespace {

/// The rows of all methods of one number type, with their exact values.
struct Swept {
  std::vector<Row> rows;
  std::vector<Exact> exact;
};

std::vector<std::string> input_names(const Problem& problem) {
  std::vector<std::string> names;
  for (const Input& input : problem.inputs) names.push_back(input.name);
  return names;
}

/// The worst rows of a kind, some, the worst first.
std::vector<std::size_t> worst_rows(const Subject& subject, const FailureKind& kind, const std::vector<Trial>& trials) {
  constexpr std::size_t starts = 3;
  std::vector<std::pair<double, std::size_t>> bad;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const double how_bad = kind.how_bad(subject, trials[i]);
    if (how_bad > 0) bad.emplace_back(-how_bad, i);
  }
  const std::size_t count = std::min(starts, bad.size());
  std::partial_sort(bad.begin(), bad.begin() + static_cast<std::ptrdiff_t>(count), bad.end());
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < count; ++k) rows.push_back(bad[k].second);
  return rows;
}

/// The worst that the climb finds; nothing where no row is bad at all.
std::optional<Trial> worst_of(const Subject& subject, const FailureKind& kind, const std::vector<Trial>& trials) {
  std::optional<Trial> worst;
  for (const std::size_t row : worst_rows(subject, kind, trials)) {
    Trial top = climbed(subject, kind, trials[row]);
    top = simplified(subject, kind, top, kind.how_bad(subject, top));
    if (!worst || kind.how_bad(subject, top) > kind.how_bad(subject, *worst)) worst = std::move(top);
  }
  return worst;
}

void extend(Finding& finding, const Row& row) {
  if (finding.rows == 0) finding.from = finding.to = row;
  for (std::size_t k = 0; k < row.size(); ++k) {
    finding.from[k] = std::min(finding.from[k], row[k]);
    finding.to[k] = std::max(finding.to[k], row[k]);
  }
}

Finding finding_of(const Subject& subject, const FailureKind& kind, const std::vector<Trial>& trials,
                   const Trial& worst) {
  Finding finding{.problem = subject.problem().name,
                  .method = subject.method().name,
                  .kind = &kind,
                  .inputs = input_names(subject.problem()),
                  .worst = kind.how_bad(subject, worst),
                  .worst_at = worst.input,
                  .value = worst.value,
                  .exact = worst.exact.high,
                  .has_exact = worst.has_exact,
                  .single = subject.method().is_single()};
  for (const Trial& trial : trials)
    if (kind.shown_by(subject, trial)) {
      extend(finding, trial.input);
      ++finding.rows;
    }
  if (finding.rows == 0) extend(finding, worst.input);
  finding.simplest = simplified(subject, kind, worst, 0).input;
  return finding;
}

MethodReport report_of(const Subject& subject, const Swept& swept) {
  const std::vector<Trial> trials = subject.trials(swept.rows, swept.exact);
  MethodReport report{.problem = subject.problem().name,
                      .method = subject.method().name,
                      .inputs = input_names(subject.problem()),
                      .rows = trials.size(),
                      .single = subject.method().is_single()};
  for (const FailureKind& kind : failure_kinds()) {
    const auto worst = worst_of(subject, kind, trials);
    if (worst && kind.shown_by(subject, *worst)) report.findings.push_back(finding_of(subject, kind, trials, *worst));
    if (worst && kind.name == "digits_lost") {
      report.error = kind.how_bad(subject, *worst);
      report.error_at = worst->input;
    }
  }
  return report;
}

/// How good an answer a method without failures is: the same function, rewritten, in the same type first.
int rank(const Method& method, bool single) {
  const int by_type = method.is_single() == single ? 0 : 1;
  switch (method.kind) {
  case Kind::rewritten: return by_type;
  case Kind::printed: return 2 + by_type;
  case Kind::kernel: return 4 + by_type;
  case Kind::quadrature: return 6 + by_type;
  default: return 100; // another function
  }
}

/// What mends a failure: the best method without one, or what helps in general.
std::string mend_of(const Problem& problem, const std::vector<MethodReport>& reports, const Finding& finding) {
  const Method* best = nullptr;
  for (const MethodReport& report : reports) {
    if (!report.findings.empty()) continue;
    const auto method = std::ranges::find(problem.methods, report.method, &Method::name);
    const int place = rank(*method, finding.single);
    // Of quadratures the last is the finest.
    const bool is_finer = best != nullptr && place == rank(*best, finding.single) && method->kind == Kind::quadrature;
    if (place < 100 && (best == nullptr || place < rank(*best, finding.single) || is_finer)) best = &*method;
  }
  const auto own = std::ranges::find(problem.methods, finding.method, &Method::name);
  if (best == nullptr && Subject(problem, *own).is_another_function() && finding.kind->name == "digits_lost")
    return "the function itself, or an approximation that states its error";
  if (best == nullptr) return std::string(finding.kind->mend);
  return best->name + ": " + best->doc;
}

} // namespace

std::vector<MethodReport> stress(const Problem& problem, const std::string& only) {
  std::optional<Swept> swept[2];
  std::vector<MethodReport> reports;
  for (const Method& method : problem.methods) {
    if (!method.portable && method.name != only) continue;
    const Subject subject(problem, method);
    auto& rows = swept[method.is_single() ? 1 : 0];
    if (!rows) {
      rows.emplace();
      rows->rows = sweep(subject);
      rows->exact = exact_values(problem, rows->rows);
    }
    reports.push_back(report_of(subject, *rows));
  }
  for (MethodReport& report : reports)
    for (Finding& finding : report.findings) finding.mend = mend_of(problem, reports, finding);
  if (!only.empty()) std::erase_if(reports, [&](const MethodReport& report) { return report.method != only; });
  return reports;
}

} // namespace brdfplot::choice
