#include "choice/stress/failure_kinds.hpp"

#include <cmath>

namespace brdfplot::choice {

namespace {

double no_limit(const Subject&) { return 0; }

double half_the_digits(const Subject& subject) { return std::sqrt(subject.epsilon()); }

double not_a_number(const Subject&, const Trial& trial) {
  return std::isnan(trial.value) && !std::isnan(trial.exact.high) ? 1 : 0;
}

double infinite(const Subject& subject, const Trial& trial) {
  return std::isinf(trial.value) && std::fabs(trial.exact.high) < subject.largest() ? 1 : 0; // 0 where it is not known
}

double negative(const Subject& subject, const Trial& trial) {
  return subject.problem().least >= 0 && trial.value < 0 && std::isfinite(trial.value) ? -trial.value : 0;
}

/// Of the value, or of what is seen of it, a G1.
double above_one(const Subject& subject, const Trial& trial) {
  if (subject.problem().albedo || !std::isfinite(trial.value)) return 0;
  const double of_seen = subject.problem().seen ? subject.seen(trial.value) - 1 : 0;
  return std::max(subject.problem().most <= 1 ? trial.value - 1 : 0, of_seen);
}

/// A rule of quadrature does not promise the last digits.
double some_roundings(const Subject& subject) {
  return subject.method().kind == Kind::quadrature ? 1e-6 : 4 * subject.epsilon();
}

double digits_lost(const Subject& subject, const Trial& trial) {
  if (subject.method().kind == Kind::quadrature) return 0;
  const double error = subject.seen_error(trial);
  return std::isfinite(error) ? error : 0;
}

/// Digits of a value whose seen part is right.
double digits_unseen(const Subject& subject, const Trial& trial) {
  const Kind kind = subject.method().kind;
  if (!subject.problem().seen || kind == Kind::quadrature || subject.is_another_function()) return 0;
  const double error = subject.error(trial);
  return std::isfinite(error) && subject.seen_error(trial) <= digits_limit(subject) ? error : 0;
}

double bound_missed(const Subject& subject, const Trial& trial) {
  if (!(subject.method().bound > 0) || !trial.has_exact || !std::isfinite(trial.value)) return 0;
  return subject.is_another_function() ? subject.seen_error(trial) : subject.error(trial);
}

double stated_bound(const Subject& subject) { return subject.method().bound + 2 * subject.problem().exact_error; }

/// Steps of tables and of fits that are put together are no rounding.
double monotone_limit(const Subject& subject) {
  return subject.is_another_function() ? 1e-3 : half_the_digits(subject);
}

double wrong_way(const Subject&, const Trial& trial) { return trial.wrong_way; }

/// How much of an integral is not found.
double missing_share(const Subject& subject, const Trial& trial) {
  if (subject.method().kind != Kind::quadrature || !(trial.exact.high > 0)) return 0;
  return 1 - trial.value / trial.exact.high;
}

double half_of_it(const Subject&) { return 0.5; }

/// The error where it is above ten times what the method states.
double false_convergence(const Subject& subject, const Trial& trial) {
  const double error = std::fabs((trial.value - trial.exact.high) - trial.exact.low);
  return error > 10 * trial.stated ? subject.error(trial) : 0;
}

double some_millionths(const Subject&) { return 1e-5; }

double not_reciprocal(const Subject&, const Trial& trial) { return trial.unequal; }

double energy_above_one(const Subject& subject, const Trial& trial) {
  return subject.problem().albedo && std::isfinite(trial.value) ? trial.value - 1 : 0;
}

} // namespace

double digits_limit(const Subject& subject) {
  const double of_exact = 10 * subject.problem().exact_error;
  if (!subject.is_another_function()) return std::max(half_the_digits(subject), of_exact);
  return std::max(subject.method().bound > 0 ? subject.method().bound : 0.1, of_exact);
}

const std::vector<FailureKind>& failure_kinds() {
  static const std::vector<FailureKind> all = {
      {"nan", "not a number where there is one", "rewrite 0 / 0 and infinity - infinity as their limits", not_a_number,
       no_limit},
      {"infinity", "infinite where the value is finite", "divide by what does not vanish or underflow", infinite,
       no_limit},
      {"negative", "below zero by so much", "a sum of terms of one sign, or a maximum with 0", negative, no_limit},
      {"above_1", "above 1 by so much", "a fit that is held below 1, or a minimum with 1", above_one, some_roundings},
      {"digits_lost", "relative error of what is seen", "a form without a difference of near numbers", digits_lost,
       digits_limit},
      {"bound_missed", "relative error, above what the method states", "mend the method, or state what it keeps",
       bound_missed, stated_bound},
      {"not_monotone", "a step against the order of the function, relative", "a form without cancellation or jump",
       wrong_way, monotone_limit},
      {"peak_missed", "share of the integral that is not found",
       "cut the integral at the peak, and take it in variables scaled by its width", missing_share, half_of_it},
      {"false_convergence", "relative error, ten times what the method states or more",
       "judge an error by how fast coefficients fall, and cut the integral at the peak", false_convergence, no_limit},
      {"energy_above_1", "reflects more than all light by so much", "scale it by its largest albedo, or another model",
       energy_above_one, some_millionths},
      {"not_reciprocal", "relative difference where light and viewer change places", "a form that is symmetric in both",
       not_reciprocal, half_the_digits},
      {"digits_unseen", "relative error of a value whose seen part is right",
       "a form without a difference of near numbers", digits_unseen, half_the_digits},
  };
  return all;
}

std::vector<std::string> failure_names() {
  std::vector<std::string> names;
  for (const auto& kind : failure_kinds()) names.emplace_back(kind.name);
  return names;
}

} // namespace brdfplot::choice
