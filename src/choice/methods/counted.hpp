/// \file
/// A number that counts what is done with it. A formula written for any number type is counted by calling it with this
/// one: the operations of the branch that is taken.
#pragma once

#include "choice/methods/operations.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace brdfplot::choice {

class Counted {
public:
  Counted() = default;
  Counted(double value) : value_(value) {} // NOLINT(google-explicit-constructor): constants mix with it

  double value() const { return value_; }

  /// What has been counted in this thread since reset().
  static Operations& operations() {
    thread_local Operations counted;
    return counted;
  }
  static void reset() { operations() = {}; }

  Counted operator-() const { return {-value_, product_}; } // a sign is free
  friend Counted operator+(const Counted& u, const Counted& v) { return sum(u, v, u.value_ + v.value_); }
  friend Counted operator-(const Counted& u, const Counted& v) { return sum(u, v, u.value_ - v.value_); }
  friend Counted operator*(const Counted& u, const Counted& v) {
    ++operations().multiply_adds;
    return {u.value_ * v.value_, true};
  }
  friend Counted operator/(const Counted& u, const Counted& v) {
    ++operations().divisions;
    return {u.value_ / v.value_, false};
  }
  Counted& operator+=(const Counted& v) { return *this = *this + v; }
  Counted& operator-=(const Counted& v) { return *this = *this - v; }
  Counted& operator*=(const Counted& v) { return *this = *this * v; }
  Counted& operator/=(const Counted& v) { return *this = *this / v; }

  friend bool operator<(const Counted& u, const Counted& v) { return compared(u.value_ < v.value_); }
  friend bool operator>(const Counted& u, const Counted& v) { return compared(u.value_ > v.value_); }
  friend bool operator<=(const Counted& u, const Counted& v) { return compared(u.value_ <= v.value_); }
  friend bool operator>=(const Counted& u, const Counted& v) { return compared(u.value_ >= v.value_); }
  friend bool operator==(const Counted& u, const Counted& v) {
    // NOLINTNEXTLINE(clang-diagnostic-float-equal)
    return compared(u.value_ == v.value_);
  }

  friend Counted min(const Counted& u, const Counted& v) { return u < v ? u : v; }
  friend Counted max(const Counted& u, const Counted& v) { return u > v ? u : v; }
  friend Counted fmin(const Counted& u, const Counted& v) { return min(u, v); }
  friend Counted fmax(const Counted& u, const Counted& v) { return max(u, v); }
  friend Counted abs(const Counted& u) { return {std::abs(u.value_), false}; } // a modifier, free
  friend Counted fabs(const Counted& u) { return abs(u); }
  friend Counted sqrt(const Counted& u) {
    ++operations().square_roots;
    return {std::sqrt(u.value_), false};
  }
  friend Counted exp(const Counted& u) { return exponential(std::exp(u.value_)); }
  friend Counted exp2(const Counted& u) { return exponential(std::exp2(u.value_)); }
  friend Counted log(const Counted& u) { return exponential(std::log(u.value_)); }
  friend Counted expm1(const Counted& u) { return exponential(std::expm1(u.value_)); }
  friend Counted log1p(const Counted& u) { return exponential(std::log1p(u.value_)); }
  friend Counted log2(const Counted& u) { return exponential(std::log2(u.value_)); }
  friend Counted pow(const Counted& u, const Counted& v) {
    operations().exponentials += 2;
    ++operations().multiply_adds;
    return {std::pow(u.value_, v.value_), false};
  }
  friend Counted sin(const Counted& u) { return transcendental(std::sin(u.value_)); }
  friend Counted cos(const Counted& u) { return transcendental(std::cos(u.value_)); }
  friend Counted tan(const Counted& u) { return transcendental(std::tan(u.value_)); }
  friend Counted acos(const Counted& u) { return transcendental(std::acos(u.value_)); }
  friend Counted atan(const Counted& u) { return transcendental(std::atan(u.value_)); }
  friend Counted atan2(const Counted& u, const Counted& v) { return transcendental(std::atan2(u.value_, v.value_)); }
  friend Counted erf(const Counted& u) { return transcendental(std::erf(u.value_)); }
  friend Counted erfc(const Counted& u) { return transcendental(std::erfc(u.value_)); }

  /// The largest whole number that is not above, for tables: a conversion.
  friend std::size_t whole_part(const Counted& u) {
    ++operations().multiply_adds;
    return static_cast<std::size_t>(u.value_);
  }

private:
  Counted(double value, bool product) : value_(value), product_(product) {}

  /// One operation with a product among its terms, which was counted when it was made.
  static Counted sum(const Counted& u, const Counted& v, double value) {
    if (!u.product_ && !v.product_) ++operations().multiply_adds;
    return {value, false};
  }
  static bool compared(bool result) {
    ++operations().comparisons;
    return result;
  }
  static Counted exponential(double value) {
    ++operations().exponentials;
    return {value, false};
  }
  static Counted transcendental(double value) {
    ++operations().transcendentals;
    return {value, false};
  }

  double value_ = 0;
  bool product_ = false; ///< a product that may be added in the same operation
};

inline std::size_t whole_part(double x) { return static_cast<std::size_t>(x); }
inline std::size_t whole_part(float x) { return static_cast<std::size_t>(x); }

/// An entry of a table as a number of type T.
template <class T>
T read_entry(double entry) {
  if constexpr (std::is_same_v<T, Counted>) ++Counted::operations().table_reads;
  return static_cast<T>(entry);
}

/// What `formula()` computes, a call that uses Counted numbers.
template <class F>
Operations counted(const F& formula) {
  Counted::reset();
  (void)formula();
  return Counted::operations();
}

} // namespace brdfplot::choice
