/// \file
/// How much a formula computes, counted: what does not depend on the machine.
#pragma once

#include <cstddef>

namespace brdfplot::choice {

/// The operations of one evaluation.
struct Operations {
  std::size_t multiply_adds =
      0;                       ///< of each sum, difference and product; a product that is added at once is one with it
  std::size_t comparisons = 0; ///< minima and maxima too
  std::size_t divisions = 0;
  std::size_t square_roots = 0;
  std::size_t exponentials = 0;    ///< exp and log, one instruction of a graphics processor each; pow is two
  std::size_t transcendentals = 0; ///< sin, cos, acos, atan, erf: polynomials of dozens of operations
  std::size_t table_reads = 0;

  Operations& operator+=(const Operations& other);
  friend bool operator==(const Operations&, const Operations&) = default;
};

/// The estimated cost in multiply-adds: 1 for a multiply-add or a comparison, 4 for a division, a square root or an
/// exponential, 24 for another transcendental function, 8 for a table read. The weights are those of issue rates of
/// graphics processors, rounded; they rank formulas, and are no times.
double cost(const Operations& operations);

} // namespace brdfplot::choice
