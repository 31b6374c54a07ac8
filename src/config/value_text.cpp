#include "config/schema.hpp"

#include "base/echo.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>

namespace brdfplot::config {

void expect(bool good, const Json& value, const std::string& pointer, const std::string& accepted) {
  if (!good) throw BadValue{pointer, "found " + show(value) + ", accepted: " + accepted};
}

std::string show(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  if (value.is_string()) return Json(cut(value.get_ref<const std::string&>())).dump();
  return shortened(value.dump(), 60);
}

std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::string show_pointer(const std::string& pointer) {
  std::string out;
  for (std::size_t begin = 0; begin < pointer.size();) {
    const std::size_t end = std::min(pointer.find('/', begin + 1), pointer.size());
    out += echo(std::string_view(pointer).substr(begin, end - begin));
    begin = end;
  }
  return cut(out, 600);
}

std::string step(const std::string& pointer, const std::string& key) {
  std::string out = pointer + "/";
  for (const char c : key) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return out;
}

} // namespace brdfplot::config
