/// \file
/// A shape-invariant distribution of slopes whose shape the user writes.
#pragma once

#include "math/formula.hpp"
#include "microfacet/a_lambda_table.hpp"
#include "microfacet/distributions/shape_invariant.hpp"

#include <vector>

namespace brdfplot {

/// P22 = f(t2) / (pi int_0^inf f dt2) at alpha = 1 (Heitz 2014, Eq. 87), or P22 = f as it is written (`normalised`
/// false), as a shader may have it that is no density of a heightfield's slopes: `check` tells. f is a formula of t2,
/// the squared norm of the stretched slope, and of its root t. f must be finite from t2 = 0 on, not negative, and have
/// a finite mass and mean slope; half of the mass must lie within a t2 between 1e-4 and 1e4. Beyond t2 = 1e30 it is
/// taken for the power of t2 that it has become, or for 0. It may have up to 64 jumps, corners, and changes of scale
/// (radii).
struct CustomShape {
  struct Tail {
    double log_density = 0;  ///< ln of P22 at t2 = 1e30
    double power = infinity; ///< of 1 / t2
    double at(double log_t2) const;
  };

  Formula formula;
  double scale = 1; ///< P22 / f, 1 where it is as written
  Tail tail;
  std::vector<double> radii; ///< t: jumps, corners, and where the scale changes; integrals are to be cut there
  ALambdaTable table;

  static ModelSpec about();
  /// What is wrong with the shape, and where, if it is no density of slopes. Looked at from t2 = 1e-30 to 1e30,
  /// closely.
  static Made<CustomShape> from(const Values& values);

  /// \throws InputError where f is negative or not a number after all.
  double density(double t2) const;
  double scaled_density(double n2, double z2) const;
  /// From a table of the quadrature of these slopes. Values of f below 1e-290, where formulas underflow, count as 0.
  /// Error: 1e-10 relative, or 1e-200, whichever is more, as long as f has no structure narrower than a hundredth of
  /// t2.
  double a_lambda(double a) const { return table(a); }
};

using Custom = ShapeInvariant<CustomShape>;

} // namespace brdfplot
