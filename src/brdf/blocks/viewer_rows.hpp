/// \file
/// Rows of directions that share a viewer, for integrals over the light or the normals.
#pragma once

#include "brdf/quantity.hpp"

#include <cstddef>
#include <vector>

namespace brdfplot {

/// Arrays of directions for evaluate(), refilled for every rule.
struct DirectionArrays {
  std::vector<double> x, y, z;
  void resize(std::size_t n) {
    x.resize(n);
    y.resize(n);
    z.resize(n);
  }
  void set(std::size_t k, const Direction& d) {
    x[k] = d.x;
    y[k] = d.y;
    z[k] = d.z;
  }
  Columns view() const { return {x.data(), y.data(), z.data()}; }
};

/// Rows that share omega_o.
class ViewerRows {
public:
  explicit ViewerRows(const Direction& omega_o) : o_(omega_o) {}

  /// n rows with lights direction_of(0) ... direction_of(n - 1); valid until the next call.
  template <class Function>
  Batch with_lights(std::size_t n, const Function& direction_of) {
    fill(n, others_, direction_of);
    return {n, viewers_.view(), others_.view(), {}};
  }
  /// The same with normals.
  template <class Function>
  Batch with_normals(std::size_t n, const Function& direction_of) {
    fill(n, others_, direction_of);
    return {n, viewers_.view(), {}, others_.view()};
  }

private:
  template <class Function>
  void fill(std::size_t n, DirectionArrays& others, const Function& direction_of) {
    const std::size_t known = viewers_.x.size();
    if (known < n) viewers_.resize(n);
    for (std::size_t k = known; k < n; ++k) viewers_.set(k, o_);
    others.resize(n);
    for (std::size_t k = 0; k < n; ++k) others.set(k, direction_of(k));
  }

  Direction o_;
  DirectionArrays viewers_, others_;
};

} // namespace brdfplot
