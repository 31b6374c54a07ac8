#include "choice/pareto/times.hpp"

#include "base/random.hpp"
#include "base/threads/interrupt.hpp"
#include "choice/pareto/samples.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <numeric>

#include <sched.h>

namespace brdfplot::choice {

namespace {

constexpr std::size_t block = 4096;
constexpr int rounds = 25, least_rounds = 5;
constexpr double most_seconds_of_all = 3; ///< of a problem, once there are enough rounds
constexpr double least_seconds = 60e-6;   ///< of a measurement, far above what the clock resolves
constexpr double most_seconds = 1e-3;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Keeps this thread on the processor on which it is, as long as it lives.
class OnOneProcessor {
public:
  OnOneProcessor() {
    known_ = sched_getaffinity(0, sizeof before_, &before_) == 0;
    const int here = sched_getcpu();
    if (!known_ || here < 0) return;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<std::size_t>(here), &one);
    sched_setaffinity(0, sizeof one, &one);
  }
  ~OnOneProcessor() {
    if (known_) sched_setaffinity(0, sizeof before_, &before_);
  }
  OnOneProcessor(const OnOneProcessor&) = delete;
  OnOneProcessor& operator=(const OnOneProcessor&) = delete;

private:
  cpu_set_t before_{};
  bool known_ = false;
};

template <class T>
struct TimedColumns {
  std::vector<std::vector<T>> values;
  std::vector<const T*> pointers;
};

std::vector<std::vector<double>> usual_inputs(const Problem& problem) {
  Random random(99, 0);
  std::vector<std::vector<double>> columns(problem.inputs.size());
  for (std::size_t i = 0; i < block; ++i)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Input input = problem.inputs[k];
      if (input.usual) input.low = (*input.usual)[0], input.high = (*input.usual)[1];
      columns[k].push_back(at_place(input, random.uniform()));
    }
  return columns;
}

template <class T>
TimedColumns<T> in_format(const std::vector<std::vector<double>>& inputs) {
  TimedColumns<T> columns;
  for (const auto& input : inputs) {
    auto& column = columns.values.emplace_back();
    column.reserve(input.size());
    for (const double x : input) column.push_back(static_cast<T>(x));
  }
  for (const auto& column : columns.values) columns.pointers.push_back(column.data());
  return columns;
}

/// A method with how many values a measurement takes of it, and how often.
class Stopwatch {
public:
  Stopwatch(std::function<void(std::size_t)> run) : run_(std::move(run)) {
    run_(1); // tables that are made at the first use
    double seconds = once();
    while (values_ < block && seconds < most_seconds / 2) {
      values_ *= 2;
      seconds = once();
    }
    seconds = std::max(seconds, 1e-9);
    times_ = static_cast<std::size_t>(std::ceil(std::max(1.0, least_seconds / seconds)));
  }
  /// Nanoseconds a value.
  double measure() const {
    const double began = processor_seconds();
    for (std::size_t k = 0; k < times_; ++k) run_(values_);
    return 1e9 * (processor_seconds() - began) / static_cast<double>(times_ * values_);
  }

private:
  double once() const {
    const double began = processor_seconds();
    run_(values_);
    return processor_seconds() - began;
  }

  std::function<void(std::size_t)> run_;
  std::size_t values_ = 1;
  std::size_t times_ = 1;
};

Time time_of(std::vector<double> measured) {
  std::ranges::sort(measured);
  const auto at = [&](double share) {
    return measured[static_cast<std::size_t>(std::lround(share * static_cast<double>(measured.size() - 1)))];
  };
  return {at(0), at(0.25), at(0.5), at(0.75)};
}

std::string processor_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) {
      const std::size_t start = line.find_first_not_of(" \t", line.find(':') + 1);
      if (start != std::string::npos) return line.substr(start);
    }
  return "unknown processor";
}

std::string compiler_name() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

} // namespace

std::vector<Time> times_of(const Problem& problem, const std::function<void(double)>& rest) {
  const OnOneProcessor here;
  const auto inputs = usual_inputs(problem);
  const auto doubles = in_format<double>(inputs);
  const auto floats = in_format<float>(inputs);
  std::vector<double> out_double(block);
  std::vector<float> out_float(block);
  std::vector<Stopwatch> watches;
  for (const Method& method : problem.methods) {
    throw_if_interrupted();
    if (const auto* run = std::get_if<Run<double>>(&method.run))
      watches.emplace_back([&, run](std::size_t n) { (*run)(n, doubles.pointers.data(), out_double.data()); });
    else
      watches.emplace_back([&, run = &std::get<Run<float>>(method.run)](std::size_t n) {
        (*run)(n, floats.pointers.data(), out_float.data());
      });
  }
  std::vector<std::vector<double>> measured(watches.size());
  std::vector<std::size_t> order(watches.size());
  std::iota(order.begin(), order.end(), 0);
  Random random(7, 0);
  const double began = processor_seconds();
  for (int round = 0; round < rounds; ++round) {
    if (round >= least_rounds && processor_seconds() - began > most_seconds_of_all) break;
    rest(round / static_cast<double>(rounds));
    for (std::size_t k = order.size(); k > 1; --k)
      std::swap(order[k - 1], order[static_cast<std::size_t>(random.uniform() * static_cast<double>(k))]);
    for (const std::size_t k : order) {
      throw_if_interrupted();
      measured[k].push_back(watches[k].measure());
    }
  }
  std::vector<Time> times;
  for (auto& of : measured) times.push_back(time_of(std::move(of)));
  return times;
}

MachineRecord machine_record() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 16> date{};
  std::strftime(date.data(), date.size(), "%Y-%m-%d", &utc);
  return {processor_model(), compiler_name(), date.data()};
}

} // namespace brdfplot::choice
