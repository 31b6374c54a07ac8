/// \file
/// Differences of two materials over all pairs of directions.
#pragma once

#include "choice/compare/compare.hpp"

#include "brdf/evaluate.hpp"

namespace brdfplot::choice {

/// Two materials, ready.
struct MaterialPair {
  Material a, b;
  std::size_t channels;

  MaterialPair(const MaterialDescription& first, const MaterialDescription& second);

  bool is_isotropic() const;

  /// rho cos theta_i of one of them: channel c of row r at [c * n + r].
  std::vector<double> values(const Material& material, const Batch& batch) const;
};

/// Sets the largest differences, the RMS and the light (see MaterialDifference).
void set_differences(const MaterialPair& pair, const CompareOptions& options, MaterialDifference& out);

} // namespace brdfplot::choice
