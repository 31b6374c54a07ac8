#include "config/schema.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>

namespace brdfplot::config {

void expect(bool good, const Json& value, const std::string& pointer, const std::string& accepted) {
  if (!good) throw BadValue{pointer, "found " + show(value) + ", accepted: " + accepted};
}

std::string show(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  return shortened(value.dump(), 60);
}

std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::string one_line(const std::string& text) {
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

std::string step(const std::string& pointer, const std::string& key) {
  std::string out = pointer + "/";
  for (const char c : key) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return out;
}

} // namespace brdfplot::config
