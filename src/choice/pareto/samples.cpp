#include "choice/pareto/samples.hpp"

#include "base/random.hpp"
#include "base/threads/parallel.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace brdfplot::choice {

namespace {

constexpr std::uint64_t seed = 2014;
constexpr std::size_t rows_at_once = 64;

/// Doubles in an order of integers, negative ones before.
std::int64_t order_of(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}

double of_order(std::int64_t order) {
  return std::bit_cast<double>(order < 0 ? std::numeric_limits<std::int64_t>::min() - order : order);
}

/// Every pattern of bits between the ends is as likely. From 0 on it starts at 2^-64 of the other end: what is below
/// would be nearly all of it.
double random_input(const Input& input, double uniform) {
  const double low = input.low == 0 ? input.high * 0x1p-64 : input.low;
  const double span = static_cast<double>(order_of(input.high)) - static_cast<double>(order_of(low));
  const double value = of_order(order_of(low) + static_cast<std::int64_t>(uniform * span));
  return std::clamp(value, input.low, input.high);
}

/// Inside the domain: the nearest float may be beyond its end.
double as_format(const Input& input, double value, bool single) {
  if (!single) return value;
  auto rounded = static_cast<float>(value);
  if (static_cast<double>(rounded) > input.high) rounded = std::nextafter(rounded, -HUGE_VALF);
  if (static_cast<double>(rounded) < input.low) rounded = std::nextafter(rounded, HUGE_VALF);
  return static_cast<double>(rounded);
}

/// How many steps each input has, so that their product is about `rows`.
std::size_t steps_per_input(std::size_t rows, std::size_t inputs) {
  const double root = std::pow(static_cast<double>(rows), 1 / static_cast<double>(inputs));
  return std::max<std::size_t>(2, static_cast<std::size_t>(std::lround(root)));
}

void add_grid(const Problem& problem, std::size_t rows, Samples& samples) {
  const std::size_t steps = steps_per_input(rows, problem.inputs.size());
  std::size_t all = 1;
  for (std::size_t k = 0; k < problem.inputs.size(); ++k) all *= steps;
  for (std::size_t i = 0; i < all; ++i) {
    std::size_t rest = i;
    for (std::size_t k = 0; k < problem.inputs.size(); ++k) {
      const double place = static_cast<double>(rest % steps) / static_cast<double>(steps - 1);
      samples.inputs[k].push_back(at_place(problem.inputs[k], place));
      rest /= steps;
    }
  }
  samples.grid = all;
}

} // namespace

std::vector<double> Samples::row(std::size_t index) const {
  std::vector<double> values;
  values.reserve(inputs.size());
  for (const auto& column : inputs) values.push_back(column[index]);
  return values;
}

double at_place(const Input& input, double place) {
  if (place <= 0) return input.low;
  if (place >= 1) return input.high;
  if (input.scale == Scale::linear) return input.low + place * (input.high - input.low);
  return std::clamp(input.low * std::exp(place * std::log(input.high / input.low)), input.low, input.high);
}

double place_of(const Input& input, double value) {
  if (!(input.high > input.low)) return 0;
  if (input.scale == Scale::linear) return (value - input.low) / (input.high - input.low);
  return std::log(value / input.low) / std::log(input.high / input.low);
}

Samples sample(const Problem& problem, bool single, int threads) {
  Samples samples{.single = single, .grid = 0, .inputs = {}, .exact = {}};
  samples.inputs.resize(problem.inputs.size());
  add_grid(problem, problem.samples / 2, samples);
  Random random(seed, 0);
  for (std::size_t i = 0; i < problem.samples / 2; ++i)
    for (std::size_t k = 0; k < problem.inputs.size(); ++k)
      samples.inputs[k].push_back(random_input(problem.inputs[k], random.uniform()));
  for (std::size_t k = 0; k < problem.inputs.size(); ++k)
    for (double& value : samples.inputs[k]) value = as_format(problem.inputs[k], value, single);
  samples.exact.resize(samples.inputs.at(0).size());
  const std::size_t blocks = (samples.size() + rows_at_once - 1) / rows_at_once;
  parallel_for(blocks, threads, [&](std::size_t block) {
    const std::size_t end = std::min(samples.size(), (block + 1) * rows_at_once);
    for (std::size_t i = block * rows_at_once; i < end; ++i) samples.exact[i] = problem.exact(samples.row(i));
  });
  return samples;
}

} // namespace brdfplot::choice
