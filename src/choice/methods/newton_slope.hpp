/// \file
/// The slope of a visible normal of Beckmann's distribution as renderers find it, for any number type.
#pragma once

#include "choice/methods/counted.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace brdfplot::choice {

/// erf^-1 (Boost.Math), counted as one transcendental function.
double erf_inverse(double x);
float erf_inverse(float x);
Counted erf_inverse(const Counted& x);

/// The slope below which a share u of the visible slopes lies, towards the viewer, at unit roughness: by Newton's rule
/// in b = erf(-x), on [-1, erf(cot theta)], from the start that Mitsuba has; a step that leaves the bracket halves it.
struct NewtonSlope {
  int steps;

  template <class T>
  T operator()(const std::array<T, 2>& in) const {
    using std::erf, std::exp, std::max, std::min, std::pow, std::tan;
    const T theta = in[0], v = T(1) - in[1], t = tan(theta), a = T(1) / t;
    const T root = T(std::numbers::inv_sqrtpi);
    const T most = erf(a), all = T(1) + most + root * t * exp(-(a * a));
    const T power = T(1) + theta * (T(-0.876) + theta * (T(0.4265) - T(0.0594) * theta));
    T low = T(-1), high = most, b = most - (T(1) + most) * pow(T(1) - v, power);
    const T end = T(1) - T(1e-6); // where erf^-1 still has digits in float
    for (int k = 0; k < steps; ++k) {
      if (!(b >= low && b <= high)) b = T(0.5) * (low + high);
      const T x = erf_inverse(max(min(b, end), -end));
      const T excess = (T(1) + b + root * t * exp(-(x * x))) / all - v;
      if (excess > T(0))
        high = b;
      else
        low = b;
      b -= excess * all / (T(1) - x * t);
    }
    if (!(b >= low && b <= high)) b = T(0.5) * (low + high);
    return -erf_inverse(max(min(b, end), -end));
  }
};

} // namespace brdfplot::choice
