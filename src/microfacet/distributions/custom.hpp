/// \file
/// A shape-invariant distribution of slopes whose shape the user writes.
#pragma once

#include "math/formula.hpp"
#include "microfacet/a_lambda_table.hpp"
#include "microfacet/shape_invariant.hpp"

namespace brdfplot {

/// P22 = f(t2) / (pi int_0^inf f dt2) at alpha = 1 (Heitz 2014, Eq. 87), f a formula of t2, the squared norm of the
/// stretched slope, and of its root t. f must be finite and not negative, and have a finite mass and mean slope.
struct CustomShape {
  Formula formula;
  double scale = 1; ///< P22 / f
  ALambdaTable table;

  static ModelSpec about();
  /// What is wrong with the shape, and where, if it is no density of slopes. Looked at from t2 = 1e-30 to 1e30,
  /// closely.
  static Made<CustomShape> from(const Values& values);

  /// \throws InputError where f is negative or not a number after all.
  double density(double t2) const;
  double scaled_density(double n2, double z2) const;
  /// From a table of the quadrature of these slopes; relative error 1e-10.
  double a_lambda(double a) const { return table(a); }
};

using Custom = ShapeInvariant<CustomShape>;

} // namespace brdfplot
