#include "choice/stress/climb.hpp"

#include "base/random.hpp"
#include "base/threads/interrupt.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

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

/// "3e-5" as a number.
double decimal(const std::string& digits, int power) {
  return std::strtod((digits + "e" + std::to_string(power)).c_str(), nullptr);
}

/// The simple numbers of a range: 1, 0, those of one significant digit, those near 1 first, powers of ten, its ends.
/// Where rows are slow, fewer.
std::vector<double> simple_numbers_of(const Input& input, std::size_t samples) {
  std::vector<double> all = {1.0, 0.0};
  const int most = samples < 64 ? 1 : samples < 1000 ? 3 : 16;
  for (int power = 0; power <= most; ++power)
    for (const int signed_power : {power, -power})
      for (const char digit : std::string("123456789"))
        for (const double sign : {1.0, -1.0}) all.push_back(sign * decimal(std::string(1, digit), signed_power));
  for (int power = 17; most == 16 && power <= 323; ++power)
    all.insert(all.end(), {decimal("1", -power), decimal("1", power)});
  all.insert(all.end(), {input.low, input.high});
  std::erase_if(all, [&](double x) { return x < input.low || x > input.high; });
  return all;
}

/// x with so many significant digits, rounded to the nearest, up and down.
std::vector<double> with_digits(double x, int digits) {
  if (x == 0 || !std::isfinite(x)) return {};
  const int power = digits - 1 - static_cast<int>(std::floor(std::log10(std::fabs(x))));
  if (std::abs(power) > 300) return {}; // the power of ten would be no number
  const double scaled = x * std::pow(10.0, power);
  std::vector<double> all;
  for (const double whole : {std::round(scaled), std::floor(scaled), std::ceil(scaled)})
    all.push_back(decimal(std::to_string(static_cast<std::int64_t>(whole)), -power));
  return all;
}

/// What a simpler row has to show.
struct Wanted {
  const FailureKind& kind;
  double least;
  bool holds(const Subject& subject, const Trial& trial) const {
    return kind.shown_by(subject, trial) && kind.how_bad(subject, trial) >= least;
  }
};

/// Takes the first of the numbers for input k that still shows the failure.
bool take_first(const Subject& subject, const Wanted& wanted, std::size_t k, const std::vector<double>& numbers,
                Trial& best) {
  for (const double x : numbers) {
    Row row = best.input;
    row[k] = x;
    Trial trial = subject.trial(subject.rounded(row));
    if (!wanted.holds(subject, trial)) continue;
    best = std::move(trial);
    return true;
  }
  return false;
}

void simplify_input(const Subject& subject, const Wanted& wanted, std::size_t k, Trial& best) {
  const Problem& problem = subject.problem();
  if (take_first(subject, wanted, k, simple_numbers_of(problem.inputs[k], problem.samples), best)) return;
  for (int digits = 1; digits <= 16; ++digits)
    if (take_first(subject, wanted, k, with_digits(best.input[k], digits), best)) return;
}

} // namespace

Trial climbed(const Subject& subject, const FailureKind& kind, Trial best) {
  const auto& inputs = subject.problem().inputs;
  const std::size_t rows = subject.problem().samples;
  const int most = rows < 64 ? 16 : rows < 1000 ? 40 : 600;
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

Trial simplified(const Subject& subject, const FailureKind& kind, Trial best, double least) {
  const Wanted wanted{kind, least};
  if (!wanted.holds(subject, best)) return best;
  for (std::size_t k = 0; k < subject.problem().inputs.size(); ++k) simplify_input(subject, wanted, k, best);
  return best;
}

} // namespace brdfplot::choice
