#include "stream/grid.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/split.hpp"
#include "base/threads/interrupt.hpp"
#include "models/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace brdfplot {

namespace {

constexpr double most_rows = 1e9;

/// A whole number of steps, as far as rounding shows.
constexpr double rounding = 1e-9;

const std::vector<std::string>& angle_names() {
  static const std::vector<std::string> names = {"theta_o", "phi_o", "theta_i", "phi_i", "theta_m", "phi_m"};
  return names;
}

/// A number in its own unit. 0 has any.
struct Angle {
  double number = 0;
  bool degrees = false;

  bool fits(bool in_degrees) const { return number == 0 || degrees == in_degrees; }
  double radians() const { return degrees ? number / 180 * std::numbers::pi : number; }
};

std::optional<Angle> read_angle(std::string text) {
  if (!parse_angle(text) || !std::isfinite(*parse_angle(text))) return std::nullopt;
  while (text.ends_with(' ')) text.pop_back();
  for (const std::string unit : {"deg", "°"})
    if (text.ends_with(unit)) return Angle{*parse_number(text.substr(0, text.size() - unit.size())), true};
  return Angle{*parse_angle(text), false};
}

} // namespace

double GridAxis::value(std::uint64_t k) const {
  double at = from + static_cast<double>(k) * step;
  if (k + 1 == count && std::fabs(at - to) <= rounding * step) at = to;
  return degrees ? at / 180 * std::numbers::pi : at;
}

GridAxis grid_axis(const std::string& text, const std::string& where) {
  const auto fail = [&](const std::string& accepted) {
    throw InputError(where, "found \"" + echo(text) + "\"; accepted: " + accepted);
  };
  const std::string form = "NAME=FROM:TO:STEP, as theta_o=0:90deg:1deg, or NAME=VALUE";
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) fail(form);
  GridAxis out;
  out.name = text.substr(0, sign);
  if (std::ranges::find(angle_names(), out.name) == angle_names().end())
    throw InputError(where, unknown_name("angle", out.name, angle_names()));
  std::vector<Angle> numbers;
  for (const std::string& part : split(text.substr(sign + 1), ':')) {
    const auto number = read_angle(part);
    if (!number) fail(form);
    numbers.push_back(*number);
  }
  if (numbers.size() != 1 && numbers.size() != 3) fail(form);
  out.degrees = std::ranges::all_of(numbers, [](const Angle& one) { return one.fits(true); });
  const auto number = [&](std::size_t k) { return out.degrees ? numbers[k].number : numbers[k].radians(); };
  out.from = out.to = number(0);
  if (numbers.size() == 1) return out;
  out.to = number(1);
  out.step = number(2);
  if (!(out.step > 0)) fail("a step > 0");
  if (!(out.from <= out.to)) fail("FROM <= TO");
  const double steps = std::floor((out.to - out.from) / out.step + rounding);
  if (!(steps < most_rows)) fail("at most 1000000000 values");
  out.count = static_cast<std::uint64_t>(steps) + 1;
  return out;
}

GridRows::GridRows(const std::vector<std::string>& axes, std::string where) : where_(std::move(where)) {
  const auto has = [&](const std::string& name) {
    return std::ranges::find(axes_, name, &GridAxis::name) != axes_.end();
  };
  double rows = 1;
  for (const std::string& text : axes) {
    GridAxis axis = grid_axis(text, where_);
    if (has(axis.name)) throw InputError(where_, "\"" + axis.name + "\" is there twice");
    rows *= static_cast<double>(axis.count);
    axes_.push_back(std::move(axis));
  }
  for (const char letter : {'o', 'i', 'm'})
    if (has(std::string("phi_") + letter) && !has(std::string("theta_") + letter))
      throw InputError(where_, std::string("found \"phi_") + letter + "\" without \"theta_" + letter + "\"");
  if (!(rows <= most_rows))
    throw InputError(where_, "found " + format_number(rows) + " combinations; accepted: at most 1000000000");
  rows_ = static_cast<std::uint64_t>(rows);
  for (const GridAxis& axis : axes_) text_ += (text_.empty() ? "" : ",") + axis.name;
  text_ += '\n';
}

void GridRows::append_row(std::uint64_t row) {
  std::vector<double> values(axes_.size());
  for (std::size_t k = axes_.size(); k-- > 0;) {
    values[k] = axes_[k].value(row % axes_[k].count);
    row /= axes_[k].count;
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k > 0) text_ += ',';
    append_number(text_, values[k]);
  }
  text_ += '\n';
}

std::size_t GridRows::read(char* to, std::size_t size) {
  throw_if_interrupted();
  while (!stopped_ && text_.size() < size && next_ < rows_) append_row(next_++);
  if (stopped_) return 0;
  const std::size_t count = std::min(size, text_.size());
  std::memcpy(to, text_.data(), count);
  text_.erase(0, count);
  return count;
}

} // namespace brdfplot
