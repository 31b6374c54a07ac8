/// \file
/// What a model is to run on, and what its operations cost there.
#pragma once

#include "choice/methods/operations.hpp"

#include <string>
#include <vector>

namespace brdfplot::choice {

enum class Precision { full, single };

enum class Target {
  shader,       ///< operation counts of a graphics processor, in single precision
  double_one,   ///< a processor, one value after the other, in double
  double_lanes, ///< its vector unit
  float_one,    ///< the same code in single precision to begin with
  float_lanes,
};

/// "shader", "double", "double_simd", "float", "float_simd".
const std::vector<std::string>& target_names();
/// \throws std::out_of_range
Target target_of(const std::string& name);

/// What the material in full is computed in. A shader's pictures are taken in double.
Precision precision_of(Target target);
/// Whether going from double to single precision is a simplification.
inline bool can_go_single(Target target) { return target == Target::double_one || target == Target::double_lanes; }

/// The estimated cost. Of a shader that of operations.hpp, in multiply-adds. Of a processor, in its own multiply-adds
/// in double (of a lane, where it has lanes), by the weights of this table: throughputs measured once on a processor of
/// the Zen family with vectors of 256 bits (libm and libmvec of glibc 2.36), rounded. It is a model that is the same
/// everywhere and always, since an answer that hangs on what else a machine does is none.
///
///                  multiply-add  comparison  division  root  exp, log  sin, acos, erf  table read
///   double          1             1           7         15    25        40              3
///   float           1             1           5         8     18        28              3
///   double_simd     1             1           6         14    20        32              18
///   float_simd      0.5           0.5         3         4     8         11              16
double cost(const Operations& operations, Target target, Precision precision);

/// "estimated operations", ...: of what costs are.
std::string cost_unit(Target target);

} // namespace brdfplot::choice
