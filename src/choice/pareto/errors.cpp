#include "choice/pareto/errors.hpp"

#include "base/threads/interrupt.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

template <class T>
std::vector<double> run_in(const Run<T>& method, const std::vector<std::vector<double>>& inputs) {
  const std::size_t n = inputs.at(0).size();
  std::vector<std::vector<T>> columns;
  std::vector<const T*> pointers;
  for (const auto& input : inputs) {
    auto& column = columns.emplace_back();
    column.reserve(n);
    for (const double x : input) column.push_back(static_cast<T>(x));
  }
  for (const auto& column : columns) pointers.push_back(column.data());
  std::vector<T> out(n);
  method(n, pointers.data(), out.data());
  std::vector<double> values;
  values.reserve(n);
  for (const T value : out) values.push_back(static_cast<double>(value));
  return values;
}

/// What is measured of a value against the exact one.
class Measures {
public:
  Measures(const Problem& problem, bool single)
      : problem_(problem), fraction_bits_(single ? 23 : 52), least_normal_(single ? 0x1p-126 : 0x1p-1022) {}

  /// value - exact, with the digits that the exact value has beyond a double.
  static double difference(double value, const Exact& exact) {
    if (value == exact.high) return -exact.low; // NOLINT(clang-diagnostic-float-equal): also where both are infinite
    const double error = (value - exact.high) - exact.low;
    return std::isnan(error) ? infinite : error;
  }
  double relative(double value, const Exact& exact) const {
    if (!(std::fabs(exact.high) >= least_normal_)) return 0;
    return std::fabs(difference(value, exact) / exact.high);
  }
  double ulp(double value, const Exact& exact) const {
    const int exponent = exact.high == 0 ? -2000 : std::ilogb(exact.high);
    const int least = fraction_bits_ == 23 ? -126 : -1022;
    return std::fabs(std::ldexp(difference(value, exact), fraction_bits_ - std::max(exponent, least)));
  }
  double absolute(double value, const Exact& exact) const {
    if (!problem_.seen) return difference(value, exact);
    const double error = problem_.seen(value) - problem_.seen(exact.high);
    return std::isnan(error) ? infinite : error;
  }

private:
  const Problem& problem_;
  int fraction_bits_;
  double least_normal_;
};

using Measure = std::function<double(double value, const Exact& exact)>;

void keep(Largest& largest, double error, double value, const Exact& exact, const std::vector<double>& input) {
  if (!largest.input.empty() && !(std::fabs(error) > std::fabs(largest.error))) return;
  largest = {error, input, value, exact.high};
}

/// Climbs from the worst sample: along each input in turn, by steps that halve where none helps, until the steps or the
/// exact values that it may ask for are used up.
class Climb {
public:
  Climb(const Problem& problem, const Method& method, double first_step)
      : problem_(problem), method_(method), first_step_(first_step) {}

  void from(Largest& largest, const Measure& measure) const {
    constexpr int halvings = 22;
    if (problem_.samples / 4 < 2 * problem_.inputs.size() * halvings) return; // it would not arrive
    double step = first_step_;
    std::size_t asked = 0;
    for (int k = 0; k < halvings && asked < problem_.samples / 4;) {
      throw_if_interrupted();
      asked += 2 * problem_.inputs.size();
      if (!improve(largest, measure, step)) {
        step /= 2;
        ++k;
      }
    }
  }

private:
  bool improve(Largest& largest, const Measure& measure, double step) const {
    bool better = false;
    for (std::size_t k = 0; k < problem_.inputs.size(); ++k)
      for (const double sign : {1.0, -1.0}) better = try_step(largest, measure, k, sign * step) || better;
    return better;
  }

  bool try_step(Largest& largest, const Measure& measure, std::size_t k, double step) const {
    std::vector<double> input = largest.input;
    const Input& range = problem_.inputs[k];
    input[k] = at_place(range, std::clamp(place_of(range, input[k]) + step, 0.0, 1.0));
    if (method_.is_single()) input[k] = static_cast<double>(static_cast<float>(input[k]));
    if (input[k] < range.low || input[k] > range.high) return false;
    std::vector<std::vector<double>> columns;
    for (const double x : input) columns.push_back({x});
    const Exact exact = problem_.exact(input);
    const double value = run(method_, columns).at(0), error = measure(value, exact);
    if (!(std::fabs(error) > std::fabs(largest.error) * (1 + 1e-12))) return false;
    largest = {error, input, value, exact.high};
    return true;
  }

  const Problem& problem_;
  const Method& method_;
  double first_step_;
};

double root_mean_square(double sum, std::size_t n) { return std::sqrt(sum / static_cast<double>(n)); }

} // namespace

std::vector<double> run(const Method& method, const std::vector<std::vector<double>>& inputs) {
  return std::visit([&](const auto& of) { return run_in(of, inputs); }, method.run);
}

const Largest& Errors::absolute() const { return -below.error > above.error ? below : above; }

Errors errors_of(const Problem& problem, const Method& method, const Samples& samples) {
  const std::vector<double> values = run(method, samples.inputs);
  const Measures measures(problem, method.is_single());
  Errors errors;
  double relative_sum = 0, absolute_sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Exact& exact = samples.exact[i];
    const std::vector<double> row = samples.row(i);
    const double relative = measures.relative(values[i], exact), absolute = measures.absolute(values[i], exact);
    keep(errors.relative, relative, values[i], exact, row);
    keep(errors.ulp, measures.ulp(values[i], exact), values[i], exact, row);
    if (absolute >= 0) keep(errors.above, absolute, values[i], exact, row);
    if (absolute < 0) keep(errors.below, absolute, values[i], exact, row);
    if (i >= samples.grid) continue;
    relative_sum += relative * relative;
    absolute_sum += absolute * absolute;
  }
  errors.relative_rms = root_mean_square(relative_sum, samples.grid);
  errors.absolute_rms = root_mean_square(absolute_sum, samples.grid);
  // Rounding is noise: there is nothing to climb.
  const double noise = method.is_single() ? 1e-5 : 1e-13;
  const double steps = std::pow(static_cast<double>(samples.grid), 1 / static_cast<double>(problem.inputs.size()));
  const Climb climb(problem, method, 0.5 / steps);
  const auto climbs = [&](const Largest& largest) {
    return std::fabs(largest.error) > noise && std::isfinite(largest.error);
  };
  if (climbs(errors.relative))
    climb.from(errors.relative, [&](double v, const Exact& e) { return measures.relative(v, e); });
  if (climbs(errors.above))
    climb.from(errors.above, [&](double v, const Exact& e) { return std::max(measures.absolute(v, e), 0.0); });
  if (climbs(errors.below))
    climb.from(errors.below, [&](double v, const Exact& e) { return std::min(measures.absolute(v, e), 0.0); });
  return errors;
}

} // namespace brdfplot::choice
