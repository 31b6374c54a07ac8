#include "choice/stress/climb.hpp"

#include "base/interrupt.hpp"
#include "base/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace brdfplot::choice {

namespace {

/// Replaces `best` by what a row gives if that is worse.
bool improve(const Subject& subject, const FailureKind& kind, const Row& row, Trial& best) {
  if (row == best.input) return false;
  Trial trial = subject.trial(row);
  if (!(kind.how_bad(subject, trial) > kind.how_bad(subject, best))) return false;
  best = std::move(trial);
  return true;
}

/// Numbers of one significant digit of a range, those near 1 first, and its ends.
std::vector<double> one_digit_numbers(const Input& input) {
  std::vector<double> all = {1.0, 0.0};
  for (int power = 0; power <= 16; ++power)
    for (const int sign : {1, -1}) {
      if (power == 0 && sign < 0) continue;
      for (int digit = 1; digit <= 9; ++digit)
        for (const double of : {1.0, -1.0})
          all.push_back(of *
                        std::strtod((std::to_string(digit) + "e" + std::to_string(sign * power)).c_str(), nullptr));
    }
  all.insert(all.end(), {input.low, input.high});
  std::erase_if(all, [&](double x) { return x < input.low || x > input.high; });
  return all;
}

/// x with so many significant digits, rounded to the nearest, up and down.
std::vector<double> with_digits(double x, int digits) {
  if (x == 0 || !std::isfinite(x)) return {x};
  const int power = digits - 1 - static_cast<int>(std::floor(std::log10(std::fabs(x))));
  const double scaled = std::fabs(power) > 290 ? x : x * std::pow(10.0, power);
  std::vector<double> all;
  for (const double whole : {std::round(scaled), std::floor(scaled), std::ceil(scaled)})
    all.push_back(std::strtod((std::to_string(whole) + "e" + std::to_string(-power)).c_str(), nullptr));
  return all;
}

/// Takes the first of the numbers for input k that still shows the failure.
bool take_first(const Subject& subject, const FailureKind& kind, std::size_t k, const std::vector<double>& numbers,
                Trial& best) {
  for (const double x : numbers) {
    Row row = best.input;
    row[k] = x;
    row = subject.rounded(row);
    Trial trial = subject.trial(row);
    if (!kind.shown_by(subject, trial)) continue;
    best = std::move(trial);
    return true;
  }
  return false;
}

void simplify_input(const Subject& subject, const FailureKind& kind, std::size_t k, Trial& best) {
  const Input& input = subject.problem().inputs[k];
  if (take_first(subject, kind, k, one_digit_numbers(input), best)) return;
  for (int digits = 2; digits <= 16; ++digits)
    if (take_first(subject, kind, k, with_digits(best.input[k], digits), best)) return;
}

} // namespace

Trial climbed(const Subject& subject, const FailureKind& kind, Trial best) {
  const auto& inputs = subject.problem().inputs;
  const int most = subject.problem().slow ? 40 : 600;
  int tried = 0;
  for (int part = 3; part < 64; ++part) {
    bool moves = true;
    while (moves && tried < most) {
      moves = false;
      throw_if_interrupted();
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        const std::int64_t span = subject.place(inputs[k].high) - subject.place(inputs[k].low);
        const std::int64_t steps = span >> part;
        if (steps == 0) continue;
        for (const std::int64_t step : {steps, -steps}) {
          Row row = best.input;
          row[k] = subject.stepped(k, row[k], step);
          moves = improve(subject, kind, subject.rounded(row), best) || moves;
          ++tried;
        }
      }
    }
  }
  return best;
}

Trial simplified(const Subject& subject, const FailureKind& kind, Trial best) {
  for (std::size_t k = 0; k < subject.problem().inputs.size(); ++k) simplify_input(subject, kind, k, best);
  return best;
}

} // namespace brdfplot::choice
