/// \file
/// Round numbers for axes: ranges that end well and ticks that read well.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "draw/model.hpp"

namespace brdfplot::plot {

/// An interval of an axis in the units of the model; `from < to` in what the functions below return.
struct Range {
  double from = 0;
  double to = 1;
  bool operator==(const Range&) const = default;
};

/// The smallest interval that holds some data; `empty` until something was added.
class Extent {
public:
  /// Takes what the scale can show: finite values, and for a logarithmic scale positive ones.
  void add(std::span<const double> values, Scale scale);
  void add(const Extent& other);

  [[nodiscard]] bool empty() const { return !(from_ <= to_); }
  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }

private:
  double from_ = std::numeric_limits<double>::infinity();
  double to_ = -std::numeric_limits<double>::infinity();
};

struct Tick {
  double value = 0;
  std::string label; ///< with markup
};

struct Ticks {
  std::vector<Tick> major;
  std::vector<double> minor;
};

/// The range of a swept variable: exactly the data, or the round number that is nearly there (90° for 89.9°).
Range swept_range(const Axis& axis, const Extent& data);

/// The range of a value: the data with a little air, from zero when the data come near it; constant data stand in the
/// middle. Bounds that the axis sets are kept. On a logarithmic axis values more than 20 decades below the largest do
/// not count.
Range value_range(const Axis& axis, const Extent& data);

/// The range of a radius: from zero to a round number that the data do not exceed, with at most `most_rings` round
/// steps between (five at least).
Range radius_range(const Axis& axis, const Extent& data, int most_rings);

/// The range of a colour bar: exactly the data, a little wider when they are constant.
Range colour_range(const Axis& axis, const Extent& data);

/// Ticks at round numbers within the range, at most about `most` of them labelled.
Ticks make_ticks(const Axis& axis, const Range& range, int most);

/// The place of a value in its range: 0 at `from`, 1 at `to`. NaN where a logarithmic scale shows nothing.
double place_in(const Range& range, Scale scale, double value);

} // namespace brdfplot::plot
