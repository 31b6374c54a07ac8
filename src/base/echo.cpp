#include "base/echo.hpp"

#include <array>
#include <cstdio>

namespace brdfplot {

namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Just behind the character that starts at `begin`: at most four bytes.
std::size_t end_of_character(std::string_view text, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < text.size() && end < begin + 4 && continues(text[end])) ++end;
  return end;
}

} // namespace

std::string cut(std::string_view text, std::size_t most) {
  std::size_t end = 0;
  for (std::size_t count = 0; count < most && end < text.size(); ++count) end = end_of_character(text, end);
  if (end >= text.size()) return std::string(text);
  return std::string(text.substr(0, end)) + "… (" + std::to_string(text.size()) + " bytes)";
}

std::string one_line(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x20 && code != 0x7F) {
      out += c;
      continue;
    }
    std::array<char, 8> escape{};
    std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(code));
    out += c == '\n' ? "\\n" : c == '\t' ? "\\t" : escape.data();
  }
  return out;
}

std::string echo(std::string_view text, std::size_t most) { return one_line(cut(text, most)); }

} // namespace brdfplot
