#include "bake/axis.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/split.hpp"

#include <cmath>
#include <optional>
#include <vector>

namespace brdfplot::bake {

namespace {

constexpr double most_nodes = 4096, most_power = 8;

std::optional<double> whole(const std::string& text, double least, double most) {
  const std::optional<double> number = parse_number(text);
  if (!number || !(*number >= least && *number <= most) || std::floor(*number) < *number) return std::nullopt;
  return number;
}

} // namespace

double Axis::at(double share) const {
  const double value = from + (to - from) * std::pow(share, power);
  return share >= 1 ? to : value;
}

Axis parse_axis(const std::string& text, const std::string& where) {
  const auto fail = [&] {
    throw InputError(where, "found \"" + echo(text) +
                                "\"; accepted: NAME=FROM:TO, with :NODES of 2 to 4096 and then :POWER of 1 to 8 if "
                                "wanted, as cos_theta_o=0:1:32 or alpha=0.01:1:32:2");
  };
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos || sign == 0) fail();
  Axis axis{text.substr(0, sign), 0, 1, 0, 0};
  const std::vector<std::string> parts = split(text.substr(sign + 1), ':');
  if (parts.size() < 2 || parts.size() > 4) fail();
  const bool is_angle = axis.variable == "theta_o" || axis.variable == "phi_o";
  const auto value = [&](const std::string& part) { return is_angle ? parse_angle(part) : parse_number(part); };
  const std::optional<double> from = value(parts[0]), to = value(parts[1]);
  if (!from || !to || !(*from < *to)) fail();
  axis.from = *from;
  axis.to = *to;
  if (parts.size() > 2) {
    const std::optional<double> nodes = whole(parts[2], 2, most_nodes);
    if (!nodes) fail();
    axis.nodes = static_cast<std::size_t>(*nodes);
  }
  if (parts.size() > 3) {
    const std::optional<double> power = whole(parts[3], 1, most_power);
    if (!power) fail();
    axis.power = static_cast<int>(*power);
  }
  return axis;
}

} // namespace brdfplot::bake
