#include "arrays.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"

#include <cmath>

namespace brdfplot::python {

namespace {

std::string shape_text(const Array& array) {
  std::string text = "(";
  for (pybind11::ssize_t k = 0; k < array.ndim(); ++k) text += (k > 0 ? ", " : "") + std::to_string(array.shape(k));
  return text + (array.ndim() == 1 ? ",)" : ")");
}

} // namespace

Directions::Directions(const Array& array, const std::string& name) : name_(name), data_(array.data()) {
  const bool one = array.ndim() == 1 && array.shape(0) == 3, many = array.ndim() == 2 && array.shape(1) == 3;
  if (!one && !many) throw InputError(name, "found the shape " + shape_text(array) + ", accepted: (N, 3) or (3,)");
  if (many) rows_ = static_cast<std::size_t>(array.shape(0));
}

Direction Directions::at(std::size_t row) const {
  const double* const v = data_ + (rows_ ? 3 * row : 0);
  const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  constexpr double unit = 1e-15; // squares of what was made a unit vector are off by no more
  if (std::fabs(square - 1) <= unit) return {v[0], v[1], v[2]};
  if (!(square > 0) || !std::isfinite(square))
    throw InputError(name_, "found [" + format_number(v[0]) + ", " + format_number(v[1]) + ", " + format_number(v[2]) +
                                "] in row " + std::to_string(row) + ", accepted: a direction");
  return normalized({v[0], v[1], v[2]});
}

void Directions::read(std::size_t first, std::size_t n, std::array<std::vector<double>, 3>& columns) const {
  for (std::vector<double>& column : columns) column.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Direction d = at(first + k);
    columns[0][k] = d.x;
    columns[1][k] = d.y;
    columns[2][k] = d.z;
  }
}

std::optional<std::size_t> common_rows(const std::vector<const Directions*>& all) {
  std::optional<std::size_t> rows;
  for (const Directions* one : all) {
    if (!one->rows()) continue;
    if (rows && *rows != *one->rows())
      throw InputError("brdfplot", "found arrays of " + std::to_string(*rows) + " and " + std::to_string(*one->rows()) +
                                       " directions, accepted: as many of each, or one");
    rows = one->rows();
  }
  return rows;
}

} // namespace brdfplot::python
