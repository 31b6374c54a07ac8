/// \file
/// Numbers as text, independent of the locale: the shortest form that reads back to the same double.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace brdfplot {

/// Appends the shortest text that reads back to `value` (`nan`, `inf`, `-inf` included).
void append_number(std::string& out, double value);

std::string format_number(double value);

/// Reads all of `text` (surrounding blanks allowed) as a double; nothing when it is not one number.
/// `inf` and `nan` are read as such; out-of-range text gives the nearest double (0 or infinity).
std::optional<double> parse_number(std::string_view text);

/// Reads an angle in radians: a number, or one with a unit, "80deg", "80°" or "1.5rad". Nothing when it is none.
std::optional<double> parse_angle(std::string_view text);

} // namespace brdfplot
