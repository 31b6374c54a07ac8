#include "choice/stress/exhaustive.hpp"

#include "base/threads/interrupt.hpp"
#include "base/threads/parallel.hpp"
#include "choice/stress/ordinals.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>

namespace brdfplot::choice {

namespace {

constexpr std::int64_t block = 1 << 12, chunk = 1 << 20;

const Method* reference_of(const Problem& problem) {
  for (const Kind kind : {Kind::kernel, Kind::rewritten})
    for (const Method& method : problem.methods)
      if (method.kind == kind && !method.is_single() && method.portable) return &method;
  return nullptr;
}

/// The floats at some places in their order.
class Sweep {
public:
  Sweep(const Problem& problem, const Method& method, const Method& reference)
      : problem_(problem), run_(std::get<Run<float>>(method.run)), exact_(std::get<Run<double>>(reference.run)) {}

  Exhausted over(std::int64_t from, std::int64_t to) const {
    Exhausted worst;
    std::vector<float> x(block), value(block);
    std::vector<double> wide(block), exact(block);
    for (std::int64_t first = from; first < to; first += block) {
      throw_if_interrupted();
      const auto n = static_cast<std::size_t>(std::min(block, to - first));
      for (std::size_t k = 0; k < n; ++k) {
        x[k] = at_ordinal<float>(first + static_cast<std::int64_t>(k));
        wide[k] = static_cast<double>(x[k]);
      }
      const float* const in = x.data();
      const double* const wide_in = wide.data();
      run_(n, &in, value.data());
      exact_(n, &wide_in, exact.data());
      for (std::size_t k = 0; k < n; ++k) add(x[k], static_cast<double>(value[k]), exact[k], worst);
    }
    return worst;
  }

private:
  double seen(double value) const { return problem_.seen ? problem_.seen(value) : value; }

  void add(float at, double value, double exact, Exhausted& worst) const {
    if (!std::isfinite(value)) {
      ++worst.not_finite;
      return;
    }
    const double is = seen(exact);
    const double error = std::fabs(seen(value) - is) / std::fmax(std::fabs(is), 0x1p-63);
    if (!(error > worst.error)) return;
    worst.error = error;
    worst.at = at;
  }

  const Problem& problem_;
  const Run<float>& run_;
  const Run<double>& exact_;
};

/// The least float that is not below, and the largest that is not above.
std::pair<std::int64_t, std::int64_t> places_of(const Input& input) {
  auto low = static_cast<float>(input.low), high = static_cast<float>(input.high);
  if (static_cast<double>(low) < input.low) low = std::nextafter(low, INFINITY);
  if (static_cast<double>(high) > input.high) high = std::nextafter(high, -INFINITY);
  return {ordinal_of(low), ordinal_of(high) + 1};
}

} // namespace

std::vector<Exhausted> exhaust(const Problem& problem, const std::string& only, int threads,
                               const std::function<void(double share)>& progress) {
  std::vector<Exhausted> out;
  const Method* reference = reference_of(problem);
  if (problem.inputs.size() != 1 || reference == nullptr) return out;
  const auto [first, last] = places_of(problem.inputs[0]);
  const std::int64_t begin = first, end = last;
  const auto chunks = static_cast<std::size_t>((end - begin + chunk - 1) / chunk);
  for (const Method& method : problem.methods) {
    if (!method.is_single() || !method.portable || (!only.empty() && method.name != only)) continue;
    const Sweep sweep(problem, method, *reference);
    std::vector<Exhausted> parts(chunks);
    std::mutex mutex;
    std::size_t done = 0;
    parallel_for(chunks, threads, [&](std::size_t k) {
      const std::int64_t from = begin + static_cast<std::int64_t>(k) * chunk;
      parts[k] = sweep.over(from, std::min(from + chunk, end));
      const std::lock_guard lock(mutex);
      progress(static_cast<double>(++done) / static_cast<double>(chunks));
    });
    Exhausted worst{problem.name, method.name, reference->name, static_cast<std::uint64_t>(end - begin)};
    for (const Exhausted& part : parts) { // in the order of the inputs, whatever thread they were on
      worst.not_finite += part.not_finite;
      if (!(part.error > worst.error)) continue;
      worst.error = part.error;
      worst.at = part.at;
    }
    out.push_back(worst);
  }
  return out;
}

std::string exhausted_markdown(const std::vector<Exhausted>& all) {
  std::string out =
      "| method | floats | largest error | at | not finite | against |\n| -- | -- | -- | -- | -- | -- |\n";
  for (const Exhausted& one : all) {
    char text[96];
    std::snprintf(text, sizeof text, " | %.3g | %.9g | ", one.error, static_cast<double>(one.at));
    out += "| " + one.problem + "/" + one.method + " | " + std::to_string(one.inputs) + text +
           std::to_string(one.not_finite) + " | " + one.against + " |\n";
  }
  return out;
}

} // namespace brdfplot::choice
