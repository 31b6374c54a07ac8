/// \file
/// Directions as NumPy has them: (N, 3), or (3,) for one that all rows share.
#pragma once

#include "math/direction.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot::python {

/// An array of doubles in C order; what is one already is not copied.
using Array = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// Directions of rows. A block of them at a time is taken apart into columns and made unit vectors.
class Directions {
public:
  /// \throws InputError where the shape is neither (N, 3) nor (3,)
  Directions(const Array& array, const std::string& name);

  /// How many rows; none: one that all share.
  std::optional<std::size_t> rows() const { return rows_; }

  /// Rows `first` to `first + n` in columns. \throws InputError for a row that is no direction: zero, or not finite
  void read(std::size_t first, std::size_t n, std::array<std::vector<double>, 3>& columns) const;
  Direction at(std::size_t row) const;

private:
  std::string name_;
  const double* data_;
  std::optional<std::size_t> rows_;
};

/// The number of rows of several, which have to agree; none where no array has rows. \throws InputError
std::optional<std::size_t> common_rows(const std::vector<const Directions*>& all);

} // namespace brdfplot::python
