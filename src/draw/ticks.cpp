#include "draw/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "draw/number_text.hpp"

namespace brdfplot::plot {

namespace {

constexpr double pi = std::numbers::pi;

/// Steps that divide a decade well.
constexpr std::array<double, 3> decimal_steps = {1, 2, 5};

/// The multiples of `step` in the range; a little beyond, because the ends are often multiples up to rounding.
std::vector<double> multiples(double step, const Range& range) {
  const double slack = 1e-6;
  const double first = std::ceil(range.from / step - slack);
  const double last = std::floor(range.to / step + slack);
  std::vector<double> values;
  for (double k = first; k <= last && values.size() < 1000; ++k) values.push_back(k * step);
  return values;
}

bool fits(double step, const Range& range, int most) {
  return std::floor(range.to / step + 1e-6) - std::ceil(range.from / step - 1e-6) + 1 <= most;
}

/// The smallest of 1, 2, 5 times a power of ten that makes at most `most` ticks.
double decimal_step(const Range& range, int most) {
  const int start = static_cast<int>(std::floor(std::log10((range.to - range.from) / most))) - 1;
  for (int exponent = start;; ++exponent) {
    for (const double factor : decimal_steps) {
      const double step = factor * std::pow(10.0, exponent);
      if (step > 0 && fits(step, range, most)) return step;
    }
  }
}

/// How many decimals tell multiples of the step apart.
int decimals_of(double step) {
  int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  const double scaled = step * std::pow(10.0, decimals);
  if (std::abs(scaled - std::round(scaled)) > 1e-6) ++decimals;
  return decimals;
}

Ticks decimal_ticks(const Range& range, int most) {
  const double step = decimal_step(range, most);
  const double magnitude = std::max(std::abs(range.from), std::abs(range.to));
  const bool plain = magnitude < 1e5 && magnitude >= 1e-2;
  const int exponent = static_cast<int>(std::floor(std::log10(magnitude) + 1e-9));
  const int decimals = decimals_of(plain ? step : step / std::pow(10.0, exponent));
  Ticks ticks;
  for (const double value : multiples(step, range)) {
    ticks.major.push_back({value, plain ? decimal_label(value, decimals) : power_label(value, exponent, decimals)});
  }
  return ticks;
}

Ticks degree_ticks(const Range& range, int most) {
  constexpr std::array<double, 8> steps = {1, 2, 5, 10, 15, 30, 45, 90};
  const double unit = pi / 180;
  const Range degrees{range.from / unit, range.to / unit};
  const auto found = std::find_if(steps.begin(), steps.end(), [&](double s) { return fits(s, degrees, most); });
  const bool small = fits(0.5, degrees, most); // less than a degree apart: decimals
  const double step = small ? decimal_step(degrees, most) : found == steps.end() ? 180.0 : *found;
  Ticks ticks;
  for (const double value : multiples(step, degrees)) {
    ticks.major.push_back({value * unit, decimal_label(value, decimals_of(step)) + "°"});
  }
  return ticks;
}

/// "3π/4": k parts of π / parts, in lowest terms.
std::string pi_label(int k, int parts) {
  if (k == 0) return "0";
  int divisor = std::abs(k);
  for (int rest = parts; rest != 0;) {
    const int next = divisor % rest;
    divisor = rest;
    rest = next;
  }
  const int top = std::abs(k) / divisor;
  const int bottom = parts / divisor;
  std::string label = k < 0 ? "−" : "";
  if (top != 1) label += std::to_string(top);
  label += "π";
  if (bottom != 1) label += "/" + std::to_string(bottom);
  return label;
}

/// Multiples of a fraction of π when the ends of the range are such; nothing when decimals read better.
std::optional<Ticks> pi_ticks(const Range& range, int most) {
  const double span = range.to - range.from;
  if (span < pi / 4 - 1e-9 || span > 16 * pi) return std::nullopt;
  for (const int parts : {12, 8, 6, 4, 2, 1}) {
    const double step = pi / parts;
    const auto off = [&](double end) { return std::abs(end / step - std::round(end / step)) * step; };
    if (!fits(step, range, most) || off(range.from) > 0.02 * span || off(range.to) > 0.02 * span) continue;
    Ticks ticks;
    for (const double value : multiples(step, range)) {
      ticks.major.push_back({value, pi_label(static_cast<int>(std::lround(value / step)), parts)});
    }
    return ticks;
  }
  return std::nullopt;
}

/// The powers of ten, every so many that at most `most` are labelled, with minor ticks between.
Ticks decade_ticks(const Range& range, int most) {
  const Range decades{std::log10(range.from), std::log10(range.to)};
  int every = 1;
  for (const int step : {1, 2, 3, 5, 10, 20, 50, 100}) {
    every = step;
    if (fits(step, decades, std::min(most, 9))) break;
  }
  Ticks ticks;
  for (const double exponent : multiples(every, decades)) {
    ticks.major.push_back({std::pow(10.0, exponent), "10^{" + decimal_label(exponent, 0) + "}"});
  }
  for (double e = std::floor(decades.from); e <= decades.to; ++e) {
    for (int digit = 1; digit < 10; ++digit) {
      const double value = digit * std::pow(10.0, e);
      const bool labelled = digit == 1 && std::fmod(e, every) == 0;
      const bool wanted = every == 1 ? decades.to - decades.from <= 6.5 : digit == 1;
      if (!labelled && wanted && value >= range.from && value <= range.to) ticks.minor.push_back(value);
    }
  }
  return ticks;
}

/// 1, 2 and 5 times the powers of ten, as plain decimals where that is short.
Ticks short_log_ticks(const Range& range) {
  Ticks ticks;
  const bool plain = range.from >= 9e-4 && range.to <= 1.1e5;
  for (double e = std::floor(std::log10(range.from)); e <= std::log10(range.to); ++e) {
    const int exponent = static_cast<int>(e);
    for (int digit = 1; digit < 10; ++digit) {
      const double value = digit * std::pow(10.0, e);
      if (value < range.from * (1 - 1e-9) || value > range.to * (1 + 1e-9)) continue;
      if (digit == 1 || digit == 2 || digit == 5) {
        ticks.major.push_back(
            {value, plain ? decimal_label(value, std::max(0, -exponent)) : power_label(value, exponent, 0)});
      } else {
        ticks.minor.push_back(value);
      }
    }
  }
  return ticks;
}

Ticks log_ticks(const Range& range, int most) {
  const double decades = std::log10(range.to / range.from);
  if (decades < 1.5) {
    auto ticks = short_log_ticks(range);
    const auto count = static_cast<int>(ticks.major.size());
    if (count >= 3 && count <= most) return ticks;
    if (count < 3) return decimal_ticks(range, most);
  }
  return decade_ticks(range, most);
}

} // namespace

Ticks make_ticks(const Axis& axis, const Range& range, int most) {
  const int count = std::max(most, 2);
  if (axis.scale == Scale::logarithmic) return log_ticks(range, count);
  if (axis.unit == Unit::degrees) return degree_ticks(range, count);
  if (axis.unit == Unit::radians) {
    if (auto ticks = pi_ticks(range, count)) return *ticks;
  }
  return decimal_ticks(range, count);
}

double place_in(const Range& range, Scale scale, double value) {
  if (!std::isfinite(value)) return automatic;
  if (scale == Scale::linear) return (value - range.from) / (range.to - range.from);
  if (value <= 0) return automatic;
  return std::log(value / range.from) / std::log(range.to / range.from);
}

} // namespace brdfplot::plot
