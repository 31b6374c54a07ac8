#include "base/number.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <numbers>

namespace brdfplot {

void append_number(std::string& out, double value) {
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  out.append(buffer.data(), result.ptr);
}

std::string format_number(double value) {
  std::string out;
  append_number(out, value);
  return out;
}

std::optional<double> parse_number(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return std::nullopt;
  text = text.substr(first, text.find_last_not_of(blank) - first + 1);
  if (text.size() > 1 && text.front() == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return std::strtod(std::string(text).c_str(), nullptr);
  if (error != std::errc()) return std::nullopt;
  return value;
}

std::optional<double> parse_angle(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  if (text.ends_with("rad")) return parse_number(text.substr(0, text.size() - 3));
  const std::string_view unit = text.ends_with("deg") ? "deg" : text.ends_with("°") ? "°" : "";
  if (unit.empty()) return parse_number(text);
  const auto degrees = parse_number(text.substr(0, text.size() - unit.size()));
  if (!degrees) return std::nullopt;
  return *degrees / 180 * std::numbers::pi;
}

} // namespace brdfplot
