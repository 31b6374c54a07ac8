/// \file
/// Floating-point numbers in their order, as integers: neighbours differ by one.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace brdfplot::choice {

/// The place of `x` among the doubles, 0 at zero (both of them).
inline std::int64_t ordinal_of(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
}

inline std::int64_t ordinal_of(float x) {
  const auto bits = std::bit_cast<std::int32_t>(x);
  return bits >= 0 ? bits : std::int64_t{std::numeric_limits<std::int32_t>::min()} - bits;
}

/// The number at a place. \pre that of a number
template <class T>
T at_ordinal(std::int64_t place) {
  if constexpr (sizeof(T) == sizeof(double)) {
    return std::bit_cast<double>(place >= 0 ? place : std::numeric_limits<std::int64_t>::min() - place);
  } else {
    const std::int64_t bits = place >= 0 ? place : std::int64_t{std::numeric_limits<std::int32_t>::min()} - place;
    return std::bit_cast<float>(static_cast<std::int32_t>(bits));
  }
}

} // namespace brdfplot::choice
