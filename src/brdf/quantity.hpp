/// \file
/// The quantities that can be evaluated, and the directions that they are functions of.
#pragma once

#include "brdf/term.hpp"

#include <string>
#include <vector>

namespace brdfplot {

enum class Quantity { lambda, p22, d, d_cos, g1, g2, d_visible, fresnel, brdf, brdf_cos };

/// Which directions a quantity is a function of.
struct Needs {
  bool o = false;
  bool i = false;
  bool m = false; ///< where i is given the half vector serves for it
};

/// What has a quantity: a microsurface, its facets, or a material as the sum of its terms.
enum class Owner { microsurface, fresnel, material };

struct QuantityInfo {
  Quantity quantity;
  std::string name;
  std::string doc;
  Needs needs;
  Owner owner;

  /// Whether it has as many channels as what it is of.
  bool coloured() const { return owner != Owner::microsurface; }
};

/// All quantities with a closed form, in the order of `Quantity`.
const std::vector<QuantityInfo>& quantities();
const QuantityInfo& info_of(Quantity quantity);

/// n rows of unit vectors (for `m`: within rounding; the half vector of o and i where it is not given).
struct Batch {
  std::size_t n = 0;
  Columns o, i, m;
};

/// The batch without what `quantity` is no function of: a normal given beside o and i, for brdf and brdf_cos, whose
/// facets are those of the half vector.
Batch used_by(Quantity quantity, const Batch& batch);

/// Whether `value` can be one of `quantity`: finite, or the infinite lambda at and below the horizon. The last guard of
/// all that prints values.
bool is_told(Quantity quantity, double value);

} // namespace brdfplot
