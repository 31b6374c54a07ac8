#include "choice/stress/subject.hpp"

#include "base/threads/interrupt.hpp"
#include "choice/stress/ordinals.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brdfplot::choice {

namespace {

/// inputs[k][i] of rows[i][k].
template <class T>
std::vector<std::vector<T>> columns_of(const std::vector<Row>& rows, std::size_t inputs) {
  std::vector<std::vector<T>> columns(inputs, std::vector<T>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < inputs; ++k) columns[k][i] = static_cast<T>(rows[i][k]);
  return columns;
}

template <class T>
std::vector<double> run_on(const Run<T>& run, const std::vector<Row>& rows, std::size_t inputs) {
  const auto columns = columns_of<T>(rows, inputs);
  std::vector<const T*> pointers;
  for (const auto& column : columns) pointers.push_back(column.data());
  std::vector<T> out(rows.size());
  run(rows.size(), pointers.data(), out.data());
  return {out.begin(), out.end()};
}

/// Relative to what is right, and where that is 0, as it is.
double relative(double difference, double right) {
  return std::fabs(difference) / std::max(std::fabs(right), std::numeric_limits<double>::min());
}

template <class T>
double step_from(double from, std::int64_t steps, const Input& input) {
  const std::int64_t place = ordinal_of(static_cast<T>(from)), low = ordinal_of(static_cast<T>(input.low)),
                     high = ordinal_of(static_cast<T>(input.high));
  // The distances are taken first: a sum of places could overflow.
  const std::int64_t moved = steps >= 0 ? place + std::min(steps, std::max(high - place, std::int64_t{0}))
                                        : place - std::min(-steps, std::max(place - low, std::int64_t{0}));
  return static_cast<double>(at_ordinal<T>(moved));
}

} // namespace

double Subject::largest() const {
  return method_->is_single() ? static_cast<double>(std::numeric_limits<float>::max())
                              : std::numeric_limits<double>::max();
}

bool Subject::is_another_function() const {
  return method_->kind == Kind::approximation || method_->kind == Kind::fit || method_->kind == Kind::table;
}

bool Subject::replaces_a_share() const { return is_another_function() && problem_->least >= 0 && problem_->most <= 1; }

double Subject::error(const Trial& trial) const {
  if (!trial.has_exact) return trial.noise;
  const double smallest = problem_->least < 0 ? 1 : method_->is_single() ? 0x1p-63 : 0x1p-511;
  const double difference = (trial.value - trial.exact.high) - trial.exact.low;
  return relative(difference, std::max(std::fabs(trial.exact.high), smallest));
}

double Subject::seen_error(const Trial& trial) const {
  if (!trial.has_exact) return trial.seen_noise;
  if (!problem_->seen && replaces_a_share()) return std::fabs(trial.value - trial.exact.high);
  if (!problem_->seen) return error(trial);
  return relative(seen(trial.value) - seen(trial.exact.high), seen(trial.exact.high));
}

Row Subject::rounded(Row row) const {
  for (std::size_t k = 0; k < row.size(); ++k) {
    const Input& input = problem_->inputs[k];
    row[k] = std::clamp(row[k], input.low, input.high);
    if (!method_->is_single()) continue;
    auto x = static_cast<float>(row[k]);
    if (static_cast<double>(x) > input.high) x = std::nextafterf(x, -std::numeric_limits<float>::infinity());
    if (static_cast<double>(x) < input.low) x = std::nextafterf(x, std::numeric_limits<float>::infinity());
    row[k] = static_cast<double>(x);
  }
  return row;
}

double Subject::stepped(std::size_t input, double from, std::int64_t steps) const {
  return method_->is_single() ? step_from<float>(from, steps, problem_->inputs[input])
                              : step_from<double>(from, steps, problem_->inputs[input]);
}

std::int64_t Subject::place(double x) const {
  return method_->is_single() ? ordinal_of(static_cast<float>(x)) : ordinal_of(x);
}

std::vector<double> Subject::values(const std::vector<Row>& rows) const {
  const std::size_t inputs = problem_->inputs.size();
  if (const auto* run = std::get_if<Run<float>>(&method_->run)) return run_on(*run, rows, inputs);
  return run_on(std::get<Run<double>>(method_->run), rows, inputs);
}

void Subject::compare_with_neighbours(std::vector<Trial>& trials) const {
  for (std::size_t k = 0; k < problem_->monotone.size(); ++k) {
    if (problem_->monotone[k] == 0) continue;
    // Some thousandth further: there most functions have moved by more than rounding.
    const std::int64_t steps = std::int64_t{1} << (method_->is_single() ? 13 : 42);
    std::vector<Row> ahead;
    for (const Trial& trial : trials) {
      ahead.push_back(trial.input);
      ahead.back()[k] = rounded(trial.input)[k];
      ahead.back()[k] = stepped(k, ahead.back()[k], steps);
      ahead.back() = rounded(ahead.back());
    }
    // What is seen may fall where the value grows.
    const std::vector<double> next = values(ahead);
    for (std::size_t i = 0; i < trials.size(); ++i) {
      const double step = problem_->monotone[k] * (next[i] - trials[i].value);
      if (!(step < 0)) continue;
      const double here = seen(trials[i].value);
      const double wrong = relative(seen(next[i]) - here, std::max(std::fabs(here), std::fabs(seen(next[i]))));
      if (std::isfinite(wrong)) trials[i].wrong_way = std::max(trials[i].wrong_way, wrong);
    }
  }
}

double Subject::sensitivity(const Trial& trial) const {
  double most = 0;
  for (std::size_t k = 0; k < trial.input.size(); ++k)
    for (const double sign : {-2.0, 2.0}) {
      Row row = trial.input;
      row[k] *= 1 + sign * epsilon();
      most = std::max(most, relative(values({row}).front() - trial.value, trial.value));
    }
  return most;
}

void Subject::compare_with_exchanged(std::vector<Trial>& trials) const {
  if (!problem_->reciprocal) return;
  std::vector<Row> exchanged;
  for (const Trial& trial : trials) {
    exchanged.push_back(trial.input);
    Row& row = exchanged.back();
    std::rotate(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(row.size() / 2), row.end());
  }
  const std::vector<double> other = values(exchanged);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const double largest = std::max(std::fabs(other[i]), std::fabs(trials[i].value));
    if (!std::isfinite(largest)) continue;
    const double unequal = relative(other[i] - trials[i].value, std::max(largest, 0x1p-511));
    // What the rounding of the inputs does is not the method's: directions that all but cancel in the half vector.
    if (unequal > std::sqrt(epsilon()) && unequal > 10 * sensitivity(trials[i])) trials[i].unequal = unequal;
  }
}

void Subject::measure_noise(std::vector<Trial>& trials) const {
  if (problem_->exact || !problem_->smooth) return;
  constexpr double apart = 0x1p-16;
  constexpr std::array<double, 5> weights = {1, -4, 6, -4, 1};
  for (std::size_t k = 0; k < problem_->inputs.size(); ++k)
    for (Trial& trial : trials) {
      const Input& input = problem_->inputs[k];
      // Near an end that is not 0, such as the horizon, the function may change over as few steps.
      if (trial.input[k] * (1 + 256 * apart) > input.high || !std::isfinite(trial.value)) continue;
      std::vector<Row> rows(weights.size(), trial.input);
      for (std::size_t j = 0; j < rows.size(); ++j) rows[j][k] *= 1 + apart * (static_cast<double>(j) - 2);
      double off = 0, seen_off = 0;
      const std::vector<double> near = values(rows);
      for (std::size_t j = 0; j < near.size(); ++j) {
        off += weights[j] / 16 * near[j];
        seen_off += weights[j] / 16 * seen(near[j]);
      }
      if (!std::isfinite(off)) continue;
      trial.noise = std::max(trial.noise, relative(off, std::max(std::fabs(trial.value), 0x1p-511)));
      trial.seen_noise = std::max(trial.seen_noise, relative(seen_off, seen(trial.value)));
    }
}

void Subject::state_errors(std::vector<Trial>& trials) const {
  if (!method_->stated_error) return;
  for (Trial& trial : trials) trial.stated = method_->stated_error(trial.input);
}

std::vector<Trial> Subject::trials(const std::vector<Row>& rows, const std::vector<Exact>& exact) const {
  const std::vector<double> all = values(rows);
  std::vector<Trial> made;
  made.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    made.push_back(
        {.input = rows[i], .value = all[i], .exact = exact[i], .has_exact = static_cast<bool>(problem_->exact)});
  compare_with_neighbours(made);
  compare_with_exchanged(made);
  measure_noise(made);
  state_errors(made);
  return made;
}

Trial Subject::trial(const Row& row) const { return trials({row}, exact_values(*problem_, {row})).front(); }

std::vector<Exact> exact_values(const Problem& problem, const std::vector<Row>& rows) {
  if (!problem.exact) return std::vector<Exact>(rows.size());
  std::vector<Exact> exact;
  exact.reserve(rows.size());
  for (const Row& row : rows) {
    throw_if_interrupted();
    exact.push_back(problem.exact(row));
  }
  return exact;
}

} // namespace brdfplot::choice
