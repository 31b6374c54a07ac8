#include "draw/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace brdfplot::plot {

namespace {

constexpr const char* minus_sign = "\xE2\x88\x92";

void append_hundredths(std::string& out, long long hundredths, bool leading_zero) {
  if (hundredths < 0) out += '-';
  const auto magnitude = hundredths < 0 ? -hundredths : hundredths;
  const auto whole = magnitude / 100;
  const auto part = static_cast<int>(magnitude % 100);
  if (whole != 0 || leading_zero || part == 0) out += std::to_string(whole);
  if (part == 0) return;
  out += '.';
  out += static_cast<char>('0' + part / 10);
  if (part % 10 != 0) out += static_cast<char>('0' + part % 10);
}

} // namespace

void append_fixed(std::string& out, double value) {
  append_hundredths(out, std::isfinite(value) ? std::llround(100 * std::clamp(value, -1e9, 1e9)) : 0, true);
}

void append_hundredths(std::string& out, long long hundredths) { append_hundredths(out, hundredths, false); }

std::string decimal_label(double value, int decimals) {
  std::array<char, 400> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value),
                                    std::chars_format::fixed, std::clamp(decimals, 0, 20));
  const std::string digits(buffer.data(), result.ptr);
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return value < 0 && !zero ? minus_sign + digits : digits;
}

std::string power_label(double value, int exponent, int decimals) {
  if (value == 0) return "0";
  std::string power = "10^{";
  power += decimal_label(exponent, 0);
  power += '}';
  // Two factors, because 10^exponent alone may be out of the range of double.
  const double half = std::pow(10.0, exponent / 2);
  const double mantissa = value / half / std::pow(10.0, exponent - exponent / 2);
  return decimal_label(mantissa, decimals) + "·" + power;
}

} // namespace brdfplot::plot
