#include "bake/text.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace brdfplot::bake {

namespace {

std::string digits(double value, int count) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", count, value);
  return text.data();
}

std::string size_text(const Table& table) {
  std::string text;
  for (const Axis& axis : table.axes) text += std::to_string(axis.nodes) + " x ";
  return text + std::to_string(table.channels.size());
}

std::string axis_line(const BakedTable& baked, std::size_t k) {
  const Axis& axis = baked.table.axes[k];
  std::string text = "axis       " + axis.variable + " " + digits(axis.from, 6) + " to " + digits(axis.to, 6) + ", " +
                     std::to_string(axis.nodes) + " nodes";
  if (axis.power != 1) text += " at t^" + std::to_string(axis.power);
  return text + "; half-way between two it is off by up to " + digits(baked.axis_error[k], 2) + "\n";
}

} // namespace

std::string summary(const BakedTable& baked, double rounding) {
  const Table& table = baked.table;
  const auto range = std::ranges::minmax_element(table.values);
  std::string text = "table      " + table.quantity + " of " + table.material + ": " + size_text(table) + " numbers, " +
                     digits(*range.min, 4) + " to " + digits(*range.max, 4) + "\n";
  for (std::size_t k = 0; k < table.axes.size(); ++k) text += axis_line(baked, k);
  std::string place;
  for (std::size_t k = 0; k < table.axes.size(); ++k)
    place += (k == 0 ? "" : ", ") + table.axes[k].variable + " = " + digits(baked.where[k], 4);
  text += "error      at most " + digits(baked.bound + rounding, 2) + ": interpolated " +
          digits(baked.bound - baked.tolerance, 2) + ", largest at " + place + "; integrals " +
          digits(baked.tolerance, 1);
  if (rounding > 0) text += "; numbers as they are stored " + digits(rounding, 1);
  return text + "\n";
}

} // namespace brdfplot::bake
