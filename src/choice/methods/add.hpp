/// \file
/// What the files of problems share: a formula in double and float, a kernel on each instruction set, a table.
#pragma once

#include "choice/methods/method.hpp"
#include "math/kernels/isa_here.hpp"

namespace brdfplot::choice {

/// Lambda of a = cot(theta) / alpha, 1e-4 <= a <= largest; errors are seen in G1 = 1 / (1 + Lambda).
Problem lambda_of_a(const std::string& name, const std::string& doc, const std::string& source, double largest,
                    std::function<Exact(std::span<const double>)> exact);

/// A formula for any number type, in double and, as NAME_float, in float.
template <std::size_t inputs, class F>
void add_formula(Problem& problem, const std::string& name, const std::string& doc, const std::string& source,
                 Kind kind, F formula, const std::vector<std::array<double, inputs>>& examples) {
  problem.methods.push_back(method_of<double>(name, doc, source, kind, formula, examples));
  problem.methods.push_back(method_of<float>(name + "_float", doc + ", in float", source, kind, formula, examples));
}

/// What a kernel is said to be.
struct KernelText {
  std::string name, doc, source;
  Kind kind = Kind::kernel;
  double bound = 0;
};

/// `run` on each instruction set that this machine has: NAME (baseline), NAME_avx2, ... Its operations are those of
/// `like`, the formula that it is, per element.
template <class T>
void add_kernel(Problem& problem, const KernelText& text, const std::optional<Operations>& like, const Run<T>& run) {
  for (const kernels::Isa isa : kernels::available_isas()) {
    const bool baseline = isa == kernels::Isa::baseline;
    const std::string set(kernels::name(isa));
    problem.methods.push_back({.name = text.name + (baseline ? "" : "_" + set),
                               .doc = text.doc + ", " + set,
                               .source = text.source,
                               .kind = text.kind,
                               .run = Run<T>([run, isa](std::size_t n, const T* const* in, T* out) {
                                 const kernels::IsaHere here(isa);
                                 run(n, in, out);
                               }),
                               .operations = like,
                               .bound = text.bound,
                               .portable = baseline});
  }
}

/// The operations of the method of this name.
std::optional<Operations> operations_of(const Problem& problem, const std::string& name);

/// A function on [0, 1] at equal steps, and an entry beyond each end for cubics: a parabola through the last three.
class Table {
public:
  /// \pre steps >= 2
  template <class F>
  Table(std::size_t steps, const F& f) : steps_(steps) {
    entries_.push_back(0);
    for (std::size_t k = 0; k <= steps; ++k) entries_.push_back(f(static_cast<double>(k) / steps_d()));
    const auto beyond = [](double a, double b, double c) { return 3 * (a - b) + c; };
    entries_[0] = beyond(entries_[1], entries_[2], entries_[3]);
    entries_.push_back(beyond(entries_[steps + 1], entries_[steps], entries_[steps - 1]));
  }

  std::size_t bytes() const { return entries_.size() * sizeof(double); }

  /// x in [0, 1].
  template <class T>
  T linear(const T& x) const {
    T rest;
    const std::size_t k = cell(x, rest);
    const T low = read_entry<T>(entries_[k + 1]), high = read_entry<T>(entries_[k + 2]);
    return low + rest * (high - low);
  }

  /// Catmull and Rom 1974: the cubic through both entries whose slopes are the central differences.
  template <class T>
  T cubic(const T& x) const {
    T t;
    const std::size_t k = cell(x, t);
    const T p0 = read_entry<T>(entries_[k]), p1 = read_entry<T>(entries_[k + 1]);
    const T p2 = read_entry<T>(entries_[k + 2]), p3 = read_entry<T>(entries_[k + 3]);
    const T slope = T(0.5) * (p2 - p0), end_slope = T(0.5) * (p3 - p1), rise = p2 - p1;
    const T c2 = T(3.0) * rise - T(2.0) * slope - end_slope, c3 = slope + end_slope - T(2.0) * rise;
    return p1 + t * (slope + t * (c2 + t * c3));
  }

private:
  double steps_d() const { return static_cast<double>(steps_); }

  /// The step in which x lies, and how far in it.
  template <class T>
  std::size_t cell(const T& x, T& rest) const {
    using std::min;
    const T scaled = x * T(steps_d());
    const std::size_t k = whole_part(min(scaled, T(steps_d() - 1)));
    rest = scaled - T(static_cast<double>(k));
    return k;
  }

  std::size_t steps_;
  std::vector<double> entries_;
};

} // namespace brdfplot::choice
