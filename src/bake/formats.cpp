#include "bake/formats.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace brdfplot::bake {

namespace {

/// The bits of the nearest binary16, ties to even.
std::uint16_t half_bits(double value) {
  const std::uint16_t sign = std::signbit(value) ? 0x8000 : 0;
  const double size = std::fabs(value);
  int exponent = 0;
  std::frexp(size, &exponent);
  const int step = std::max(exponent - 11, -24); // the last of 11 bits, or of a subnormal number
  const auto units = static_cast<std::uint32_t>(std::nearbyint(std::ldexp(size, -step)));
  if (size == 0 || units == 0) return sign;
  // 2^10 units and more are normal: the leading bit adds one to the exponent's field, and a carry one more.
  return static_cast<std::uint16_t>(sign | ((static_cast<std::uint32_t>(step + 24) << 10) + units));
}

double of_half(std::uint16_t bits) {
  const int field = bits >> 10 & 31, fraction = bits & 1023;
  const double size = field == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, field - 25);
  return (bits & 0x8000) != 0 ? -size : size;
}

std::string axis_text(const Axis& axis) {
  std::string text = axis.variable + " from " + format_number(axis.from) + " to " + format_number(axis.to) + ", " +
                     std::to_string(axis.nodes) + " nodes at from + (to - from) t";
  if (axis.power != 1) text += "^" + std::to_string(axis.power);
  return text + ", t = k / " + std::to_string(axis.nodes - 1);
}

/// Upwards, as a bound.
std::string two_digits(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.2g", value * 1.005);
  return text.data();
}

} // namespace

double rounded(double value, Stored stored) {
  switch (stored) {
  case Stored::float32: return static_cast<float>(value);
  case Stored::half: return of_half(half_bits(value));
  case Stored::float64: break;
  }
  return value;
}

double rounding_of(const Table& table, Stored stored) {
  double largest = 0;
  for (const double value : table.values) largest = std::fmax(largest, std::fabs(rounded(value, stored) - value));
  return largest;
}

void append_number(std::string& bytes, double value, Stored stored) {
  switch (stored) {
  case Stored::float32: append_bytes(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value))); break;
  case Stored::half: append_bytes(bytes, half_bits(value)); break;
  case Stored::float64: append_bytes(bytes, std::bit_cast<std::uint64_t>(value)); break;
  }
}

const std::vector<TableFormat>& table_formats() {
  static const std::vector<TableFormat> all = {
      {".npy", "NumPy", {Stored::float32, Stored::half, Stored::float64}, npy_bytes},
      {".ktx2", "a texture of Khronos, of 1 to 3 axes", {Stored::float32, Stored::half}, ktx2_bytes},
      {".exr", "an image, of 1 or 2 axes", {Stored::float32, Stored::half}, exr_bytes},
      {".h", "C, with a function that reads it", {Stored::float32}, c_header},
      {".glsl", "GLSL, with a function that reads it", {Stored::float32}, glsl_source},
      {".csv", "a row a node", {Stored::float64}, csv_text},
  };
  return all;
}

const TableFormat& format_of(const std::string& path) {
  std::string endings;
  for (const TableFormat& format : table_formats()) {
    if (path.ends_with(format.ending)) return format;
    endings += (endings.empty() ? "" : ", ") + format.ending;
  }
  throw InputError("-o", "found \"" + echo(path) + "\"; accepted: a name that ends in " + endings);
}

std::vector<std::string> description_of(const BakedTable& baked) {
  const Table& table = baked.table;
  std::string values = table.channels.front();
  for (std::size_t c = 1; c < table.channels.size(); ++c) values += ", " + table.channels[c];
  std::vector<std::string> lines = {table.quantity + " of " + table.material + ": " + values};
  for (std::size_t k = 0; k < table.axes.size(); ++k)
    lines.push_back("axis " + std::to_string(k) + ": " + axis_text(table.axes[k]));
  lines.push_back("interpolated linearly in t it is off by at most " + two_digits(baked.bound) +
                  ", as measured between the nodes");
  return lines;
}

} // namespace brdfplot::bake
