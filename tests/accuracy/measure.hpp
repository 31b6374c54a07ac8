/// \file
/// Errors in ulp against the reference, collected per function and domain into the accuracy table.
#pragma once

#include "accuracy/bounds.hpp"
#include "math/kernels/kernels.hpp"
#include "reference/reference.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#if __has_include(<quadmath.h>)
#include <boost/multiprecision/float128.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace brdfplot::accuracy {

#if __has_include(<quadmath.h>)
using Quad = boost::multiprecision::float128;
#else
using Quad = boost::multiprecision::cpp_bin_float_quad;
#endif

/// How many inputs a row of the table gets: 8000 (500 in a sampled run), or what BRDFPLOT_ACCURACY_INPUTS says.
std::size_t inputs_per_row();

/// |value - exact| in ulp of T. Where the exact result is beyond the range of T, the largest finite number and infinity
/// are both right.
template <class T, class R>
double ulp_error(T value, const R& exact) {
  using std::abs, std::frexp, std::ldexp;
  using Limits = std::numeric_limits<T>;
  if (std::isnan(value)) return std::numeric_limits<double>::infinity();
  const R size = abs(exact);
  if (size > R(Limits::max())) return std::abs(value) >= Limits::max() ? 0 : std::numeric_limits<double>::infinity();
  if (std::isinf(value)) return std::numeric_limits<double>::infinity();
  int exponent = 0;
  if (size > 0) (void)frexp(size, &exponent);
  const int unit =
      size > 0 ? std::max(exponent, Limits::min_exponent) - Limits::digits : Limits::min_exponent - Limits::digits;
  return static_cast<double>(R(ldexp(R(abs(R(R(value) - exact))), -unit)));
}

/// One row of the accuracy table.
class Row {
public:
  Row(std::string function, std::string type, std::string isa, std::string domain, Bound bound)
      : function_(std::move(function)), type_(std::move(type)), isa_(std::move(isa)), domain_(std::move(domain)),
        bound_(bound) {}

  /// `exponent` is the E of Bound; the error is scaled so that the bound is bound.ulp for every E.
  void add(double error, const std::function<std::string()>& input, double exponent = 0) {
    const double scaled = error / (1 + bound_.per_exponent / bound_.ulp * std::min(exponent, 800.0));
    ++count_;
    sum_of_squares_ += scaled * scaled;
    if (!(scaled <= largest_)) {
      largest_ = scaled;
      worst_ = input();
    }
  }

  std::size_t count() const { return count_; }
  double largest() const { return largest_; }
  double bound() const { return bound_.ulp; }
  std::string label() const { return function_ + ", " + type_ + ", " + isa_ + ", " + domain_ + ": " + worst_; }

  /// Appends the row to the file that BRDFPLOT_ACCURACY_TABLE names, if it does; the first row of a run starts it anew.
  void write() const;

private:
  std::string function_, type_, isa_, domain_;
  Bound bound_;
  std::size_t count_ = 0;
  double largest_ = 0, sum_of_squares_ = 0;
  std::string worst_;
};

/// Checks the bound of a row and writes it.
void finish(const Row& row);

/// The same function on every instruction set of this machine: a row each. Restores the one in use.
template <class Run>
void for_each_isa(const Run& run) {
  const kernels::Isa before = kernels::active_isa();
  for (const kernels::Isa isa : kernels::available_isas()) {
    kernels::use_isa(isa);
    run(std::string(kernels::name(isa)));
  }
  kernels::use_isa(before);
}

/// Reproducible random numbers; the same on every machine.
class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low = 0, double high = 1) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  double log_uniform(double low, double high) { return low * std::exp(uniform() * std::log(high / low)); }
  bool chance(double probability) { return uniform() < probability; }
  /// Any bit pattern between those of two positive numbers: all exponents alike, subnormal ones included.
  template <class T>
  T pattern(T low, T high);

private:
  std::mt19937_64 engine_;
};

template <class T>
const char* type_name() {
  return sizeof(T) == sizeof(double) ? "double" : "float";
}

/// A number in the shortest form that reads back to it.
std::string text(double x);

} // namespace brdfplot::accuracy
