/// \file
/// Adaptive integration over rectangles.
#pragma once

#include "math/quadrature.hpp"

namespace brdfplot {

/// [x0, x1] x [y0, y1] of the chart `chart`: which of several maps the integrand is to use there.
struct Rectangle {
  double x0 = 0, x1 = 1, y0 = 0, y1 = 1;
  std::size_t chart = 0;
};

/// Evaluates the integrand at n points of one chart into f.
using PlaneFunction =
    std::function<void(std::size_t chart, const double* x, const double* y, double* f, std::size_t n)>;

/// The integral of f over the rectangles together. On each a product of two Gauss-Kronrod rules, 15-31 in x and 7-15 in
/// y, with an error for each variable, judged as integrate() does from what the lines say one by one; the rectangle
/// with the largest error is halved across the variable that has the larger one. Smooth integrands converge at the
/// first rectangles; what is not smooth should lie on their edges. As in integrate(), halves that are far better than
/// the whole was are not believed before another cut says the same.
Estimate integrate_plane(const PlaneFunction& f, std::span<const Rectangle> rectangles, const Tolerance& tolerance,
                         std::size_t max_evaluations = 500000);

/// The same of `channels` functions at once, at most three: f writes channel c of point k to f[c n + k]. A rectangle
/// is divided where any of them asks for it, and all meet the tolerance.
ColourEstimate integrate_plane(const PlaneFunction& f, std::size_t channels, std::span<const Rectangle> rectangles,
                               const Tolerance& tolerance, std::size_t max_evaluations = 500000);

} // namespace brdfplot
