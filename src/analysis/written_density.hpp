/// \file
/// A density of sampling that the user writes as a formula.
#pragma once

#include "analysis/weight_moments.hpp"
#include "math/formula.hpp"

#include <string>

namespace brdfplot {

/// A density (1/sr) as a renderer has it, to be tested against what a strategy draws. A formula (math/formula.hpp) of
/// `pdf`, the strategy's own; the directions x_o, y_o, z_o, x_i, ..., z_h (h the half vector) and their angles theta_o,
/// phi_o, theta_i, phi_i, theta_h, phi_h; and o_h, the cosine of o and h. 0 where o and i are opposite.
class WrittenDensity {
public:
  /// A reference to `sampler` is kept. \throws InputError at `where` when something is wrong with the formula
  WrittenDensity(const Sampler& sampler, const std::string& text, const std::string& where);
  void operator()(std::size_t n, const Columns& omega_o, const Columns& omega_i, double* out) const;

private:
  const Sampler* sampler_;
  Formula formula_;
};

} // namespace brdfplot
