#include "math/echo.hpp"

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

std::string echo(std::string_view text, std::size_t most) {
  std::size_t end = 0;
  for (std::size_t count = 0; count < most && end < text.size(); ++count) end = end_of_character(text, end);
  if (end >= text.size()) return std::string(text);
  return std::string(text.substr(0, end)) + "… (" + std::to_string(text.size()) + " bytes)";
}

} // namespace brdfplot
