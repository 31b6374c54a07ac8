#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/ticks.hpp"

namespace brdfplot::plot {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The closest the bounds of an axis may come, relative to their size: below, doubles hardly tell ticks apart.
constexpr double constant_span = 1e-9;

/// Beyond these magnitudes the arithmetic of ranges would overflow or lose all its digits.
constexpr double largest = 1e300;
constexpr double smallest = 1e-290;

bool is_constant(double from, double to) {
  return to - from <= std::max(constant_span * std::max(std::abs(from), std::abs(to)), smallest);
}

/// A range about a single value, in which the value stands in the middle.
Range about(double value, Scale scale) {
  if (scale == Scale::logarithmic) return {std::max(value, smallest) / 10, std::max(value, smallest) * 10};
  const double half = std::abs(value) < smallest ? 0.5 : std::abs(value) / 2;
  return {value - half, value + half};
}

/// What to show when there are no data.
Range without_data(const Axis& axis) {
  if (axis.scale == Scale::logarithmic) return {0.1, 1};
  return axis.unit == Unit::none ? Range{0, 1} : Range{0, 90 * degree};
}

/// Puts the bounds that the axis sets in place of the automatic ones, and makes sure that the range is one.
Range with_bounds(const Axis& axis, Range range) {
  const bool logarithmic = axis.scale == Scale::logarithmic;
  const bool set_from = std::isfinite(axis.from) && (!logarithmic || axis.from > 0);
  const bool set_to = std::isfinite(axis.to) && (!logarithmic || axis.to > 0);
  if (set_from) range.from = std::clamp(axis.from, -largest, largest);
  if (set_to) range.to = std::clamp(axis.to, -largest, largest);
  if (range.from > range.to && set_from && set_to) std::swap(range.from, range.to);
  if (range.from < range.to && !is_constant(range.from, range.to)) return range;
  if (set_from && !set_to) return {range.from, about(range.from, axis.scale).to};
  if (set_to && !set_from) return {about(range.to, axis.scale).from, range.to};
  return about(range.from, axis.scale);
}

/// A round number within `slack` of the bound, or the bound itself.
double snap(double bound, double step, double slack) {
  const double round = std::round(bound / step) * step;
  return std::abs(round - bound) <= slack ? round : bound;
}

/// The distance of the ticks that the range will have, about; for angles a step that suits degrees and parts of π.
double tick_step(const Axis& axis, double span) {
  if (axis.unit != Unit::none && span > 20 * degree) return 15 * degree;
  const double unit = axis.unit == Unit::degrees ? degree : 1;
  const double raw = span / unit / 5;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  return (raw < 2 * power ? power : raw < 5 * power ? 2 * power : 5 * power) * unit;
}

/// Moves the end of a logarithmic range outward (by the sign of `direction`): to the decade when it is near, but never
/// so that data lie on the frame.
double widen_log(double bound, int direction, double decades) {
  const double exponent = std::log10(bound);
  const double margin = std::max(0.03 * decades, 0.02);
  const double decade = direction < 0 ? std::floor(exponent - 1e-9) : std::ceil(exponent + 1e-9);
  const double gap = std::abs(decade - exponent);
  if (gap >= margin && (gap < 0.35 || decades > 8)) return std::pow(10.0, decade);
  return std::pow(10.0, exponent + direction * margin);
}

Range log_range(double from, double to) {
  from = std::max({from, to * 1e-20, smallest});
  const double decades = std::log10(to / from);
  return {widen_log(from, -1, decades), widen_log(to, 1, decades)};
}

Range linear_range(const Axis& axis, double from, double to) {
  const bool positive = from >= 0;
  const bool negative = to <= 0;
  if (positive && from <= 0.35 * to) from = 0;
  if (negative && to >= 0.35 * from) to = 0;
  const double span = to - from;
  const double step = tick_step(axis, span);
  const double margin = 0.04 * span;
  const double low = positive && from == 0 ? 0 : snap(from - margin, step, margin * 0.999);
  const double high = negative && to == 0 ? 0 : snap(to + margin, step, margin * 0.999);
  return {low, high};
}

} // namespace

void Extent::add(std::span<const double> values, Scale scale) {
  for (const double value : values) {
    if (!std::isfinite(value) || (scale == Scale::logarithmic && value <= 0)) continue;
    from_ = std::min(from_, std::clamp(value, -largest, largest));
    to_ = std::max(to_, std::clamp(value, -largest, largest));
  }
}

void Extent::add(const Extent& other) {
  from_ = std::min(from_, other.from_);
  to_ = std::max(to_, other.to_);
}

Range swept_range(const Axis& axis, const Extent& data) {
  if (data.empty()) return with_bounds(axis, without_data(axis));
  if (is_constant(data.from(), data.to())) return with_bounds(axis, about(data.from(), axis.scale));
  if (axis.scale == Scale::logarithmic) return with_bounds(axis, {data.from(), data.to()});
  const double span = data.to() - data.from();
  const double step = tick_step(axis, span);
  return with_bounds(axis, {snap(data.from(), step, 0.01 * span), snap(data.to(), step, 0.01 * span)});
}

Range value_range(const Axis& axis, const Extent& data) {
  if (data.empty()) return with_bounds(axis, without_data(axis));
  if (is_constant(data.from(), data.to())) return with_bounds(axis, about(data.to(), axis.scale));
  if (axis.scale == Scale::logarithmic) return with_bounds(axis, log_range(data.from(), data.to()));
  return with_bounds(axis, linear_range(axis, data.from(), data.to()));
}

Range radius_range(const Axis& axis, const Extent& data, int most_rings) {
  if (axis.scale == Scale::logarithmic) {
    if (data.empty()) return with_bounds(axis, {0.01, 1});
    const double to = std::pow(10.0, std::ceil(std::log10(data.to()) - 1e-9));
    const double decade = std::pow(10.0, std::floor(std::log10(std::max(data.from(), to * 1e-5)) + 1e-9));
    return with_bounds(axis, {std::min(decade, to / 10), to});
  }
  const double most = data.empty() || data.to() <= 0 ? 1 : data.to();
  // The round number that leaves the least of the disc unused, with three rings or more.
  double best = std::numeric_limits<double>::infinity();
  const double power = std::pow(10.0, std::floor(std::log10(most)) - 1);
  for (const double step : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    const double rings = std::ceil(most / (step * power) - 1e-6);
    if (rings >= 3 && rings <= std::max(most_rings, 5)) best = std::min(best, rings * step * power);
  }
  return with_bounds(axis, {0, best});
}

Range colour_range(const Axis& axis, const Extent& data) {
  if (data.empty()) return with_bounds(axis, without_data(axis));
  if (is_constant(data.from(), data.to())) return with_bounds(axis, about(data.to(), axis.scale));
  Range range{data.from(), data.to()};
  if (axis.scale == Scale::logarithmic) range.from = std::max(range.from, range.to * 1e-20);
  return with_bounds(axis, range);
}

} // namespace brdfplot::plot
