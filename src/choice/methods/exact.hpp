/// \file
/// The number type of exact values. Included by the sources of problems only: Boost.Multiprecision is large.
#pragma once

#include "choice/methods/method.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace brdfplot::choice {

/// 50 digits.
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

inline Exact exact_of(const Real& value) {
  const auto high = static_cast<double>(value);
  return {high, std::isfinite(high) ? static_cast<double>(Real(value - high)) : 0.0};
}

} // namespace brdfplot::choice
