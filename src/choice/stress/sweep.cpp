#include "choice/stress/sweep.hpp"

#include "base/random.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

namespace {

constexpr std::uint64_t seed = 13;

/// How many rows of each sort.
struct Size {
  std::size_t grid, random;
};

Size size_of(const Problem& problem) {
  constexpr std::size_t per_axis[] = {0, 801, 41, 11, 7};
  const std::size_t inputs = std::min<std::size_t>(problem.inputs.size(), 4);
  if (problem.samples < 64) return {inputs == 1 ? 21U : 5U, 20};
  if (is_slow(problem)) return {inputs == 1 ? 41U : inputs == 2 ? 9U : 5U, 100};
  return {per_axis[inputs], inputs == 1 ? 1000U : 4000U};
}

/// The place of `share` in [0, 1] on the scale of the input.
double on_scale(const Input& input, double share) {
  if (share <= 0) return input.low;
  if (share >= 1) return input.high;
  return input.scale == Scale::linear ? input.low + share * (input.high - input.low)
                                      : input.low * std::pow(input.high / input.low, share);
}

/// Ends and simple numbers of an input's range.
std::vector<double> simple_numbers(const Input& input) {
  std::vector<double> all = {input.low, input.high};
  for (const double x : {0.0, 0.5, 1.0, 2.0, -0.5, -1.0})
    if (x > input.low && x < input.high) all.push_back(x);
  for (double x = 1e-9; x < 1e10; x *= 10)
    if (x > input.low && x < input.high) all.push_back(x);
  return all;
}

/// With their neighbourhoods.
std::vector<double> special_numbers(const Subject& subject, std::size_t index) {
  const Input& input = subject.problem().inputs[index];
  const int digits = subject.method().is_single() ? 24 : 53;
  std::vector<double> all;
  const auto take = [&](double x) {
    if (x >= input.low && x <= input.high) all.push_back(x);
  };
  for (const double x : simple_numbers(input)) {
    take(x);
    for (const std::int64_t steps : {1, 2, 3, -1, -2, -3}) take(subject.stepped(index, x, steps));
    const double size = x == 0 ? 1 : x;
    for (int k = 1; k <= digits; ++k) {
      take(x + std::ldexp(size, -k));
      take(x - std::ldexp(size, -k));
    }
  }
  return all;
}

/// A number of random bits: exponents spread evenly, or by the scale.
double random_number(const Subject& subject, std::size_t index, Random& random) {
  const Input& input = subject.problem().inputs[index];
  if (random.uniform() < 0.5) return on_scale(input, random.uniform());
  const auto span = static_cast<double>(subject.place(input.high) - subject.place(input.low));
  return subject.stepped(index, input.low, static_cast<std::int64_t>(span * random.uniform()));
}

void add_grid(const Subject& subject, std::size_t per_axis, std::vector<Row>& rows) {
  const auto& inputs = subject.problem().inputs;
  std::size_t count = 1;
  for (std::size_t k = 0; k < inputs.size(); ++k) count *= per_axis;
  for (std::size_t i = 0; i < count; ++i) {
    Row row;
    std::size_t rest = i;
    for (const Input& input : inputs) {
      row.push_back(on_scale(input, static_cast<double>(rest % per_axis) / static_cast<double>(per_axis - 1)));
      rest /= per_axis;
    }
    rows.push_back(std::move(row));
  }
}

using Specials = std::vector<std::vector<double>>; ///< of each input

/// A row of random and special numbers.
Row random_row(const Subject& subject, const Specials& special, Random& random) {
  Row row;
  for (std::size_t k = 0; k < special.size(); ++k) {
    const bool takes_special = special.size() > 1 && random.uniform() < 0.4;
    row.push_back(takes_special ? special[k][random.bits() % special[k].size()] : random_number(subject, k, random));
  }
  return row;
}

} // namespace

std::vector<Row> sweep(const Subject& subject) {
  const Size size = size_of(subject.problem());
  std::vector<Row> rows;
  add_grid(subject, size.grid, rows);
  Specials special;
  for (std::size_t k = 0; k < subject.problem().inputs.size(); ++k) special.push_back(special_numbers(subject, k));
  Random random(seed, subject.method().is_single() ? 1 : 0);
  for (std::size_t i = 0; i < size.random; ++i) rows.push_back(random_row(subject, special, random));
  if (!is_slow(subject.problem()))
    for (std::size_t k = 0; k < special.size(); ++k)
      for (const double x : special[k]) {
        rows.push_back(random_row(subject, special, random));
        rows.back()[k] = x;
      }
  for (Row& row : rows) row = subject.rounded(row);
  std::ranges::sort(rows);
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

} // namespace brdfplot::choice
